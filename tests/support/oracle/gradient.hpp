// Volumes of samples, and their gradient by definition.
#pragma once

#include <array>
#include <cstdint>
#include <discmc/lattice.hpp>
#include <vector>

#include "volume.hpp"

namespace discmc::reference {

template <class Sample>
struct SampleVolume {
  Size size;
  std::vector<Sample> samples;  ///< x runs fastest, then y, then z

  const Sample* slice(uint32_t z) const {
    return samples.data() + size_t{z} * size.width * size.height;
  }
  const Sample* row(uint32_t y, uint32_t z) const { return slice(z) + size_t{y} * size.width; }
  double at(const std::array<int64_t, 3>& v) const {
    const int64_t width = size.width, height = size.height;
    return static_cast<double>(samples[static_cast<size_t>((v[2] * height + v[1]) * width + v[0])]);
  }
};

/// Returns the gradient at a vertex: the mean of the differences at the voxels around it.
/// Differences are central, or one-sided at the outermost voxels. Zero outside the volume. Units:
/// samples per voxel.
template <class Sample>
std::array<double, 3> gradient(const SampleVolume<Sample>& volume, const Vertex& vertex) {
  const std::array<int64_t, 3> most = {int64_t{volume.size.width} - 1,
                                       int64_t{volume.size.height} - 1,
                                       int64_t{volume.size.depth} - 1};
  const std::array<int64_t, 3> place = {vertex.x, vertex.y, vertex.z};
  for (size_t axis = 0; axis < 3; ++axis)
    if (place[axis] < 0 || place[axis] > 2 * most[axis]) return {0, 0, 0};
  std::array<double, 3> sum{};
  double voxels = 0;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int64_t, 3> voxel{};
    bool is_new = true;  // an even coordinate has one voxel, not two
    for (size_t axis = 0; axis < 3; ++axis) {
      const int64_t far = corner >> axis & 1;
      voxel[axis] = (place[axis] + far) / 2;
      if (far == 1 && place[axis] % 2 == 0) is_new = false;
    }
    if (!is_new) continue;
    ++voxels;
    for (size_t axis = 0; axis < 3; ++axis) {
      auto before = voxel, after = voxel;
      if (voxel[axis] > 0) --before[axis];
      if (voxel[axis] < most[axis]) ++after[axis];
      const auto distance = static_cast<double>(after[axis] - before[axis]);
      if (distance > 0) sum[axis] += (volume.at(after) - volume.at(before)) / distance;
    }
  }
  return {sum[0] / voxels, sum[1] / voxels, sum[2] / voxels};
}

}  // namespace discmc::reference
