#include "iso_value.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace discmc::meshing {

double lowered_by_rounding(const SampleGrid& info, double iso) {
  // iso, slope and intercept are decimal numbers, each rounded once.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  if (info.slope == 1 && info.intercept == 0) return iso;
  return iso - rounding * std::fabs(iso) - rounding * std::fabs(info.intercept);
}

std::int32_t stored_threshold(const SampleGrid& info, double iso) {
  constexpr std::int64_t min_iso = std::numeric_limits<std::int32_t>::min();
  constexpr std::int64_t max_iso = std::numeric_limits<std::int32_t>::max();
  if (!std::isfinite(iso)) return static_cast<std::int32_t>(iso < 0 ? min_iso : max_iso);

  const double reached = lowered_by_rounding(info, iso);
  // Uses bisection, which is exact although a quotient is rounded, and saturates by itself.
  std::int64_t low = min_iso;
  std::int64_t high = max_iso;
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    if (info.slope * static_cast<double>(middle) + info.intercept >= reached)
      high = middle;
    else
      low = middle + 1;
  }
  return static_cast<std::int32_t>(low);
}

}  // namespace discmc::meshing
