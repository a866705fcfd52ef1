// Plates with islands in their holes, level or slanting: many holes wait on one plane.
#pragma once

#include <algorithm>
#include <cstdint>

namespace discmc::shapes {

struct Plates {
  uint32_t pitch = 8;      ///< voxels from hole to hole
  uint32_t border = 2;     ///< voxels of the widths of a hole's and an island's rims
  uint32_t spacing = 4;    ///< slices from plate to plate
  uint32_t thickness = 1;  ///< Limit: less than the spacing
  uint32_t slope = 0;      ///< slices that a plate rises per column

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    if ((z + slope * x) % spacing >= thickness) return false;
    const uint32_t from_rim = std::min(to_rim(x), to_rim(y));
    return from_rim / border % 2 == 0;
  }

 private:
  uint32_t to_rim(uint32_t at) const { return std::min(at % pitch, pitch - 1 - at % pitch); }
};

}  // namespace discmc::shapes
