// A surface in the form of graphics cards: triangles of the merged polygons, and their edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <discmc/lattice.hpp>
#include <discmc/normal.hpp>

#include "corner_set.hpp"
#include "meshes/triangulator.hpp"
#include "surface/surface.hpp"
#include "triangle_store.hpp"

namespace discmc::web {

/// A corner of one polygon. Units: half-steps.
struct DrawnVertex {
  static constexpr std::uint8_t colours = 7;

  std::int16_t x, y, z;
  std::uint8_t incidence;
  std::uint8_t colour;  ///< below colours; usually differs from those of neighbouring polygons
};
static_assert(sizeof(DrawnVertex) == 8, "the page reads them so");

/// Keeps vertices on straight sides at which other polygons end, so triangles have no T-junctions.
/// No pixel shows through, and meshes of the triangles are closed.
class DrawnSurface {
 public:
  /// Omits and counts polygons that cannot be triangulated: no sweep makes them, but a damaged
  /// stream may. Throws std::runtime_error like CornerSet::fill().
  void make(const meshing::Polygons& polygons);

  const std::vector<DrawnVertex>& vertices() const { return vertices_; }
  /// Numbers of vertices, three per triangle, counter-clockwise seen from outside in the lattice.
  /// Sorted by incidence, so that those facing away can be omitted.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  /// The end of each incidence in triangles().
  const std::vector<std::uint32_t>& triangle_ends() const { return triangle_ends_; }
  /// Numbers of vertices, two per edge between polygons.
  const std::vector<std::uint32_t>& edges() const { return edges_; }
  std::uint32_t left_out() const { return left_out_; }

 private:
  void add_polygon(const meshing::Polygon& polygon);
  void add_ring(const meshing::Ring& ring, const meshing::Polygon& polygon);
  void add_triangles(Incidence incidence);
  void gather_triangles();

  CornerSet corners_;
  std::vector<DrawnVertex> vertices_;
  std::array<std::vector<std::uint32_t>, incidence_codes> triangles_of_;  // the incidences
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> triangle_ends_;
  std::vector<std::uint32_t> edges_;
  std::uint32_t left_out_ = 0;
  // The current polygon.
  std::uint32_t number_ = 0;
  std::uint32_t first_vertex_ = 0;
  std::vector<meshing::PlanePoint> points_;
  std::vector<std::uint32_t> ring_ends_;
  TriangleStore store_;
};

}  // namespace discmc::web
