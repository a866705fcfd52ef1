#include "mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "intersections.hpp"
#include "lattice_plane.hpp"
#include "refinement.hpp"
#include "triangulate.hpp"
#include "vertex_numbers.hpp"

namespace discmc::host {
namespace {

class Builder {
 public:
  Builder(const Surface& surface, const MeshOptions& options)
      : surface_(surface), options_(options) {
    const Point& s = surface.spacing_mm;
    mirrored_ = (s[0] < 0) != ((s[1] < 0) != (s[2] < 0));
    for (const Polygon& polygon : surface.polygons)
      for (const Ring& ring : polygon.rings)
        for (const Vertex& corner : ring) corner_numbers_.push_back(all_numbers_.add(corner));
    if (options.crossings == nullptr) return;
    refinement_.emplace(*options.crossings, options.tolerance);
    number_what_sides_need();
  }

  Mesh build() {
    mesh_.spacing_mm = surface_.spacing_mm;
    mesh_.lattice.reserve(all_numbers_.positions().size());
    mesh_.vertices_mm.reserve(all_numbers_.positions().size());
    place_vertices();
    reserve_faces();
    for_each_polygon([this](std::uint32_t polygon) { add_polygon(polygon); });
    if (refinement_) separate_faces();
    return std::move(mesh_);
  }

 private:
  // Those that are new.
  void place_vertices() {
    const std::vector<Vertex>& positions = all_numbers_.positions();
    for (std::size_t i = mesh_.lattice.size(); i < positions.size(); ++i) {
      if (refinement_) moved_.push_back(refinement_->moved(positions[i]));
      mesh_.lattice.push_back(positions[i]);
      mesh_.vertices_mm.push_back(in_mm(refinement_ ? moved_.back() : point_of(positions[i])));
    }
  }

  // Collects the corners and junctions of each before the call.
  template <class Call>
  void for_each_polygon(Call call) {
    const std::uint32_t* number = corner_numbers_.data();
    for (std::size_t i = 0; i < surface_.polygons.size(); ++i) {
      numbers_.clear();
      ring_ends_.clear();
      for (const Ring& ring : surface_.polygons[i].rings) {
        add_ring(ring, number);
        number += ring.size();
      }
      call(static_cast<std::uint32_t>(i));
    }
  }

  // Where two sheets are near to each other, triangles that leave out crossings may go through each
  // other. They get theirs, until what is left does so in the interpolated surface itself.
  void separate_faces() {
    FaceList faces(mesh_.face_count());
    std::iota(faces.begin(), faces.end(), 0U);
    for (;;) {
      const std::size_t vertices = all_numbers_.positions().size();
      std::vector<bool> is_outdated(surface_.polygons.size());
      for (const auto& pair : intersecting_faces(mesh_, faces))
        for (const std::uint32_t face : pair)
          if (number_crossings(face)) is_outdated[mesh_.polygons[face]] = true;
      if (all_numbers_.positions().size() == vertices) return;
      faces = near_faces(mesh_, renewed_faces(is_outdated, vertices));
    }
  }

  // Whether there are new ones in the face or on its sides.
  bool number_crossings(std::size_t face) {
    const std::size_t vertices = all_numbers_.positions().size();
    const Incidence incidence = surface_.polygons[mesh_.polygons[face]].incidence;
    const std::uint32_t* corners = mesh_.face(face);
    const LatticePlane plane(mesh_.lattice[corners[0]], incidence);
    std::array<PlanePoint, 3> points;
    for (std::size_t i = 0; i < 3; ++i)
      points[i] = plane.at(mesh_.lattice[corners[mirrored_ ? 2 - i : i]]);
    Refinement::add_crossings(plane, points, all_numbers_);
    return all_numbers_.positions().size() > vertices;
  }

  // Makes those anew that are of an outdated polygon, or of one with a new vertex on a side.
  FaceList renewed_faces(const std::vector<bool>& is_outdated, std::size_t first_new) {
    place_vertices();
    Mesh earlier;
    std::swap(earlier.corners, mesh_.corners);
    std::swap(earlier.face_begin, mesh_.face_begin);
    std::swap(earlier.polygons, mesh_.polygons);
    mesh_.left_out.clear();
    reserve_faces();
    FaceList renewed;
    std::size_t end = 0;
    for_each_polygon([&](std::uint32_t polygon) {
      const std::size_t begin = end;
      while (end < earlier.face_count() && earlier.polygons[end] == polygon) ++end;
      const bool has_new_side = std::any_of(numbers_.begin(), numbers_.end(),
                                            [&](std::uint32_t each) { return each >= first_new; });
      if (!is_outdated[polygon] && !has_new_side) {
        for (std::size_t face = begin; face < end; ++face)
          add_triangle(polygon, earlier.face(face));
        return;
      }
      std::size_t face = mesh_.face_count();
      add_polygon(polygon);
      for (; face < mesh_.face_count(); ++face) renewed.push_back(static_cast<std::uint32_t>(face));
    });
    return renewed;
  }

