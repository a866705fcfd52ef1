// Teeth that only the last rows join, so a sweep detects late that they are one region.
#pragma once

#include <cstdint>

namespace discmc::shapes {

struct Comb {
  uint32_t pitch;      ///< columns per tooth
  uint32_t thickness;  ///< of a tooth; Limit: less than the pitch
  uint32_t spine;      ///< the first of the joining rows
  uint32_t jag_y = 0;  ///< columns by which every second row is shifted
  uint32_t jag_z = 0;  ///< columns by which every second slice is shifted

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    return y >= spine || (x + y % 2 * jag_y + z % 2 * jag_z) % pitch < thickness;
  }
};

}  // namespace discmc::shapes
