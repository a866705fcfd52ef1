#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "mesh.hpp"
#include "triangulate.hpp"

namespace discmc::host {
namespace {

// The corners of a face in whole numbers, the coordinate left out along which its normal is
// longest. What rounding moves is far below what a picture or a printer shows.
std::vector<PlanePoint> in_plane(const Mesh& mesh, std::size_t face) {
  const Point normal = area_vector(mesh, face);
  std::size_t out = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (std::abs(normal[axis]) > std::abs(normal[out])) out = axis;
  // Counter-clockwise seen from the tip of the normal stays so.
  const std::size_t u = (out + (normal[out] > 0 ? 1 : 2)) % 3, v = 3 - out - u;
  const Point& origin = mesh.vertices_mm[mesh.face(face)[0]];
  double extent = 0;
  for (std::size_t i = 0; i < mesh.face_size(face); ++i) {
    const Point side = difference(mesh.vertices_mm[mesh.face(face)[i]], origin);
    extent = std::max({extent, std::abs(side[u]), std::abs(side[v])});
  }
  if (!(extent > 0)) throw std::invalid_argument("a face of no extent");
  const double scale = static_cast<double>(max_plane_coordinate) / extent;
  std::vector<PlanePoint> points;
  for (std::size_t i = 0; i < mesh.face_size(face); ++i) {
    const Point side = difference(mesh.vertices_mm[mesh.face(face)[i]], origin);
    points.push_back({std::llround(side[u] * scale), std::llround(side[v] * scale)});
  }
  return points;
}

std::vector<Triangle> fan(std::size_t corners) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

// In places of the face.
std::vector<Triangle> triangles_of(const Mesh& mesh, std::size_t face) {
  const std::size_t count = mesh.face_size(face);
  if (count <= 3) return fan(count);
  std::vector<std::uint32_t> ring(count);
  std::iota(ring.begin(), ring.end(), 0U);
  try {
    return triangulate(in_plane(mesh, face), {ring});
  } catch (const std::invalid_argument&) {
    return fan(count);
  }
}

}  // namespace

Mesh triangulated(const Mesh& mesh) {
  Mesh result{mesh.spacing_mm, mesh.vertices_mm, mesh.lattice, {}, {0}, {}, {}, mesh.normals};
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    for (const Triangle& triangle : triangles_of(mesh, face)) {
      for (const std::uint32_t place : triangle) result.corners.push_back(mesh.face(face)[place]);
      result.face_begin.push_back(result.corners.size());
      result.polygons.push_back(mesh.polygons[face]);
      if (!mesh.incidences.empty()) result.incidences.push_back(mesh.incidences[face]);
    }
  return result;
}

}  // namespace discmc::host
