#include "plane_faces.hpp"

#include <algorithm>
#include <vector>

namespace discmc::meshing {
namespace {

// Ends a face of a polygon after its corners were added.
void end_face(std::uint32_t polygon, Incidence incidence, FaceMesh& mesh) {
  mesh.face_begin.push_back(mesh.corners.size());
  mesh.incidences.push_back(incidence);
  mesh.polygons.push_back(polygon);
}

}  // namespace

void PlaneFaces::make(std::size_t block, FaceMesh& mesh) {
  make_faces(block, mesh, [this] { outline_.find_numbers(); });
}

void PlaneFaces::make_apart(std::size_t block, FaceMesh& mesh) {
  mesh.lattice.clear();
  make_faces(block, mesh, [&] {
    outline_.count_from(mesh.lattice.size());
    mesh.lattice.insert(mesh.lattice.end(), outline_.vertices.begin(), outline_.vertices.end());
  });
}

// number: numbers the vertices of the outline.
template <class Number>
void PlaneFaces::make_faces(std::size_t block, FaceMesh& mesh, Number number) {
  mesh.spacing_mm = surface_.spacing_mm;
  mesh.corners.clear();
  mesh.face_begin.assign(1, 0);
  mesh.incidences.clear();
  mesh.polygons.clear();
  mesh.left_out.clear();
  for_each_polygon(surface_, block, outline_, [&](std::uint32_t polygon) {
    number();
    add_polygon(polygon, mesh);
  });
}

void PlaneFaces::add_polygon(std::uint32_t polygon, FaceMesh& mesh) {
  const std::vector<std::uint32_t>& numbers = outline_.numbers;
  const bool is_whole = faces_ == Faces::polygons && outline_.ring_ends.size() == 1 &&
                        numbers.size() >= 3 && numbers.size() <= max_face_corners;
  if (is_whole) {
    if (is_mirrored_)
      mesh.corners.insert(mesh.corners.end(), numbers.rbegin(), numbers.rend());
    else
      mesh.corners.insert(mesh.corners.end(), numbers.begin(), numbers.end());
    return end_face(polygon, surface_.polygons[polygon].incidence, mesh);
  }
  add_triangles(polygon, mesh);
}

void PlaneFaces::add_triangles(std::uint32_t polygon, FaceMesh& mesh) {
  const Incidence incidence = surface_.polygons[polygon].incidence;
  const std::vector<Triangle>& triangles = triangulator_.triangulate(outline_, incidence);
  if (triangles.empty()) return mesh.left_out.push_back(polygon);
  for (const Triangle& triangle : triangles) {
    mesh.corners.push_back(outline_.numbers[triangle[is_mirrored_ ? 2 : 0]]);
    mesh.corners.push_back(outline_.numbers[triangle[1]]);
    mesh.corners.push_back(outline_.numbers[triangle[is_mirrored_ ? 0 : 2]]);
    end_face(polygon, incidence, mesh);
  }
}

}  // namespace discmc::meshing
