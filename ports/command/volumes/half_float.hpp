// IEEE 754 floating point of 16 bits, which C++17 has no type for.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace discmc::command {

/// Returns the number that 16 bits encode. It is exact.
inline float float_of_half(std::uint16_t half) {
  const int exponent = half >> 10 & 0x1f;
  const int fraction = half & 0x3ff;
  float size = std::ldexp(static_cast<float>(fraction + 0x400), exponent - 25);
  if (exponent == 0) size = std::ldexp(static_cast<float>(fraction), -24);
  if (exponent == 0x1f)
    size = fraction == 0 ? std::numeric_limits<float>::infinity()
                         : std::numeric_limits<float>::quiet_NaN();
  return (half & 0x8000) != 0 ? -size : size;
}

}  // namespace discmc::command
