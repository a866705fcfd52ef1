#include "mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "triangulate.hpp"
#include "vertex_numbers.hpp"

namespace discmc::host {
namespace {

// Two coordinates of the plane, chosen and ordered so that counter-clockwise seen from the tip of
// the normal stays so. Leaving a coordinate out changes shapes but neither order nor sides.
PlanePoint in_plane(const Vertex& vertex, const Vertex& origin, const Vertex& n) {
  const std::int64_t x = std::int64_t{vertex.x} - origin.x;
  const std::int64_t y = std::int64_t{vertex.y} - origin.y;
  const std::int64_t z = std::int64_t{vertex.z} - origin.z;
  if (n.z != 0) return n.z > 0 ? PlanePoint{x, y} : PlanePoint{y, x};
  if (n.y != 0) return n.y > 0 ? PlanePoint{z, x} : PlanePoint{x, z};
  return n.x > 0 ? PlanePoint{y, z} : PlanePoint{z, y};
}

class Builder {
 public:
  Builder(const Surface& surface, const MeshOptions& options)
      : surface_(surface), options_(options) {
    const Point& s = surface.spacing_mm;
    mirrored_ = (s[0] < 0) != ((s[1] < 0) != (s[2] < 0));
    for (const Polygon& polygon : surface.polygons)
      for (const Ring& ring : polygon.rings)
        for (const Vertex& corner : ring) corner_numbers_.push_back(all_numbers_.add(corner));
  }

  Mesh build() {
    place_vertices();
    const std::uint32_t* number = corner_numbers_.data();
    for (std::size_t i = 0; i < surface_.polygons.size(); ++i) {
      const Polygon& polygon = surface_.polygons[i];
      numbers_.clear();
      ring_ends_.clear();
      for (const Ring& ring : polygon.rings) {
        add_ring(ring, number);
        number += ring.size();
      }
      add_polygon(static_cast<std::uint32_t>(i), polygon.incidence);
    }
    return std::move(mesh_);
  }

 private:
  void place_vertices() {
    const Point& s = surface_.spacing_mm;
    mesh_.spacing_mm = s;
    mesh_.lattice = all_numbers_.positions();
    mesh_.vertices_mm.reserve(mesh_.lattice.size());
    for (const Vertex& position : mesh_.lattice)
      mesh_.vertices_mm.push_back(
          {position.x * s[0] / 2, position.y * s[1] / 2, position.z * s[2] / 2});
  }

  void add_ring(const Ring& ring, const std::uint32_t* numbers) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      numbers_.push_back(numbers[i]);
      if (options_.conforming) add_junctions(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    }
    ring_ends_.push_back(static_cast<std::uint32_t>(numbers_.size()));
  }

  // Where three or more boundary links end, some side ends as well, in whichever ring it is: what
  // is a corner of no ring is no junction.
  void add_junctions(const Vertex& from, const Vertex& to) {
    const Side side = side_between(from, to);
    Vertex vertex = from;
    for (std::int32_t i = 1; i < side.links; ++i) {
      vertex = vertex + side.link;
      const std::uint32_t number = all_numbers_.find(vertex);
      if (number != VertexNumbers::none) numbers_.push_back(number);
    }
  }

  void add_polygon(std::uint32_t polygon, Incidence incidence) {
    const bool is_whole = options_.faces == Faces::polygons && ring_ends_.size() == 1 &&
                          numbers_.size() >= 3 && numbers_.size() <= max_face_corners;
    if (is_whole) return add_face(polygon, incidence, numbers_);
    try {
      add_triangles(polygon, incidence);
    } catch (const std::invalid_argument&) {
      mesh_.left_out.push_back(polygon);
    }
  }

  void add_triangles(std::uint32_t polygon, Incidence incidence) {
    const std::vector<Vertex>& positions = mesh_.lattice;
    points_.clear();
    for (const std::uint32_t number : numbers_)
      points_.push_back(in_plane(positions[number], positions[numbers_[0]], normal(incidence)));
    for (const Triangle& triangle : triangulator_.triangulate(points_, ring_ends_))
      add_face(polygon, incidence,
               std::array{numbers_[triangle[0]], numbers_[triangle[1]], numbers_[triangle[2]]});
  }

  template <class Numbers>
  void add_face(std::uint32_t polygon, Incidence incidence, const Numbers& numbers) {
    const std::size_t count = numbers.size();
    for (std::size_t i = 0; i < count; ++i)
      mesh_.corners.push_back(numbers[mirrored_ ? count - 1 - i : i]);
    mesh_.face_begin.push_back(mesh_.corners.size());
    mesh_.incidences.push_back(incidence);
    mesh_.polygons.push_back(polygon);
  }

  const Surface& surface_;
  const MeshOptions options_;
  bool mirrored_;
  VertexNumbers all_numbers_;
  std::vector<std::uint32_t> corner_numbers_;  // of every corner of every ring
  // Of the polygon under way: its corners and junctions, ring after ring.
  std::vector<std::uint32_t> numbers_;
  std::vector<std::uint32_t> ring_ends_;
  std::vector<PlanePoint> points_;
  Triangulator triangulator_;
  Mesh mesh_;
};

}  // namespace

Mesh build_mesh(const Surface& surface, const MeshOptions& options) {
  for (const double spacing : surface.spacing_mm)
    if (spacing == 0 || !std::isfinite(spacing))
      throw std::invalid_argument("spacing is zero or not finite");
  return Builder(surface, options).build();
}

Point outward_normal(Incidence incidence, const Point& spacing_mm) {
  // Planes transform by the inverse; a signed inverse also keeps the normal outside.
  const Vertex n = normal(incidence);
  const Point scaled = {n.x / spacing_mm[0], n.y / spacing_mm[1], n.z / spacing_mm[2]};
  const double length = std::hypot(scaled[0], scaled[1], scaled[2]);
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

Point area_vector(const Mesh& mesh, std::size_t face) {
  const std::uint32_t* corners = mesh.face(face);
  const Point& origin = mesh.vertices_mm[corners[0]];
  Point sum{};
  for (std::size_t i = 2; i < mesh.face_size(face); ++i) {
    const Point doubled = cross(difference(mesh.vertices_mm[corners[i - 1]], origin),
                                difference(mesh.vertices_mm[corners[i]], origin));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += doubled[axis] / 2;
  }
  return sum;
}

Point face_normal(const Mesh& mesh, std::size_t face) {
  return mesh.incidences.empty() ? unit_or_zero(area_vector(mesh, face))
                                 : outward_normal(mesh.incidences[face], mesh.spacing_mm);
}

}  // namespace discmc::host
