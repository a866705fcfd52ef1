// The corners of one cell, repeated along each axis.
#pragma once

#include <cstdint>

namespace discmc::shapes {

struct Tiling {
  uint8_t configuration;  ///< of the cell
  uint32_t phase_x = 0;   ///< Units: voxels
  uint32_t phase_y = 0;
  uint32_t phase_z = 0;
  uint32_t side = 1;  ///< voxels per corner

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    const auto bit = [this](uint32_t at, uint32_t phase) { return (at + phase) / side % 2; };
    const uint32_t corner = bit(x, phase_x) + 2 * bit(y, phase_y) + 4 * bit(z, phase_z);
    return (configuration >> corner & 1) != 0;
  }
};

}  // namespace discmc::shapes
