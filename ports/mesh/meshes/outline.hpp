// What a polygon becomes faces of: its corners and junctions, and the triangles over them.
#ifndef DISCMC_MESH_MESHES_OUTLINE_HPP
#define DISCMC_MESH_MESHES_OUTLINE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lattice_plane.hpp"
#include "mesh.hpp"
#include "numbered_corners.hpp"
#include "triangulate.hpp"

namespace discmc::meshing {

/// The corners and junctions of a polygon, ring after ring.
class Outline {
 public:
  Outline(const VertexNumbers& vertices, bool has_junctions)
      : vertices_(vertices), has_junctions_(has_junctions) {}

  // number: of the polygon's first corner, before those of the others.
  void follow(const Polygon& polygon, const std::uint32_t* number) {
    numbers.clear();
    ring_ends.clear();
    for (const Ring& ring : polygon.rings) {
      add_ring(ring, number);
      number += ring.size();
    }
  }

  std::vector<std::uint32_t> numbers;
  std::vector<std::uint32_t> ring_ends;

 private:
  void add_ring(const Ring& ring, const std::uint32_t* number) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      numbers.push_back(number[i]);
      if (has_junctions_) add_junctions(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    }
    ring_ends.push_back(static_cast<std::uint32_t>(numbers.size()));
  }

  // If three or more boundary links end in a vertex, some side ends there as well: a vertex that is
  // a corner of no ring is no junction.
  void add_junctions(const Vertex& from, const Vertex& to) {
    const Side side = side_between(from, to);
    Vertex vertex = from;
    for (std::int32_t i = 1; i < side.links; ++i) {
      vertex = vertex + side.link;
      const std::uint32_t number = vertices_.find(vertex);
      if (number != VertexNumbers::none) numbers.push_back(number);
    }
  }

  const VertexNumbers& vertices_;
  bool has_junctions_;
};

/// Calls for every polygon of a block with its number, when its outline has been followed.
template <class Call>
void for_each_polygon(const Surface& surface, const NumberedCorners& corners, std::size_t block,
                      Outline& outline, Call call) {
  const Polygons& polygons = surface.polygons;
  const PolygonSpan span = block_of(polygons, block);
  for (std::size_t i = span.first; i < span.end; ++i) {
    outline.follow(polygons[i], corners.numbers.data() + polygons.first_corner(i));
    call(static_cast<std::uint32_t>(i));
  }
}

/// The order of the corners of a face is turned round where an odd number of axes is.
inline bool is_mirrored(const Point& spacing) {
  return (spacing[0] < 0) != ((spacing[1] < 0) != (spacing[2] < 0));
}

/// Triangles over the corners and junctions of a polygon.
class OutlineTriangulator {
 public:
  explicit OutlineTriangulator(const VertexNumbers& vertices) : vertices_(vertices) {}

  // By places in the numbers of the outline. Throws std::invalid_argument where there are none.
  const std::vector<Triangle>& triangulate(const Outline& outline, Incidence incidence) {
    if (outline.numbers.empty()) throw std::invalid_argument("no corners");
    const std::vector<Vertex>& positions = vertices_.positions();
    plane_.emplace(positions[outline.numbers[0]], incidence);
    points_.clear();
    for (const std::uint32_t number : outline.numbers)
      points_.push_back(plane_->at(positions[number]));
    return triangulator_.triangulate(points_, outline.ring_ends);
  }

  // Belongs to the polygon that was triangulated last.
  const LatticePlane& plane() const { return *plane_; }
  const std::vector<PlanePoint>& points() const { return points_; }

 private:
  const VertexNumbers& vertices_;
  std::optional<LatticePlane> plane_;
  std::vector<PlanePoint> points_;
  Triangulator triangulator_;
};

/// at: in half-steps.
inline Point in_mm(const Point& at, const Point& spacing) {
  return {at[0] * spacing[0] / 2, at[1] * spacing[1] / 2, at[2] * spacing[2] / 2};
}

inline Point point_of(const Vertex& vertex) {
  return {static_cast<double>(vertex.x), static_cast<double>(vertex.y),
          static_cast<double>(vertex.z)};
}

/// A closed surface has two triangles a vertex (Euler), and more only with many handles. What is
/// reserved and not used costs nothing; vectors that grow are there twice while they do.
inline void reserve_faces(FaceMesh& mesh, std::size_t vertices) {
  const std::size_t faces = 2 * vertices + vertices / 4;
  mesh.corners.reserve(3 * faces);
  mesh.face_begin.reserve(faces + 1);
  mesh.incidences.reserve(faces);
  mesh.polygons.reserve(faces);
}

}  // namespace discmc::meshing

#endif
