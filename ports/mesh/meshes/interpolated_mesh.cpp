#include "interpolated_mesh.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "intersections.hpp"
#include "outline.hpp"
#include "refinement.hpp"

namespace discmc::meshing {
namespace {

class InterpolatedMesh {
 public:
  InterpolatedMesh(const Surface& surface, VertexNumbers vertices, const MeshingOptions& options)
      : surface_(surface),
        is_mirrored_(is_mirrored(surface.spacing_mm)),
        vertices_(std::move(vertices)),
        outline_(vertices_, true),
        refinement_(*options.crossings, options.tolerance),
        jobs_(options.jobs),
        check_(options.check),
        separates_(options.separates) {
    number_what_sides_need();
  }

  FaceMesh build() {
    mesh_.spacing_mm = surface_.spacing_mm;
    mesh_.lattice.reserve(vertices_.positions().size());
    mesh_.vertices_mm.reserve(vertices_.positions().size());
    place_vertices();
    reserve_faces(mesh_, mesh_.lattice.size());
    for_each_polygon([this](std::uint32_t polygon) { add_polygon(polygon); });
    if (separates_) separate_faces();
    return std::move(mesh_);
  }

 private:
  // Places the vertices that were added since the last call.
  void place_vertices() {
    const std::vector<Vertex>& positions = vertices_.positions();
    for (std::size_t i = mesh_.lattice.size(); i < positions.size(); ++i) {
      moved_.push_back(refinement_.moved(positions[i]));
      mesh_.lattice.push_back(positions[i]);
      mesh_.vertices_mm.push_back(in_mm(moved_.back(), surface_.spacing_mm));
    }
  }

  // Calls `call` for each polygon, after following its outline and numbering its vertices.
  template <class Call>
  void for_each_polygon(Call call) {
    for (std::size_t block = 0; block < block_count(surface_.polygons); ++block) {
      if (check_) check_();
      meshing::for_each_polygon(surface_, block, outline_, [&](std::uint32_t polygon) {
        outline_.find_numbers();
        call(polygon);
      });
    }
  }

  // Triangles that leave out crossings may intersect where two sheets are near each other. Such
  // triangles get their crossings, until no such pair is left. Other intersecting pairs belong to
  // the interpolated surface itself, and stay.
  void separate_faces() {
    FaceList faces = all_faces(mesh_);
    for (;;) {
      const std::size_t vertices = vertices_.positions().size();
      std::vector<bool> is_outdated(surface_.polygons.size());
      for (const auto& pair : intersecting_faces(mesh_, faces, check_, jobs_, leaves_out_))
        for (const std::uint32_t face : pair)
          if (number_crossings(face)) is_outdated[mesh_.polygons[face]] = true;
      if (vertices_.positions().size() == vertices) return;
      faces = near_faces(mesh_, renewed_faces(is_outdated, vertices));
    }
  }

  // Numbers the crossings in a face and on its sides. Returns whether there was a new crossing.
  bool number_crossings(std::size_t face) {
    const std::size_t vertices = vertices_.positions().size();
    const Incidence incidence = surface_.polygons[mesh_.polygons[face]].incidence;
    const std::uint32_t* corners = mesh_.face(face);
    const LatticePlane plane(mesh_.lattice[corners[0]], incidence);
    std::array<PlanePoint, 3> points;
    for (std::size_t i = 0; i < 3; ++i)
      points[i] = plane.at(mesh_.lattice[corners[is_mirrored_ ? 2 - i : i]]);
    Refinement::add_crossings(plane, points, vertices_);
    return vertices_.positions().size() > vertices;
  }

