// The angle between two directions, in double precision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace discmc::reference {

/// Returns the angle between vectors of any length. Uses sine and cosine, because neither alone is
/// exact everywhere. Units: degrees.
inline double degrees_between(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const double sine =
      std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  return std::atan2(sine, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / std::acos(-1.0);
}

/// The mean and the worst of many angles. Units: degrees.
struct Angles {
  std::size_t count = 0;
  double sum = 0, worst = 0;

  void add(double angle) {
    ++count;
    sum += angle;
    worst = std::max(worst, angle);
  }
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
};

}  // namespace discmc::reference
