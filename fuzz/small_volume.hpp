// Volumes of few voxels, so that there are many of them.
#pragma once

#include <algorithm>

#include "input.hpp"
#include "oracle/volume.hpp"

/// A volume of at most this size, with no more slices than 150 voxels need. A byte of input is
/// eight voxels.
inline discmc::reference::BitVolume read_small_volume(Input& input,
                                                      const discmc::reference::Size& most) {
  discmc::reference::Size size{1 + input.below(most.width), 1 + input.below(most.height),
                               1 + input.below(most.depth)};
  size.depth = std::min(size.depth, 1 + 150 / (size.width * size.height));
  discmc::reference::BitVolume volume(size);
  for (size_t i = 0; i < volume.on.size(); i += 8) {
    const uint32_t bits = input.byte();
    for (size_t k = i; k < i + 8 && k < volume.on.size(); ++k)
      volume.on[k] = static_cast<uint8_t>(bits >> (k - i) & 1);
  }
  return volume;
}
