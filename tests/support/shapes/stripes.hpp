// Stripes of any slope, whose sides are long.
#pragma once

#include <cstdint>

namespace discmc::shapes {

struct Stripes {
  int32_t along_x, along_y, along_z;  ///< the steps per voxel
  uint32_t period;                    ///< Units: steps
  uint32_t thickness;                 ///< Limit: less than the period

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    const int64_t steps = int64_t{along_x} * x + int64_t{along_y} * y + int64_t{along_z} * z;
    const int64_t rest = steps % period;
    return (rest < 0 ? rest + period : rest) < thickness;
  }
};

}  // namespace discmc::shapes
