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

Placing::Placing(const Point& spacing_mm, const VolumePlacement& placement)
    : turn_(placement.axes_mm), origin_mm_(placement.origin_mm) {
  // A rotation, unless axes are oblique.
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double& along : turn_[axis]) along /= spacing_mm[axis];
  // Planes transform by the inverse transpose. These are its columns, times the determinant.
  turn_planes_ = {cross(turn_[1], turn_[2]), cross(turn_[2], turn_[0]), cross(turn_[0], turn_[1])};
  mirrors_ = determinant(turn_) < 0;
  if (mirrors_)
    for (Point& column : turn_planes_) column = difference({}, column);
}

Point Placing::vertex(const Point& at) const {
  Point placed = combined(turn_, at);
  for (std::size_t i = 0; i < 3; ++i) placed[i] += origin_mm_[i];
  return placed;
}

Point Placing::normal(const Point& at) const {
  return unit_or_zero(combined(turn_planes_, at));
}

void place(FaceMesh& mesh, const VolumePlacement& placement) {
  const Placing placing(mesh.spacing_mm, placement);
  for (Point& vertex : mesh.vertices_mm) vertex = placing.vertex(vertex);
  for (Point& normal : mesh.normals) normal = placing.normal(normal);
  if (placing.mirrors())
    for (std::size_t face = 0; face < mesh.face_count(); ++face)
      std::reverse(mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[face]),
                   mesh.corners.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[face + 1]));
  mesh.incidences.clear();
}

}  // namespace discmc::meshing
