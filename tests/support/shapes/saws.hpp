// Teeth with one slanting side: chains begin along more links than they end along.
#pragma once

#include <cstdint>

namespace discmc::shapes {

struct Saw {
  uint32_t pitch = 8;  ///< rows per tooth
  uint32_t top = 5;    ///< most rows of a tooth; Limit: less than the pitch
  uint32_t rise = 4;   ///< slices until the next teeth begin
  uint32_t width = 3;  ///< columns per blade, with one more between blades

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    const uint32_t row = y % pitch;
    return row >= z % rise && row < top && x % (width + 1) < width;
  }
};

}  // namespace discmc::shapes