  // Replaces the triangles of outdated polygons, and of polygons with a new vertex on a side.
  FaceList renewed_faces(const std::vector<bool>& is_outdated, std::size_t first_new) {
    place_vertices();
    FaceMesh earlier;
    std::swap(earlier.corners, mesh_.corners);
    std::swap(earlier.face_begin, mesh_.face_begin);
    std::swap(earlier.polygons, mesh_.polygons);
    const std::vector<bool> left_out_earlier = std::exchange(leaves_out_, {});
    mesh_.left_out.clear();
    reserve_faces(mesh_, mesh_.lattice.size());
    FaceList renewed;
    std::size_t end = 0;
    for_each_polygon([&](std::uint32_t polygon) {
      const std::size_t begin = end;
      while (end < earlier.face_count() && earlier.polygons[end] == polygon) ++end;
      const bool has_new_side = std::any_of(outline_.numbers.begin(), outline_.numbers.end(),
                                            [&](std::uint32_t each) { return each >= first_new; });
      if (!is_outdated[polygon] && !has_new_side) {
        for (std::size_t face = begin; face < end; ++face)
          add_triangle(polygon, earlier.face(face), left_out_earlier[face]);
        return;
      }
      std::size_t face = mesh_.face_count();
      add_polygon(polygon);
      for (; face < mesh_.face_count(); ++face) renewed.push_back(static_cast<std::uint32_t>(face));
    });
    return renewed;
  }

  // Adds the crossings that an interpolated side needs as junctions, for both polygons of the side.
  void number_what_sides_need() {
    std::vector<Vertex> needed;
    for (const Polygon& polygon : surface_.polygons)
      for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
          add_what_sides_need(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], needed);
    for (const Vertex& vertex : needed) vertices_.add(vertex);
  }

  // Splits the side at its junctions, and adds what each part needs.
  void add_what_sides_need(const Vertex& from, const Vertex& to, std::vector<Vertex>& needed) {
    const Side side = side_between(from, to);
    side_ = {from};
    for (std::int32_t i = 1; i <= side.links; ++i) {
      const Vertex vertex = side_.back() + side.link;
      side_.push_back(vertex);
      if (vertices_.find(vertex) == VertexNumbers::none) continue;
      if (precedes(side_.back(), side_.front())) std::reverse(side_.begin(), side_.end());
      for (const std::size_t place : refinement_.needed(side_)) needed.push_back(side_[place]);
      side_ = {vertex};
    }
  }

  void add_polygon(std::uint32_t polygon) {
    const std::vector<Triangle>& triangles =
        triangulator_.triangulate(outline_, surface_.polygons[polygon].incidence);
    if (triangles.empty())
      mesh_.left_out.push_back(polygon);
    else
      add_refined(polygon, triangles);
  }

  void add_refined(std::uint32_t polygon, const std::vector<Triangle>& triangles) {
    const LatticePlane& plane = triangulator_.plane();
    std::vector<std::uint32_t>& numbers = outline_.numbers;
    refined_.points = triangulator_.points();
    refined_.moved.clear();
    for (const std::uint32_t number : numbers) refined_.moved.push_back(moved_[number]);
    refined_.triangles = triangles;
    refinement_.refine(plane, vertices_, refined_);
    for (std::size_t i = numbers.size(); i < refined_.points.size(); ++i)
      numbers.push_back(vertices_.add(plane.vertex(refined_.points[i])));
    place_vertices();
    for (std::size_t place = 0; place < refined_.triangles.size(); ++place) {
      const Triangle& triangle = refined_.triangles[place];
      std::array<std::uint32_t, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = numbers[triangle[is_mirrored_ ? 2 - i : i]];
      add_triangle(polygon, corners.data(), refined_.leaves_out[place]);
    }
  }

  void add_triangle(std::uint32_t polygon, const std::uint32_t* corners, bool leaves_out) {
    mesh_.corners.insert(mesh_.corners.end(), corners, corners + 3);
    mesh_.face_begin.push_back(mesh_.corners.size());
    mesh_.polygons.push_back(polygon);
    leaves_out_.push_back(leaves_out);
  }

  const Surface& surface_;
  bool is_mirrored_;
  VertexNumbers vertices_;
  Outline outline_;  // of the current polygon
  OutlineTriangulator triangulator_;
  Refinement refinement_;
  unsigned jobs_;
  std::function<void()> check_;
  bool separates_;
  std::vector<Vertex> side_;  // of the current part of a side
  MovedTriangles refined_;
  std::vector<Point> moved_;  // new positions of corners and junctions; Units: half-steps
  FaceMesh mesh_;
  std::vector<bool> leaves_out_;  // one per face, as in MovedTriangles
};

}  // namespace

FaceMesh interpolated_mesh(const Surface& surface, VertexNumbers vertices,
                           const MeshingOptions& options) {
  return InterpolatedMesh(surface, std::move(vertices), options).build();
}

}  // namespace discmc::meshing
