// Bounds the distance between a decimated surface and the original.
#ifndef DISCMC_MESH_DECIMATION_DISTANCE_BOUND_HPP
#define DISCMC_MESH_DECIMATION_DISTANCE_BOUND_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collapsing_mesh.hpp"
#include "meshes/box_tree.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// The original surface, which does not change. Memory: 80 bytes per triangle.
class OriginalSurface {
 public:
  OriginalSurface(std::vector<Point> points, std::vector<Triangle> triangles);

  const std::vector<Point>& points() const { return points_; }
  /// Whether a triangle is within a distance of the point.
  bool is_near(const Point& point, double distance) const;
  /// Whether the new vertex of a collapse, and the middles of the triangles and edges around it,
  /// are within a distance.
  bool is_near(const Collapse& collapse, double distance) const;

 private:
  Corners corners(std::uint32_t triangle) const;

  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  BoxTree tree_;
  mutable std::uint32_t last_ = 0;  // last triangle that was near
};

/// The original points that are no longer vertices. Each belongs to a triangle that is near enough.
class LeftPoints {
 public:
  /// At first, all points are vertices.
  LeftPoints(std::size_t points, std::size_t triangles);

  /// Whether all points of the triangles in a collapse are within a distance of the moving
  /// triangles. points: of the original surface.
  bool are_near(const Collapse& collapse, const std::vector<Point>& points, double distance);
  /// Moves the points of a collapse to its new triangles. Call it after are_near().
  void carry_out(const Collapse& collapse);
  /// Renumbers vertices and triangles by the positions of their old numbers in these lists.
  void renumber(const std::vector<std::uint32_t>& vertices,
                const std::vector<std::uint32_t>& triangles);

 private:
  static constexpr std::uint32_t none = ~0U;

  struct Collected {
    std::uint32_t point;
    std::uint32_t owner;  // index of a triangle in Collapse::moved
  };

  void collect(std::uint32_t triangle, std::uint32_t owner);

  std::vector<std::uint32_t> first_;      // first point of each triangle
  std::vector<std::uint32_t> next_;       // next point of the triangle, for each point
  std::vector<std::uint32_t> of_vertex_;  // original point of each vertex that has not moved
  std::vector<Collected> collected_;      // during a collapse
};

}  // namespace discmc::meshing

#endif
