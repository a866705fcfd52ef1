// Nested tents, some with ragged rims: in a slab, the inner ones are complete first.
#pragma once

#include <cstdint>

namespace discmc::shapes {

struct Tents {
  uint32_t span = 120;     ///< voxels from ridge to ridge
  uint32_t period = 4;     ///< between nested tents
  uint32_t thickness = 2;  ///< of their cloth
  uint32_t rows = 4;       ///< of a tent; the last one is a gap
  bool is_valley = false;  ///< whether tents are upside down

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    const uint32_t column = x % span, ridge = span / 2;
    const uint32_t from_ridge = column < ridge ? ridge - column : column - ridge;
    // A negative level wraps to a multiple of any period that is a power of two.
    const uint32_t level = is_valley ? (1U << 24) + from_ridge - z : from_ridge + z;
    const bool is_ragged = level / period % 2 == 1 && (x + z) / 2 % 2 == 1;
    return level % period < thickness && y % rows + (is_ragged ? 0 : 1) < rows;
  }
};

}  // namespace discmc::shapes
