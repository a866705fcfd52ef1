#include "volume_placement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace discmc::meshing {

double determinant(const Axes& a) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

bool is_usable(const Axes& axes_mm) {
  constexpr double flattest = 1e-6;  // volume of a parallelepiped with edges of length 1
  double edges = 1;
  for (const auto& axis : axes_mm) {
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    if (!(length >= min_spacing_mm && length <= max_spacing_mm)) return false;
    edges *= length;
  }
  return std::fabs(determinant(axes_mm)) >= flattest * edges;
}

bool is_usable(const VolumePlacement& placement) {
  return is_usable(placement.axes_mm) &&
         std::all_of(placement.origin_mm.begin(), placement.origin_mm.end(),
                     [](double at) { return std::fabs(at) <= max_origin_mm; });
}

VolumePlacement in_space(VolumePlacement placement, Space space) {
  if (placement.space == space) return placement;
  // Converts between LPS and RAS. Adding zero turns -0 into 0.
  const auto turn = [](std::array<double, 3>& vector) {
    vector = {0.0 - vector[0], 0.0 - vector[1], vector[2]};
  };
  turn(placement.origin_mm);
  for (auto& axis : placement.axes_mm) turn(axis);
  placement.space = space;
  return placement;
}

Placement in_nanometres(const VolumePlacement& placement) {
  constexpr double max_length_mm = 2147;
  Placement rounded;
  rounded.space = placement.space;
  for (std::size_t i = 0; i < 3; ++i) {
    rounded.origin_nm[i] = std::llround(placement.origin_mm[i] * 1e6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::fabs(placement.axes_mm[axis][i]) > max_length_mm)
        throw std::invalid_argument(
            "voxels are more than 2147 mm apart, the limit of a stream; give a smaller spacing");
      rounded.axes_nm[axis][i] =
          static_cast<std::int32_t>(std::lround(placement.axes_mm[axis][i] * 1e6));
    }
  }
  return rounded;
}

VolumePlacement in_millimetres(const Placement& placement) {
  VolumePlacement result;
  result.space = placement.space;
  for (std::size_t i = 0; i < 3; ++i) {
    result.origin_mm[i] = static_cast<double>(placement.origin_nm[i]) * 1e-6;
    for (std::size_t axis = 0; axis < 3; ++axis)
      result.axes_mm[axis][i] = placement.axes_nm[axis][i] * 1e-6;
  }
  return result;
}

}  // namespace discmc::meshing
