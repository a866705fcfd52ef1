// Points and vectors in millimetres.
#ifndef DISCMC_MESH_SURFACE_POINT_HPP
#define DISCMC_MESH_SURFACE_POINT_HPP

#include <array>
#include <cmath>

namespace discmc::meshing {

using Point = std::array<double, 3>;

inline Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns the vector with the length 1, or zero if the vector has no direction.
inline Point unit_or_zero(const Point& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {a[0] / length, a[1] / length, a[2] / length};
}

}  // namespace discmc::meshing

#endif
