#include "placing.hpp"

#include <algorithm>
#include <cstddef>

namespace discmc::meshing {
namespace {

// Returns v[0] columns[0] + v[1] columns[1] + v[2] columns[2].
Point combined(const Axes& columns, const Point& v) {
  Point sum{};
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] = v[0] * columns[0][i] + v[1] * columns[1][i] + v[2] * columns[2][i];
  return sum;
}

}  // namespace

void place(FaceMesh& mesh, const VolumePlacement& placement) {
  // Maps millimetres along the axes to space: a rotation, unless axes are oblique.
  Axes turn = placement.axes_mm;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double& along : turn[axis]) along /= mesh.spacing_mm[axis];
  for (Point& vertex : mesh.vertices_mm) {
    vertex = combined(turn, vertex);
    for (std::size_t i = 0; i < 3; ++i) vertex[i] += placement.origin_mm[i];
  }

  // Planes transform by the inverse transpose. These are its columns, times the determinant.
  Axes turn_planes{cross(turn[1], turn[2]), cross(turn[2], turn[0]), cross(turn[0], turn[1])};
  const bool mirrors = determinant(turn) < 0;
  if (mirrors)
    for (Point& column : turn_planes) column = difference({}, column);
  for (Point& normal : mesh.normals) normal = unit_or_zero(combined(turn_planes, normal));

  if (mirrors)
    for (std::size_t face = 0; face < mesh.face_count(); ++face)
      std::reverse(mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[face]),
                   mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[face + 1]));
  mesh.incidences.clear();
}

}  // namespace discmc::meshing
