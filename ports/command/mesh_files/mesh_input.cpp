#include "mesh_input.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace discmc::host {

void MeshInput::refuse(const std::string& what, const std::string& remedy) const {
  throw std::runtime_error(file_.string() + ": " + what + "; " + remedy);
}

void MeshInput::add_vertex(const Point& vertex) {
  constexpr double most = 1e30;  // whose products are numbers still
  for (const double coordinate : vertex)
    if (!(std::abs(coordinate) <= most))
      refuse("vertex " + std::to_string(vertex_count() + 1) +
             " has a coordinate that is no number or beyond 1e30");
  if (vertex_count() >= 0xFFFFFFFFu) refuse("more than 2^32 - 1 vertices", "cut it up");
  mesh_.vertices_mm.push_back(vertex);
}

void MeshInput::add_normal(const Point& normal) {
  mesh_.normals.resize(vertex_count());
  mesh_.normals.back() = unit_or_zero(normal);
}

void MeshInput::add_face(const std::vector<std::uint32_t>& corners) {
  if (corners.size() < 3) return;
  mesh_.polygons.push_back(static_cast<std::uint32_t>(mesh_.face_count()));
  mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
  mesh_.face_begin.push_back(mesh_.corners.size());
}

Mesh MeshInput::finish() {
  for (const std::uint32_t corner : mesh_.corners)
    if (corner >= vertex_count())
      refuse("a face names vertex " + std::to_string(std::uint64_t{corner} + 1) +
             ", and there are " + std::to_string(vertex_count()));
  if (!mesh_.normals.empty()) mesh_.normals.resize(vertex_count());
  return std::move(mesh_);
}

}  // namespace discmc::host
