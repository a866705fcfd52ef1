// Sizes near limits: rows of few voxels, runs of the maximum length, and rows around powers of two
// in words of 30 columns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <discmc/limits.hpp>
#include <utility>

#include "shape.hpp"

namespace discmc::shapes {

/// Draws a side near a power of two from 16 to 4,096, or near a word boundary (30 columns) there.
inline uint32_t draw_side(const Below& below) {
  const uint32_t power = 16U << below(9);
  const uint32_t words = std::max(power / 30, 1U) + below(2);
  const uint32_t middle = below(2) == 0 ? power : 30 * words;
  return middle + below(5) - 2;
}

/// Draws a size of about this number of voxels, with one or two wide sides.
inline reference::Size draw_wide_size(const Below& below, uint32_t voxels) {
  reference::Size size{draw_side(below), 0, 0};
  const uint32_t left = std::max(voxels / size.width, 6U);
  const uint32_t max_slices = below(2) == 0 ? 4 : 40;
  size.depth = 2 + below(std::min(left / 2, max_slices));
  size.height = std::min(left / size.depth + 1, below(2) == 0 ? 60 : draw_side(below));
  if (below(4) == 0) std::swap(size.width, size.height);
  return size;
}

/// Draws a size with one long side near its limit, or of 44,000 slices.
inline reference::Size draw_long_size(const Below& below) {
  const uint32_t longest = Limits::max_extent - below(3);
  const uint32_t short_side = 1 + below(3), other = 2 + below(3);
  switch (below(3)) {
    case 0:
      return {longest, short_side, other};
    case 1:
      return {short_side, longest, other};
    default:
      return {short_side, other, 44000 - below(3)};
  }
}

/// Draws a size for the reference, which is slow.
inline reference::Size draw_small_size(const Below& below) {
  return {1 + below(36), 1 + below(9), 1 + below(9)};
}

}  // namespace discmc::shapes
