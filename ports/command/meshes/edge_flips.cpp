#include "edge_flips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

namespace discmc::command {
namespace {

using Corners = std::vector<std::uint32_t>;

constexpr double largest_move = 0.1;  // of the surface, in lengths of the edge
constexpr double least_gain = 1e-6;   // of a cosine, so that rounding does not count

std::uint64_t undirected(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

class EdgeFlips {
 public:
  EdgeFlips(const std::vector<Point>& vertices, Corners& corners, std::size_t first)
      : vertices_(vertices), corners_(corners), first_(3 * first) {
    pair_sides();
  }

  void run() {
    for (std::size_t side = first_; side < corners_.size(); ++side) waiting_.push_back(side);
    while (!waiting_.empty()) {
      const std::size_t side = waiting_.back();
      waiting_.pop_back();
      if (is_better_flipped(side)) flip(side);
    }
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  static std::size_t next(std::size_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static std::size_t previous(std::size_t side) { return side % 3 == 0 ? side + 2 : side - 1; }

  // Side 3 f + i of triangle f runs from its corner i to the next.
  void pair_sides() {
    struct Side {
      std::uint64_t edge;
      std::size_t side;
    };
    std::vector<Side> sides;
    sides.reserve(corners_.size());
    for (std::size_t side = 0; side < corners_.size(); ++side)
      sides.push_back({undirected(corners_[side], corners_[next(side)]), side});
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.edge < b.edge; });
    across_.assign(corners_.size(), none);
    edges_.reserve(corners_.size() / 2);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while (end < sides.size() && sides[end].edge == sides[begin].edge) ++end;
      edges_.insert(sides[begin].edge);
      if (end - begin != 2) continue;
      const std::size_t a = sides[begin].side, b = sides[begin + 1].side;
      if (a < first_ || b < first_ || corners_[a] == corners_[b]) continue;
      across_[a] = b;
      across_[b] = a;
    }
  }

  const Point& at(std::uint32_t vertex) const { return vertices_[vertex]; }

  // The largest of a triangle is that of its least angle.
  double largest_cosine(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Point ab = difference(at(b), at(a)), bc = difference(at(c), at(b)),
                ca = difference(at(a), at(c));
    const double l = dot(ab, ab), m = dot(bc, bc), n = dot(ca, ca);
    if (!(l > 0) || !(m > 0) || !(n > 0)) return 1;
    return std::max({-dot(ab, ca) / std::sqrt(l * n), -dot(ab, bc) / std::sqrt(l * m),
                     -dot(bc, ca) / std::sqrt(m * n)});
  }

  Point doubled_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return cross(difference(at(b), at(a)), difference(at(c), at(a)));
  }

  // a, b: the ends of the edge; c, d: opposite in its triangle, and in that across.
  bool is_better_flipped(std::size_t side) const {
    const std::size_t other = across_[side];
    if (other == none) return false;
    const std::uint32_t a = corners_[side], b = corners_[other];
    const std::uint32_t c = corners_[previous(side)], d = corners_[previous(other)];
    if (c == d || edges_.count(undirected(c, d)) > 0) return false;
    const double now = std::max(largest_cosine(a, b, c), largest_cosine(b, a, d));
    const double then = std::max(largest_cosine(a, d, c), largest_cosine(d, b, c));
    return then < now - least_gain && keeps_shape(a, b, c, d);
  }

  bool keeps_shape(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const Point before = sum(doubled_area(a, b, c), doubled_area(b, a, d));
    if (dot(before, doubled_area(a, d, c)) <= 0 || dot(before, doubled_area(d, b, c)) <= 0)
      return false;
    const Point edge = difference(at(b), at(a)), flipped = difference(at(d), at(c));
    const Point across = cross(edge, flipped);
    const double apart = std::abs(dot(unit_or_zero(across), difference(at(c), at(a))));
    return apart <= largest_move * std::sqrt(std::min(dot(edge, edge), dot(flipped, flipped)));
  }

  static Point sum(const Point& a, const Point& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }

  // Triangles (a, b, c) and (b, a, d) become (c, a, d) and (d, b, c), whose first side is old.
  void flip(std::size_t side) {
    const std::size_t other = across_[side];
    const std::uint32_t a = corners_[side], b = corners_[other];
    const std::uint32_t c = corners_[previous(side)], d = corners_[previous(other)];
    const std::array<std::size_t, 4> outside = {across_[previous(side)], across_[next(other)],
                                                across_[previous(other)], across_[next(side)]};
    const std::size_t first = side - side % 3, second = other - other % 3;
    set(first, c, a, d);
    set(second, d, b, c);
    pair(first, outside[0]);
    pair(first + 1, outside[1]);
    pair(first + 2, second + 2);
    pair(second, outside[2]);
    pair(second + 1, outside[3]);
    edges_.erase(undirected(a, b));
    edges_.insert(undirected(c, d));
    waiting_.insert(waiting_.end(), {first, first + 1, second, second + 1});
  }

  void set(std::size_t first, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    corners_[first] = a;
    corners_[first + 1] = b;
    corners_[first + 2] = c;
  }

  void pair(std::size_t side, std::size_t other) {
    across_[side] = other;
    if (other != none) across_[other] = side;
  }

  const std::vector<Point>& vertices_;
  Corners& corners_;
  std::size_t first_;
  std::vector<std::size_t> across_;  // sides that run the other way
  std::unordered_set<std::uint64_t> edges_;
  std::vector<std::size_t> waiting_;
};

}  // namespace

void flip_edges(const std::vector<Point>& vertices, Corners& corners, std::size_t first) {
  EdgeFlips(vertices, corners, first).run();
}

}  // namespace discmc::command
