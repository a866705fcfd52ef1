#include "file_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "volumes/declared_place.hpp"

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

double min_spacing_mm(const FileMesh& mesh) {
  double min_spacing = std::numeric_limits<double>::infinity();
  for (const double spacing : mesh.spacing_mm)
    min_spacing = std::min(min_spacing, std::fabs(spacing));
  return min_spacing;
}

}  // namespace

FileMesh joined(std::vector<FileMesh> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  FileMesh mesh;
  for (FileMesh& part : parts) {
    append(part, mesh);
    part = {};  // frees memory for the next part
  }
  return mesh;
}

void resize(FileMesh& mesh, const MeshSize& size) {
  const double factor = size.scale / millimetres_in(names_of(size.unit).symbol).value();
  for (Point& vertex : mesh.vertices_mm)
    for (double& coordinate : vertex) coordinate *= factor;
  for (double& spacing : mesh.spacing_mm) spacing *= factor;
  mesh.unit = size.unit;
}

const UnitNames& names_of(MeshUnit unit) {
  constexpr static UnitNames names[] = {{"mm", "millimetres", "millimeter"},
                                        {"um", "micrometres", "micron"},
                                        {"m", "metres", "meter"},
                                        {"inch", "inches", "inch"}};
  return names[static_cast<std::size_t>(unit)];
}

double float_step_mm(const FileMesh& mesh, const Point& origin) {
  double farthest = 0;
  for (const Point& vertex : mesh.vertices_mm)
    for (std::size_t axis = 0; axis < 3; ++axis)
      farthest = std::max(farthest, std::fabs(vertex[axis] - origin[axis]));
  constexpr int digits = std::numeric_limits<float>::digits;
  return farthest > 0 ? std::ldexp(1, std::ilogb(farthest) + 1 - digits) : 0;
}

bool suits_floats(const FileMesh& mesh, const Point& origin) {
  constexpr double steps = 500;  // per voxel; rounding moves a vertex by half a step
  return steps * float_step_mm(mesh, origin) <= min_spacing_mm(mesh);
}

std::size_t count_float_places(const FileMesh& mesh, const Point& origin) {
  std::vector<std::array<float, 3>> places;
  places.reserve(mesh.vertices_mm.size());
  for (const Point& vertex : mesh.vertices_mm) {
    const Point from = difference(vertex, origin);
    places.push_back(
        {static_cast<float>(from[0]), static_cast<float>(from[1]), static_cast<float>(from[2])});
  }
  std::sort(places.begin(), places.end());
  return static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
}

}  // namespace discmc::command
