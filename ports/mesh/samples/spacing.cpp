#include "spacing.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace discmc::meshing {
namespace {

std::int32_t nanometres(double millimetres) {
  const double value = std::round(millimetres * 1e6);
  if (!(std::fabs(value) <= 2147483647.0))
    throw std::invalid_argument(
        "spacing " + std::to_string(millimetres) +
        " mm is more than the 2147 mm that a stream holds; give a smaller spacing");
  return static_cast<std::int32_t>(value);
}

}  // namespace

std::array<std::int32_t, 3> spacing_nm(const std::array<double, 3>& spacing_mm) {
  return {nanometres(spacing_mm[0]), nanometres(spacing_mm[1]), nanometres(spacing_mm[2])};
}

std::array<double, 3> spacing_mm(const StreamHeader& header) {
  std::array<double, 3> spacing{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    spacing[axis] = header.spacing_nm[axis] != 0 ? header.spacing_nm[axis] * 1e-6 : 1.0;
  return spacing;
}

}  // namespace discmc::meshing
