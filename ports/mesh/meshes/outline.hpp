// The outline of a polygon with its corners and junctions, and the triangles over it.
#ifndef DISCMC_MESH_MESHES_OUTLINE_HPP
#define DISCMC_MESH_MESHES_OUTLINE_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "lattice_plane.hpp"
#include "mesh.hpp"
#include "triangulator.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

/// The corners and junctions of a polygon, ring after ring.
class Outline {
 public:
  Outline(const VertexNumbers& vertex_numbers, bool has_junctions)
      : vertex_numbers_(vertex_numbers), has_junctions_(has_junctions) {}

  void follow(const Polygon& polygon) {
    vertices.clear();
    ring_ends.clear();
    for (const Ring& ring : polygon.rings) add_ring(ring);
  }

  /// Finds the numbers of the vertices in the whole surface.
  void find_numbers() {
    numbers.clear();
    for (const Vertex& vertex : vertices) numbers.push_back(vertex_numbers_.find(vertex));
  }
  /// Numbers the vertices from `first` on.
  void count_from(std::size_t first) {
    numbers.resize(vertices.size());
    std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(first));
  }

  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> numbers;  // one per vertex
  std::vector<std::uint32_t> ring_ends;

 private:
  void add_ring(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      vertices.push_back(ring[i]);
      if (has_junctions_) add_junctions(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    }
    ring_ends.push_back(static_cast<std::uint32_t>(vertices.size()));
  }

  // If three or more boundary links end at a vertex, some polygon's side ends there as well. A
  // vertex that is no ring's corner is not a junction.
  void add_junctions(const Vertex& from, const Vertex& to) {
    if (links_between(from, to) < 2) return;
    const Side side = side_between(from, to);
    Vertex vertex = from;
    for (std::int32_t i = 1; i < side.links; ++i) {
      vertex = vertex + side.link;
      if (vertex_numbers_.has(vertex)) vertices.push_back(vertex);
    }
  }

  const VertexNumbers& vertex_numbers_;
  bool has_junctions_;
};

/// A range of indexes in Surface::polygons.
struct PolygonSpan {
  std::size_t first, end;
};

/// Polygons are processed in blocks, one per job at a time.
constexpr std::size_t polygons_per_block = 1 << 12;

inline std::size_t block_count(const Polygons& polygons) {
  return (polygons.size() + polygons_per_block - 1) / polygons_per_block;
}
inline PolygonSpan block_of(const Polygons& polygons, std::size_t block) {
  const std::size_t first = block * polygons_per_block;
  return {first, std::min(first + polygons_per_block, polygons.size())};
}

/// Calls `call` with the number of each polygon of a block, after following its outline.
template <class Call>
void for_each_polygon(const Surface& surface, std::size_t block, Outline& outline, Call call) {
  const PolygonSpan span = block_of(surface.polygons, block);
  for (std::size_t i = span.first; i < span.end; ++i) {
    outline.follow(surface.polygons[i]);
    call(static_cast<std::uint32_t>(i));
  }
}

/// An odd number of negative axes reverses the corners of faces.
inline bool is_mirrored(const Point& spacing) {
  return (spacing[0] < 0) != ((spacing[1] < 0) != (spacing[2] < 0));
}

/// Triangulates the corners and junctions of a polygon.
class OutlineTriangulator {
 public:
  // Returns triangles of indexes in the outline, or none, like Triangulator::triangulate().
  const std::vector<Triangle>& triangulate(const Outline& outline, Incidence incidence) {
    const std::vector<Vertex>& vertices = outline.vertices;
    plane_ = LatticePlane(vertices.empty() ? Vertex{} : vertices[0], incidence);
    points_.resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) points_[i] = plane_.at(vertices[i]);
    return triangulator_.triangulate(points_, outline.ring_ends);
  }

  // Returns the plane of the last triangulated polygon.
  const LatticePlane& plane() const { return plane_; }
  const std::vector<PlanePoint>& points() const { return points_; }

 private:
  LatticePlane plane_{{}, no_incidence};
  std::vector<PlanePoint> points_;
  Triangulator triangulator_;
};

/// at: Units: half-steps.
inline Point in_mm(const Point& at, const Point& spacing) {
  return {at[0] * spacing[0] / 2, at[1] * spacing[1] / 2, at[2] * spacing[2] / 2};
}

inline Point point_of(const Vertex& vertex) {
  return {static_cast<double>(vertex.x), static_cast<double>(vertex.y),
          static_cast<double>(vertex.z)};
}

/// Returns somewhat more than two triangles per vertex, which a closed surface without many handles
/// has (Euler), to reserve memory. Unused memory costs nothing, but growing vectors temporarily
/// exist twice.
constexpr std::size_t likely_faces(std::size_t vertices) {
  return 2 * vertices + vertices / 4;
}

inline void reserve_faces(FaceMesh& mesh, std::size_t vertices) {
  const std::size_t faces = likely_faces(vertices);
  mesh.corners.reserve(3 * faces);
  mesh.face_begin.reserve(faces + 1);
  mesh.incidences.reserve(faces);
  mesh.polygons.reserve(faces);
}

}  // namespace discmc::meshing

#endif
