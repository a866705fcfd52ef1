#include "triangulator.hpp"

#include <algorithm>

namespace discmc::meshing {
namespace {

// Compares along a direction that differs from all usual sides on a lattice. Otherwise the sweep
// would meet many points at once, and make long fans that cost many flips.
bool is_left_of(const PlanePoint& a, const PlanePoint& b) {
  const std::int64_t distance = 5 * (b.u - a.u) + 2 * (b.v - a.v);
  return distance != 0 ? distance > 0 : a.v < b.v;
}

bool are_in_range(const std::vector<PlanePoint>& points) {
  return std::all_of(points.begin(), points.end(), [](const PlanePoint& point) {
    return std::max(point.u, point.v) <= max_plane_coordinate &&
           std::min(point.u, point.v) >= -max_plane_coordinate;
  });
}

}  // namespace

const std::vector<Triangle>& Triangulator::triangulate(
    const std::vector<PlanePoint>& points, const std::vector<std::uint32_t>& ring_ends) {
  const bool is_valid = points.size() >= 3 && are_in_range(points);
  if (is_valid && ring_ends.size() == 1) {
    if (cut_small(points)) return triangles_;
    if (ears_.cut(points, triangles_, pairs_)) {
      flips_.improve(points, triangles_, pairs_);
      return triangles_;
    }
  }
  triangles_.clear();
  if (is_valid) sweep(points, ring_ends);
  return triangles_;
}

// Cuts three or four corners, which most polygons of a surface have, along either diagonal:
// Delaunay's if both are inside.
bool Triangulator::cut_small(const std::vector<PlanePoint>& points) {
  const auto is_triangle = [&points](std::size_t a, std::size_t b, std::size_t c) {
    return doubled_area(points[a], points[b], points[c]) > 0;
  };
  if (points.size() == 3 && is_triangle(0, 1, 2)) {
    triangles_.resize(1);
    triangles_[0] = {0, 1, 2};
    return true;
  }
  if (points.size() != 4) return false;
  const bool is_first = is_triangle(0, 1, 2) && is_triangle(0, 2, 3);
  const bool is_second = is_triangle(0, 1, 3) && is_triangle(1, 2, 3);
  if (!is_first && !is_second) return false;
  triangles_.resize(2);
  if (is_first && !(is_second && is_in_circle(points[2], points[0], points[1], points[3]))) {
    triangles_[0] = {0, 1, 2};
    triangles_[1] = {0, 2, 3};
  } else {
    triangles_[0] = {0, 1, 3};
    triangles_[1] = {1, 2, 3};
  }
  return true;
}

void Triangulator::sweep(const std::vector<PlanePoint>& points,
                         const std::vector<std::uint32_t>& ring_ends) {
  sort_points(points);
  if (!add_edges(ring_ends) || !pass_all()) return triangles_.clear();
  flips_.improve(at_, triangles_);
  for (Triangle& triangle : triangles_)
    for (std::uint32_t& corner : triangle) corner = indexes_[corner];
}

void Triangulator::sort_points(const std::vector<PlanePoint>& points) {
  located_.clear();
  for (std::uint32_t index = 0; index < points.size(); ++index)
    located_.push_back({points[index], index});
  std::sort(located_.begin(), located_.end(),
            [](const Located& a, const Located& b) { return is_left_of(a.point, b.point); });
  ranks_.resize(points.size());
  at_.clear();
  indexes_.clear();
  for (const Located& located : located_) {
    if (at_.empty() || is_left_of(at_.back(), located.point)) {
      at_.push_back(located.point);
      indexes_.push_back(located.index);
    }
    ranks_[located.index] = static_cast<Rank>(at_.size() - 1);
  }
}

bool Triangulator::add_edges(const std::vector<std::uint32_t>& ring_ends) {
  // A ring has its inside on the left, so above an edge that goes from left to right.
  edges_.clear();
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ring_ends) {
    if (end - begin < 3) return false;
    for (std::uint32_t i = begin; i < end; ++i) {
      const Rank from = ranks_[i], to = ranks_[i + 1 < end ? i + 1 : begin];
      if (from == to) return false;
      edges_.push_back({std::min(from, to), std::max(from, to), from < to});
    }
    begin = end;
  }
  std::sort(edges_.begin(), edges_.end(),
            [](const Edge& a, const Edge& b) { return a.left < b.left; });
  edges_begin_.assign(at_.size() + 1, 0);
  for (const Edge& edge : edges_) ++edges_begin_[edge.left + 1];
  for (std::size_t i = 1; i < edges_begin_.size(); ++i) edges_begin_[i] += edges_begin_[i - 1];
  return true;
}

bool Triangulator::pass_all() {
  nodes_.clear();
  active_.clear();
  for (Rank point = 0; point < at_.size(); ++point)
    if (!pass(point)) return false;
  return !triangles_.empty();
}

