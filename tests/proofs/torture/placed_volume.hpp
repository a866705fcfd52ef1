// A generated volume at any height: its voxels row by row, and its slabs.
#pragma once

#include <cstdint>
#include <discmc/limits.hpp>
#include <vector>

#include "oracle/volume.hpp"
#include "shapes/shape.hpp"

namespace discmc::torture {

struct PlacedVolume {
  shapes::On on;
  reference::Size size;  ///< including the slices that are off
  Border border;
  /// The number of slices below. If there are any, the first slice is the context of the lowest
  /// slab. The two lowest slices are off, so there is no surface below.
  uint32_t below;

  uint32_t first_own() const { return below > 0 ? 1 : 0; }

  void read_row(uint32_t y, uint32_t z, std::vector<uint8_t>& row) const {
    const uint32_t off = below > 0 ? 2 : 0;
    row.assign(size.width, 0);
    for (uint32_t x = 0; z >= off && x < size.width; ++x) row[x] = on(x, y, z - off) ? 1 : 0;
  }

  /// Returns the limits of the slab from slice `first` to before `end`. Units: slices of this
  /// volume.
  Limits limits_of_slab(uint32_t first, uint32_t end) const {
    return {size.width, size.height, border, {below + first, first > 0, end < size.depth}};
  }
};

}  // namespace discmc::torture
