#include "volume_placement.hpp"

#include <algorithm>
#include <cmath>

namespace discmc::host {

double determinant(const Axes& a) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

bool is_usable(const Axes& axes_mm) {
  constexpr double flattest = 1e-6;  // of a parallelepiped with edges of 1
  double edges = 1;
  for (const auto& axis : axes_mm) {
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    if (!(length >= least_spacing_mm && length <= most_spacing_mm)) return false;
    edges *= length;
  }
  return std::fabs(determinant(axes_mm)) >= flattest * edges;
}

bool is_usable(const VolumePlacement& placement) {
  constexpr double farthest_mm = 1e9;
  return is_usable(placement.axes_mm) &&
         std::all_of(placement.origin_mm.begin(), placement.origin_mm.end(),
                     [](double at) { return std::fabs(at) <= farthest_mm; });
}

}  // namespace discmc::host
