// Walls, and bars across them: every edge between them may have the maximum number of chains.
#pragma once

#include <cstdint>

namespace discmc::shapes {

struct Bars {
  uint32_t period = 2;     ///< of walls and bars
  uint32_t thickness = 1;  ///< of each; Limit: less than the period
  uint32_t phase = 1;
  uint32_t levels = 2;  ///< slices of walls, then slices of bars

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    return ((z / levels % 2 == 0 ? x : y) + phase) % period < thickness;
  }
};

}  // namespace discmc::shapes
