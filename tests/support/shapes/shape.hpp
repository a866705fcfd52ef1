// Volumes that reach rare cases: shapes whose parameters the caller draws, at random or from bytes.
// No volume is held in memory.
#pragma once

#include <cstdint>
#include <functional>

#include "oracle/volume.hpp"

namespace discmc::shapes {

/// Returns a number below the limit; Limit: the limit is 1 to 256.
using Below = std::function<uint32_t(uint32_t limit)>;

/// Whether a voxel is on.
using On = std::function<bool(uint32_t x, uint32_t y, uint32_t z)>;

enum class Kind : uint8_t {
  bars,
  tiling,
  tents,
  saw,
  comb,
  shells,
  plates,
  stripes,
  fractal,
};
constexpr uint32_t kinds = 9;

const char* name_of(Kind kind);

/// Returns a shape of this kind, turned to any axes, sometimes inverted or with a few voxels of
/// noise.
On draw_shape(Kind kind, const reference::Size& size, const Below& below);

}  // namespace discmc::shapes
