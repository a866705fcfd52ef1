#include "smoothed_volume.hpp"

#include <algorithm>

namespace discmc::meshing {
namespace {

// Distances beyond four deviations do not affect the surface.
double limit_mm(const SampleGrid& info, double deviation_mm) {
  return std::max(4 * deviation_mm, steps_mm(info));
}

Grid grid_of(const SampleGrid& info) {
  return {info.dims, info.distances_mm()};
}

}  // namespace

SmoothedVolume::SmoothedVolume(SliceReader& volume, const Selection& selection, SliceReader* mask,
                               double deviation_mm)
    : selected_(volume, selection, mask),
      info_(info_of_mask(volume.info(), SampleType::f32)),
      distance_(grid_of(info_), limit_mm(info_, deviation_mm),
                [this](float* mask_slice) { read_mask(mask_slice); }),
      once_(grid_of(info_), deviation_mm, [this](float* slice) { distance_.next(slice); }),
      twice_(grid_of(info_), deviation_mm, [this](float* slice) { once_.next(slice); }) {}

VolumeKeeping SmoothedVolume::keeping(const SampleGrid& info, double deviation_mm, double tolerance,
                                      Border border) {
  VolumeKeeping keeping;
  keeping.tolerance = tolerance;
  keeping.min_distance_mm = min_distance_mm(info);
  keeping.max_shift_mm = 2 * limit_mm(info, deviation_mm);
  keeping.is_closed = border == Border::closed;
  return keeping;
}

// Includes one voxel more than the kernel, whose distance is the limit, as for all voxels beyond.
std::array<std::uint32_t, 3> SmoothedVolume::reach(const SampleGrid& info, double deviation_mm) {
  auto voxels = meshing::reach(grid_of(info), limit_mm(info, deviation_mm));
  for (std::uint32_t& each : voxels) ++each;
  return voxels;
}

// The first blur still has a slice's distances three deviations later.
void SmoothedVolume::read_slice(void* samples) {
  auto* result = static_cast<float*>(samples);
  twice_.next(result);
  const float* once = twice_.sharp();
  const float* distances = once_.sharp(slices_++);
  const auto min_distance = static_cast<float>(min_distance_mm(info_));
  for (std::size_t i = 0; i < std::size_t{info_.dims[0]} * info_.dims[1]; ++i) {
    const float smooth = 2 * once[i] - result[i];
    result[i] = distances[i] > 0 ? std::max(smooth, min_distance) : std::min(smooth, -min_distance);
  }
}

void SmoothedVolume::read_mask(float* mask) {
  const std::uint8_t* row = selected_.next_slice();
  for (std::uint32_t y = 0; y < info_.dims[1]; ++y, row += bit_row_bytes(info_.dims[0]))
    for (std::uint32_t x = 0; x < info_.dims[0]; ++x)
      *mask++ = static_cast<float>(unsigned{row[x / 8]} >> x % 8 & 1U);
}

double steps_mm(const SampleGrid& info) {
  const auto distances = info.distances_mm();
  const auto [min, max] = std::minmax_element(distances.begin(), distances.end());
  constexpr double equal = 1.01, of_equal = 1.5;
  return *max <= equal * *min ? of_equal * *max : *max;
}

double min_distance_mm(const SampleGrid& info) {
  constexpr double voxels = 0.05;
  const auto distances = info.distances_mm();
  return voxels * *std::min_element(distances.begin(), distances.end());
}

}  // namespace discmc::meshing
