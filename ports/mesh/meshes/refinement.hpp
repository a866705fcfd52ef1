// Refines merged polygons for the interpolated surface.
#ifndef DISCMC_MESH_MESHES_REFINEMENT_HPP
#define DISCMC_MESH_MESHES_REFINEMENT_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "delaunay.hpp"
#include "extraction/crossings.hpp"
#include "lattice_plane.hpp"
#include "surface/point.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

/// The triangles of a polygon, and the new positions of their corners.
struct MovedTriangles {
  std::vector<PlanePoint> points;
  std::vector<Point> moved;  ///< one per point; Units: half-steps
  std::vector<Triangle> triangles;
  /// One per triangle: false if all crossings in the triangle and on its sides are points. Set by
  /// Refinement::refine().
  std::vector<bool> leaves_out;
};

/// Finds the vertices that a polygon needs when its vertices move to the crossings of the samples.
/// Like greedy insertion (M. Garland, P. Heckbert, Fast Polygonal Approximation of Terrains and
/// Height Fields, 1995), it adds the farthest crossing until all are within the tolerance.
class Refinement {
 public:
  /// tolerance: the largest distance of a crossing from the mesh. Units: voxels. Owner of the
  /// crossings: the caller.
  Refinement(const Crossings& crossings, double tolerance);

  /// Returns the indexes of vertices that a straight side needs between its ends; valid until the
  /// next call. side: all its vertices, in one order for both polygons of the side.
  const std::vector<std::size_t>& needed(const std::vector<Vertex>& side);

  /// Adds the points that the polygon needs inside. triangles: Delaunay's, within the sides of the
  /// polygon. required: vertices to add in any case.
  void refine(const LatticePlane& plane, const VertexNumbers& required, MovedTriangles& triangles);

  /// Returns the crossings in a triangle and on its sides.
  static std::vector<Vertex> crossings_in(const LatticePlane& plane,
                                          const std::array<PlanePoint, 3>& corners);

 private:
  struct Farthest {
    double squared_distance;
    PlanePoint point;
    Point moved;
    bool leaves_out;  // as in MovedTriangles
  };
  Point moved(const Vertex& vertex) const { return crossings_.interpolated(vertex); }
  Farthest farthest(const LatticePlane& plane, const VertexNumbers& required,
                    const MovedTriangles& triangles, std::uint32_t triangle) const;

  const Crossings& crossings_;
  double squared_tolerance_;  // Units: square half-steps
  std::vector<Point> side_;
  std::vector<std::pair<std::size_t, std::size_t>> spans_;
  std::vector<std::size_t> needed_;
  DelaunayFlips flips_;
  std::vector<std::uint32_t> waiting_;  // triangles to check
  std::vector<bool> waits_;
};

}  // namespace discmc::meshing

#endif
