#include "file_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "volumes/length_unit.hpp"

namespace discmc::command {
namespace {

void append(const FileMesh& part, FileMesh& mesh) {
  const auto vertices = static_cast<std::uint32_t>(mesh.vertices_mm.size());
  const std::uint32_t polygons = mesh.polygons.empty() ? 0 : mesh.polygons.back() + 1;
  for (const std::uint32_t corner : part.corners) mesh.corners.push_back(vertices + corner);
  const std::size_t corners = mesh.face_begin.back();
  for (std::size_t face = 0; face < part.face_count(); ++face) {
    mesh.face_begin.push_back(corners + part.face_begin[face + 1]);
    mesh.polygons.push_back(polygons + part.polygons[face]);
  }
  mesh.vertices_mm.insert(mesh.vertices_mm.end(), part.vertices_mm.begin(), part.vertices_mm.end());
  mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
}

}  // namespace

FileMesh joined(std::vector<FileMesh> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  FileMesh all;
  for (FileMesh& part : parts) {
    append(part, all);
    part = {};  // its memory is the next one's
  }
  return all;
}

void resize(FileMesh& mesh, const MeshSize& size) {
  const double factor = size.scale / millimetres_in(symbol(size.unit)).value();
  for (Point& vertex : mesh.vertices_mm)
    for (double& coordinate : vertex) coordinate *= factor;
  for (double& spacing : mesh.spacing_mm) spacing *= factor;
  mesh.unit = size.unit;
}

const char* symbol(MeshUnit unit) {
  switch (unit) {
    case MeshUnit::millimetre:
      break;
    case MeshUnit::micrometre:
      return "um";
    case MeshUnit::metre:
      return "m";
    case MeshUnit::inch:
      return "inch";
  }
  return "mm";
}

}  // namespace discmc::command
