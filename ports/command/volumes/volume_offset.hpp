// Whether the voxels of two volumes lie in the same places.
#pragma once

#include <array>
#include <cstddef>

#include "volume.hpp"

namespace discmc::command {

/// An axis of a volume, along which one of another volume runs.
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

/// Which axis of `other` runs nearest to each of the volume. The same ones where that is not clear,
/// and if one of them has no patient's space.
AxesMatch matching_axes(const VolumeInfo& volume, const VolumeInfo& other);

/// The largest distance between voxels of the same number, as far as the volumes declare. 0 if it
/// is a tenth of a voxel or less. If one of them has no patient's space, only their spacings are
/// compared. Units: millimetres. Limit: the same extents.
double offset_mm(const VolumeInfo& a, const VolumeInfo& b);

}  // namespace discmc::command
