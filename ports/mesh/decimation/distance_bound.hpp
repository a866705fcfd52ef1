// A bound on how far a decimated surface and the original are from each other.
#ifndef DISCMC_MESH_DECIMATION_DISTANCE_BOUND_HPP
#define DISCMC_MESH_DECIMATION_DISTANCE_BOUND_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collapsing_mesh.hpp"
#include "meshes/box_tree.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// A surface that does not change. Memory: 80 bytes per triangle.
class OriginalSurface {
 public:
  OriginalSurface(std::vector<Point> points, std::vector<Triangle> triangles);

  const std::vector<Point>& points() const { return points_; }
  /// Whether some triangle is within a distance of the point.
  bool is_near(const Point& point, double distance) const;
  /// Whether the new vertex of a collapse, and the middles of the triangles and edges around it,
  /// are within a distance.
  bool is_near(const Collapse& collapse, double distance) const;

 private:
  Corners corners(std::uint32_t triangle) const;

  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  BoxTree tree_;
  mutable std::uint32_t last_ = 0;  // the triangle that was near
};

/// The points of the original surface that are no longer vertices: each belongs to a triangle that
/// is near enough.
class LeftPoints {
 public:
  /// All points are vertices.
  LeftPoints(std::size_t points, std::size_t triangles);

  /// Whether all points of the triangles of a collapse are within a distance of those that move.
  /// points: of the original surface.
  bool are_near(const Collapse& collapse, const std::vector<Point>& points, double distance);
  /// Gives the points of a collapse to their triangles. Call it after are_near().
  void carry_out(const Collapse& collapse);
  /// Gives vertices and triangles the numbers of those listed.
  void renumber(const std::vector<std::uint32_t>& vertices,
                const std::vector<std::uint32_t>& triangles);

 private:
  static constexpr std::uint32_t none = ~0U;

  struct Collected {
    std::uint32_t point;
    std::uint32_t owner;  // the place of a triangle in Collapse::moved
  };

  void collect(std::uint32_t triangle, std::uint32_t owner);

  std::vector<std::uint32_t> first_;      // of each triangle, its first point
  std::vector<std::uint32_t> next_;       // of each point, the next one of its triangle
  std::vector<std::uint32_t> of_vertex_;  // the point that a vertex was, until it moves
  std::vector<Collected> collected_;      // under way
};

}  // namespace discmc::meshing

#endif
