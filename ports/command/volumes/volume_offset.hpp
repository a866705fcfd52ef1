// Whether the voxels of two volumes lie in the same places.
#pragma once

#include <array>
#include <cstddef>

#include "volume.hpp"

namespace discmc::command {

/// The axis of a volume along which an axis of another volume runs.
struct AxisMatch {
  std::size_t axis;
  bool is_reversed;
};
using AxesMatch = std::array<AxisMatch, 3>;

constexpr bool is_same(const AxesMatch& match) {
  for (std::size_t i = 0; i < match.size(); ++i)
    if (match[i].axis != i || match[i].is_reversed) return false;
  return true;
}

/// Returns which axis of `other` runs nearest to each axis of the volume. Returns equal axes if
/// this is unclear, or if a volume has no patient's space.
AxesMatch matching_axes(const VolumeInfo& volume, const VolumeInfo& other);

/// Returns the largest declared distance between voxels of equal index, or 0 if it is at most a
/// tenth of a voxel. If a volume has no patient's space, compares only spacings. Units:
/// millimetres. Limit: equal extents.
double offset_mm(const VolumeInfo& a, const VolumeInfo& b);

}  // namespace discmc::command