// Floors and ceilings alternate from bottom to top; floors have even indexes. Edges that end in the
// point are removed. Continuing edges begin at a chain whose rightmost point this is.
bool Triangulator::pass(Rank point) {
  // Finds the edges that end in the point or lead through it.
  const auto side_of = [&](const ActiveEdge& active) {
    return doubled_area(at_[active.edge.left], at_[active.edge.right], at_[point]);
  };
  const auto first =
      std::partition_point(active_.begin(), active_.end(),
                           [&](const ActiveEdge& active) { return side_of(active) > 0; });
  const auto last = std::find_if(first, active_.end(),
                                 [&](const ActiveEdge& active) { return side_of(active) < 0; });
  const auto begin = static_cast<std::size_t>(first - active_.begin());
  const auto end = static_cast<std::size_t>(last - active_.begin());
  if (!collect_leaving(point, begin, end)) return false;

  const bool is_inside_below = begin % 2 == 1, is_inside_above = end % 2 == 1;
  Chain lower{}, upper{};
  if (is_inside_below) lower = active_[begin - 1].chain;
  if (is_inside_above) upper = begin == end ? split_off_upper(lower) : active_[end - 1].chain;
  for (std::size_t i = begin + begin % 2; i + 1 < end; i += 2) close(active_[i].chain, point);
  if (is_inside_below) add_on_top(lower, point);
  if (is_inside_above) add_at_bottom(upper, point);
  if (is_inside_below && leaving_.empty()) lower = joined(lower, upper);
  if (is_inside_below) active_[begin - 1].chain = lower;

  const std::size_t new_end = begin + leaving_.size();
  const auto at = [&](std::size_t index) {
    return active_.begin() + static_cast<std::ptrdiff_t>(index);
  };
  if (new_end < end) active_.erase(at(new_end), at(end));
  if (new_end > end) active_.insert(at(end), new_end - end, ActiveEdge{});
  for (std::size_t i = begin; i < new_end; ++i) {
    active_[i].edge = leaving_[i - begin];
    if (i % 2 != 0) continue;
    if (i + 1 == new_end) {
      active_[i].chain = upper;
    } else {
      const std::uint32_t node = new_node(point);
      active_[i].chain = {node, node, node};
    }
  }
  return (begin == 0 || are_in_order(begin - 1)) && (new_end == begin || are_in_order(new_end - 1));
}

bool Triangulator::collect_leaving(Rank point, std::size_t begin, std::size_t end) {
  leaving_.assign(edges_.begin() + edges_begin_[point], edges_.begin() + edges_begin_[point + 1]);
  for (std::size_t i = begin; i < end; ++i)
    if (active_[i].edge.right != point)
      leaving_.push_back({point, active_[i].edge.right, active_[i].edge.is_floor});
  const auto turn = [&](const Edge& a, const Edge& b) {
    return doubled_area(at_[point], at_[a.right], at_[b.right]);
  };
  std::sort(leaving_.begin(), leaving_.end(),
            [&](const Edge& a, const Edge& b) { return turn(a, b) > 0; });
  for (std::size_t i = 0; i < leaving_.size(); ++i) {
    const bool share_a_stretch = i > 0 && turn(leaving_[i - 1], leaving_[i]) == 0;
    if (share_a_stretch || leaving_[i].is_floor != ((begin + i) % 2 == 0)) return false;
  }
  return true;
}

// New neighbours must not cross. Checking every new pair finds the leftmost crossing.
bool Triangulator::are_in_order(std::size_t lower) const {
  if (lower + 1 == active_.size()) return true;
  const Edge &a = active_[lower].edge, &b = active_[lower + 1].edge;
  return a.right < b.right ? doubled_area(at_[b.left], at_[b.right], at_[a.right]) <= 0
                           : doubled_area(at_[a.left], at_[a.right], at_[b.right]) >= 0;
}

std::uint32_t Triangulator::new_node(Rank point) {
  nodes_.push_back({point, 0, 0});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

bool Triangulator::cut(Rank a, Rank b, Rank c) {
  if (doubled_area(at_[a], at_[b], at_[c]) <= 0) return false;
  triangles_.push_back({a, b, c});
  return true;
}

void Triangulator::add_on_top(Chain& chain, Rank point) {
  for (; chain.top != chain.bottom; chain.top = nodes_[chain.top].below)
    if (!cut(point, nodes_[chain.top].point, nodes_[nodes_[chain.top].below].point)) break;
  const std::uint32_t node = new_node(point);
  nodes_[node].below = chain.top;
  nodes_[chain.top].above = node;
  chain.top = chain.rightmost = node;
}

void Triangulator::add_at_bottom(Chain& chain, Rank point) {
  for (; chain.bottom != chain.top; chain.bottom = nodes_[chain.bottom].above)
    if (!cut(point, nodes_[nodes_[chain.bottom].above].point, nodes_[chain.bottom].point)) break;
  const std::uint32_t node = new_node(point);
  nodes_[node].above = chain.bottom;
  nodes_[chain.bottom].below = node;
  chain.bottom = chain.rightmost = node;
}

// If the two edges meet, all points left between them see the meeting point.
void Triangulator::close(Chain chain, Rank point) {
  for (; chain.bottom != chain.top; chain.bottom = nodes_[chain.bottom].above)
    cut(point, nodes_[nodes_[chain.bottom].above].point, nodes_[chain.bottom].point);
}

// A point inside sees the rightmost point of the chain, so both parts keep that point.
Triangulator::Chain Triangulator::split_off_upper(Chain& chain) {
  const std::uint32_t node = new_node(nodes_[chain.rightmost].point);
  Chain upper{node, node, node};
  if (chain.rightmost != chain.top) {
    const std::uint32_t above = nodes_[chain.rightmost].above;
    nodes_[node].above = above;
    nodes_[above].below = node;
    upper.top = chain.top;
  }
  chain.top = chain.rightmost;
  return upper;
}

// Both chains end in the same point.
Triangulator::Chain Triangulator::joined(const Chain& lower, const Chain& upper) {
  const std::uint32_t above = nodes_[upper.bottom].above;
  nodes_[lower.top].above = above;
  nodes_[above].below = lower.top;
  return {lower.bottom, upper.top, lower.top};
}

}  // namespace discmc::meshing