  // A closed surface has two triangles a vertex (Euler), and more only with many handles. What is
  // reserved and not used costs nothing; vectors that grow are there twice while they do.
  void reserve_faces() {
    const std::size_t vertices = mesh_.lattice.size();
    const std::size_t faces = 2 * vertices + vertices / 4;
    mesh_.corners.reserve(3 * faces);
    mesh_.face_begin.reserve(faces + 1);
    mesh_.incidences.reserve(faces);
    mesh_.polygons.reserve(faces);
  }

  static Point point_of(const Vertex& vertex) {
    return {static_cast<double>(vertex.x), static_cast<double>(vertex.y),
            static_cast<double>(vertex.z)};
  }

  // at: in half-steps.
  Point in_mm(const Point& at) const {
    const Point& s = surface_.spacing_mm;
    return {at[0] * s[0] / 2, at[1] * s[1] / 2, at[2] * s[2] / 2};
  }

  // What an interpolated side needs between its ends becomes a junction, for both polygons that
  // have it.
  void number_what_sides_need() {
    std::vector<Vertex> needed;
    for (const Polygon& polygon : surface_.polygons)
      for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
          add_what_sides_need(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], needed);
    for (const Vertex& vertex : needed) all_numbers_.add(vertex);
  }

  // Between two corners: from each junction to the next.
  void add_what_sides_need(const Vertex& from, const Vertex& to, std::vector<Vertex>& needed) {
    const Side side = side_between(from, to);
    side_ = {from};
    for (std::int32_t i = 1; i <= side.links; ++i) {
      const Vertex vertex = side_.back() + side.link;
      side_.push_back(vertex);
      if (all_numbers_.find(vertex) == VertexNumbers::none) continue;
      if (precedes(side_.back(), side_.front())) std::reverse(side_.begin(), side_.end());
      for (const std::size_t place : refinement_->needed(side_)) needed.push_back(side_[place]);
      side_ = {vertex};
    }
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

  void add_polygon(std::uint32_t polygon) {
    const Incidence incidence = surface_.polygons[polygon].incidence;
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
    if (numbers_.empty()) throw std::invalid_argument("no corners");
    const LatticePlane plane(mesh_.lattice[numbers_[0]], incidence);
    points_.clear();
    for (const std::uint32_t number : numbers_) points_.push_back(plane.at(mesh_.lattice[number]));
    const std::vector<Triangle>& triangles = triangulator_.triangulate(points_, ring_ends_);
    if (refinement_) return add_refined(polygon, plane, triangles);
    for (const Triangle& triangle : triangles)
      add_face(polygon, incidence,
               std::array{numbers_[triangle[0]], numbers_[triangle[1]], numbers_[triangle[2]]});
  }

  void add_refined(std::uint32_t polygon, const LatticePlane& plane,
                   const std::vector<Triangle>& triangles) {
    refined_.points = points_;
    refined_.moved.clear();
    for (const std::uint32_t number : numbers_) refined_.moved.push_back(moved_[number]);
    refined_.triangles = triangles;
    refinement_->refine(plane, all_numbers_, refined_);
    for (std::size_t i = numbers_.size(); i < refined_.points.size(); ++i)
      numbers_.push_back(all_numbers_.add(plane.vertex(refined_.points[i])));
    place_vertices();
    for (const Triangle& triangle : refined_.triangles) {
      std::array<std::uint32_t, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = numbers_[triangle[mirrored_ ? 2 - i : i]];
      add_triangle(polygon, corners.data());
    }
  }

  void add_triangle(std::uint32_t polygon, const std::uint32_t* corners) {
    mesh_.corners.insert(mesh_.corners.end(), corners, corners + 3);
    mesh_.face_begin.push_back(mesh_.corners.size());
    mesh_.polygons.push_back(polygon);
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
  // Of an interpolated mesh.
  std::optional<Refinement> refinement_;
  std::vector<Vertex> side_;  // under way
  MovedTriangles refined_;
  std::vector<Point> moved_;  // where the corners and junctions are moved to; Units: half-steps
  Mesh mesh_;
};

}  // namespace

Mesh build_mesh(const Surface& surface, const MeshOptions& options) {
  for (const double spacing : surface.spacing_mm)
    if (spacing == 0 || !std::isfinite(spacing))
      throw std::invalid_argument("spacing is zero or not finite");
  const bool are_conforming_triangles = options.conforming && options.faces == Faces::triangles;
  if (options.crossings != nullptr && !are_conforming_triangles)
    throw std::invalid_argument("an interpolated mesh is one of conforming triangles");
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
