#include "collapsing_mesh.hpp"

#include <algorithm>
#include <utility>

#include "surface/sets.hpp"

namespace discmc::meshing {

CollapsingMesh::CollapsingMesh(std::vector<Point> points, std::vector<Triangle> triangles)
    : points_(std::move(points)),
      triangles_(std::move(triangles)),
      triangle_count_(triangles_.size()),
      first_corner_(points_.size(), none),
      next_corner_(3 * triangles_.size()),
      kind_(points_.size(), Kind::inner),
      mark_(points_.size()) {
  for (std::uint32_t corner = 0; corner < next_corner_.size(); ++corner)
    link(triangles_[corner / 3][corner % 3], corner);
  classify_vertices();
  number_bodies();
}

void CollapsingMesh::classify_vertices() {
  std::vector<Spoke> spokes;
  for (std::uint32_t vertex = 0; vertex < vertex_slots(); ++vertex)
    if (has_vertex(vertex)) kind_[vertex] = kind_of(vertex, spokes);
}

// Follows the triangles around a vertex from one neighbour to the next.
CollapsingMesh::Kind CollapsingMesh::kind_of(std::uint32_t vertex,
                                             std::vector<Spoke>& spokes) const {
  spokes.clear();
  for_each_triangle(vertex, [&](std::uint32_t triangle, std::uint32_t corner) {
    spokes.push_back(
        {triangles_[triangle][(corner + 1) % 3], triangles_[triangle][(corner + 2) % 3]});
  });
  const auto leading_from = [&](std::uint32_t neighbour) {
    return std::find_if(spokes.begin(), spokes.end(),
                        [&](const Spoke& spoke) { return spoke.from == neighbour; });
  };
  // An open fan begins at the neighbour that no triangle leads to.
  std::uint32_t begin = spokes[0].from;
  for (const Spoke& spoke : spokes)
    if (std::none_of(spokes.begin(), spokes.end(),
                     [&](const Spoke& other) { return other.to == spoke.from; }))
      begin = spoke.from;

  std::uint32_t at = begin;
  std::size_t followed = 0;
  do {
    const auto spoke = leading_from(at);
    if (spoke == spokes.end()) break;
    at = spoke->to;
    ++followed;
  } while (at != begin && followed < spokes.size());
  if (followed < spokes.size()) return Kind::fixed;
  if (at == begin) return Kind::inner;
  return leading_from(at) == spokes.end() ? Kind::border : Kind::fixed;
}

void CollapsingMesh::number_bodies() {
  Sets bodies(points_.size());
  for (const Triangle& triangle : triangles_) {
    bodies.join(triangle[0], triangle[1]);
    bodies.join(triangle[1], triangle[2]);
  }
  body_.reserve(points_.size());
  for (std::uint32_t vertex = 0; vertex < vertex_slots(); ++vertex)
    body_.push_back(bodies.root(vertex));
}

unsigned CollapsingMesh::count_triangles(std::uint32_t a, std::uint32_t b) const {
  unsigned count = 0;
  for_each_triangle(a, [&](std::uint32_t triangle, std::uint32_t) {
    const Triangle& vertices = triangles_[triangle];
    count += vertices[0] == b || vertices[1] == b || vertices[2] == b;
  });
  return count;
}

void CollapsingMesh::describe(std::uint32_t kept, std::uint32_t gone, const Point& at,
                              Collapse& collapse) const {
  collapse.kept = kept;
  collapse.gone = gone;
  collapse.at = at;
  collapse.removed.clear();
  collapse.moved.clear();
  const auto add = [&](std::uint32_t triangle, std::uint32_t corner, std::uint32_t other) {
    const Triangle& vertices = triangles_[triangle];
    if (vertices[0] == other || vertices[1] == other || vertices[2] == other) {
      if (other == gone) collapse.removed.push_back(triangle);
      return;
    }
    Collapse::Moved moved{triangle, vertices, corners(triangle), {}};
    moved.after = moved.before;
    moved.numbers[corner] = kept;
    moved.after[corner] = at;
    collapse.moved.push_back(moved);
  };
  for_each_triangle(kept, [&](std::uint32_t t, std::uint32_t corner) { add(t, corner, gone); });
  for_each_triangle(gone, [&](std::uint32_t t, std::uint32_t corner) { add(t, corner, kept); });
}

bool CollapsingMesh::keeps_topology(const Collapse& collapse) {
  const std::uint32_t kept = collapse.kept, gone = collapse.gone;
  const std::uint32_t kept_mark = ++last_mark_, common_mark = ++last_mark_;
  unsigned common = 0, around_kept = 0, around_gone = 0;
  for_each_triangle(kept, [&](std::uint32_t triangle, std::uint32_t) {
    ++around_kept;
    for (const std::uint32_t vertex : triangles_[triangle]) mark_[vertex] = kept_mark;
  });
  for_each_triangle(gone, [&](std::uint32_t triangle, std::uint32_t) {
    ++around_gone;
    for (const std::uint32_t vertex : triangles_[triangle]) {
      if (vertex == kept || vertex == gone || mark_[vertex] != kept_mark) continue;
      mark_[vertex] = common_mark;
      ++common;
    }
  });
  const std::size_t removed = collapse.removed.size();
  if (removed == 0 || removed > 2 || common != removed) return false;
  if (removed == 1) return around_kept > 1 && around_gone > 1 && around_kept + around_gone > 3;
  const bool is_tetrahedron = around_kept == 3 && around_gone == 3;
  return !is_tetrahedron && !(is_border(kept) && is_border(gone));
}

void CollapsingMesh::carry_out(const Collapse& collapse) {
  for (const std::uint32_t triangle : collapse.removed) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = triangles_[triangle][corner];
      if (vertex != collapse.kept && vertex != collapse.gone) unlink(vertex, 3 * triangle + corner);
    }
    triangles_[triangle][0] = none;
  }
  triangle_count_ -= collapse.removed.size();
  points_[collapse.kept] = collapse.at;
  if (is_border(collapse.gone)) kind_[collapse.kept] = Kind::border;

  first_corner_[collapse.gone] = first_corner_[collapse.kept] = none;
  for (const Collapse::Moved& moved : collapse.moved) {
    triangles_[moved.triangle] = moved.numbers;
    const auto corner = static_cast<std::uint32_t>(
        std::find(moved.numbers.begin(), moved.numbers.end(), collapse.kept) -
        moved.numbers.begin());
    link(collapse.kept, 3 * moved.triangle + corner);
  }
}

// Adds a corner to the ring of a vertex.
void CollapsingMesh::link(std::uint32_t vertex, std::uint32_t corner) {
  std::uint32_t& first = first_corner_[vertex];
  if (first == none) first = next_corner_[corner] = corner;
  next_corner_[corner] = std::exchange(next_corner_[first], corner);
}

void CollapsingMesh::unlink(std::uint32_t vertex, std::uint32_t corner) {
  std::uint32_t before = corner;
  while (next_corner_[before] != corner) before = next_corner_[before];
  next_corner_[before] = next_corner_[corner];
  first_corner_[vertex] = before == corner ? none : before;
}

}  // namespace discmc::meshing
