#include "triangulate.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace discmc::host {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

// The kernel's predicates are exact, and nothing is constructed: constraints only meet in points.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

enum class Side : unsigned char { unknown, outside, inside };

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<Side, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Located = std::pair<Kernel::Point_2, std::uint32_t>;

std::int64_t doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

std::int64_t doubled_area(const std::vector<PlanePoint>& points, const Rings& rings) {
  std::int64_t sum = 0;
  for (const auto& ring : rings)
    for (std::size_t i = 2; i < ring.size(); ++i)
      sum += doubled_area(points[ring[0]], points[ring[i - 1]], points[ring[i]]);
  return sum;
}

// A longer ring is rarely convex, and a fan makes slivers of it.
constexpr std::size_t max_fan = 8;

bool strictly_convex(const std::vector<PlanePoint>& points,
                     const std::vector<std::uint32_t>& ring) {
  const std::size_t count = ring.size();
  int descents = 0;  // a ring that winds once changes from rising to falling once
  for (std::size_t i = 0; i < count; ++i) {
    const PlanePoint& a = points[ring[i]];
    const PlanePoint& b = points[ring[(i + 1) % count]];
    const PlanePoint& c = points[ring[(i + 2) % count]];
    if (doubled_area(a, b, c) <= 0) return false;
    const bool rises = b.v > a.v || (b.v == a.v && b.u > a.u);
    const bool falls = c.v < b.v || (c.v == b.v && c.u < b.u);
    if (rises && falls) ++descents;
  }
  return descents == 1;
}

std::vector<Triangle> fan(const std::vector<std::uint32_t>& ring) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 2; i < ring.size(); ++i)
    triangles.push_back({ring[0], ring[i - 1], ring[i]});
  return triangles;
}

void insert_points(Delaunay& delaunay, const std::vector<PlanePoint>& points, const Rings& rings,
                   std::vector<Delaunay::Vertex_handle>& handles) {
  std::vector<Located> located;
  std::vector<bool> seen(points.size(), false);
  for (const auto& ring : rings)
    for (const std::uint32_t index : ring) {
      if (seen[index]) continue;
      seen[index] = true;
      const PlanePoint& point = points[index];
      located.emplace_back(
          Kernel::Point_2(static_cast<double>(point.u), static_cast<double>(point.v)), index);
    }
  // In ring order long straight sides would make every insertion slow.
  using ByPoint =
      CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<Located>>;
  CGAL::spatial_sort(located.begin(), located.end(), ByPoint());
  Delaunay::Face_handle near;
  for (const auto& [point, index] : located) {
    const Delaunay::Vertex_handle vertex = delaunay.insert(point, near);
    vertex->info() = index;
    handles[index] = vertex;
    near = vertex->face();
  }
}

// Outside and inside alternate across constraints, from the infinite face on.
void mark_inside(Delaunay& delaunay) {
  for (const auto face : delaunay.all_face_handles()) face->info() = Side::unknown;
  std::vector<Delaunay::Face_handle> waiting{delaunay.infinite_face()};
  waiting.front()->info() = Side::outside;
  while (!waiting.empty()) {
    const Delaunay::Face_handle face = waiting.back();
    waiting.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Delaunay::Face_handle next = face->neighbor(i);
      if (next->info() != Side::unknown) continue;
      const bool crosses = face->is_constrained(i);
      next->info() = (face->info() == Side::inside) != crosses ? Side::inside : Side::outside;
      waiting.push_back(next);
    }
  }
}

std::vector<Triangle> constrained_delaunay(const std::vector<PlanePoint>& points,
                                           const Rings& rings) {
  Delaunay delaunay;
  std::vector<Delaunay::Vertex_handle> handles(points.size());
  insert_points(delaunay, points, rings, handles);
  try {
    for (const auto& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        delaunay.insert_constraint(handles[ring[i]], handles[ring[(i + 1) % ring.size()]]);
  } catch (const Delaunay::Intersection_of_constraints_exception&) {
    throw std::invalid_argument("rings cross");
  }
  if (delaunay.dimension() < 2) return {};
  mark_inside(delaunay);
  std::vector<Triangle> triangles;
  for (const auto face : delaunay.finite_face_handles())
    if (face->info() == Side::inside)
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

void check(const std::vector<PlanePoint>& points, const Rings& rings) {
  for (const PlanePoint& point : points)
    if (std::max(point.u, point.v) > max_plane_coordinate ||
        std::min(point.u, point.v) < -max_plane_coordinate)
      throw std::invalid_argument("polygon too large to triangulate");
  for (const auto& ring : rings) {
    if (ring.size() < 3) throw std::invalid_argument("ring of less than three points");
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (ring[i] == ring[(i + 1) % ring.size()])
        throw std::invalid_argument("ring stays on a point");
  }
}

}  // namespace

std::vector<Triangle> triangulate(const std::vector<PlanePoint>& points, const Rings& rings) {
  check(points, rings);
  if (rings.size() == 1 && rings[0].size() <= max_fan && strictly_convex(points, rings[0]))
    return fan(rings[0]);

  std::vector<Triangle> triangles = constrained_delaunay(points, rings);
  std::int64_t sum = 0;
  for (const Triangle& triangle : triangles)
    sum += doubled_area(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
  if (sum <= 0 || sum != doubled_area(points, rings))
    throw std::invalid_argument("rings do not bound a polygon");
  return triangles;
}

}  // namespace discmc::host
