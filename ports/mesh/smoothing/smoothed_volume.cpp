#include "smoothed_volume.hpp"

#include <algorithm>

namespace discmc::meshing {
namespace {

// Distances beyond four deviations have no part in the surface.
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

// One more, whose distance is the limit as that of all beyond.
std::array<std::uint32_t, 3> SmoothedVolume::reach(const SampleGrid& info, double deviation_mm) {
  auto voxels = meshing::reach(grid_of(info), limit_mm(info, deviation_mm));
  for (std::uint32_t& each : voxels) ++each;
  return voxels;
}

void SmoothedVolume::read_slice(void* samples) {
  auto* result = static_cast<float*>(samples);
  twice_.next(result);
  const float* once = twice_.sharp();
  for (std::size_t i = 0; i < std::size_t{info_.dims[0]} * info_.dims[1]; ++i) {
    result[i] = 2 * once[i] - result[i];
    smooth_voxels_ += result[i] >= 0 ? 1 : 0;
  }
}

void SmoothedVolume::read_mask(float* mask) {
  const std::uint8_t* row = selected_.next_slice();
  for (std::uint32_t y = 0; y < info_.dims[1]; ++y, row += bit_row_bytes(info_.dims[0]))
    for (std::uint32_t x = 0; x < info_.dims[0]; ++x) {
      const unsigned is_on = unsigned{row[x / 8]} >> x % 8 & 1U;
      *mask++ = static_cast<float>(is_on);
      selected_voxels_ += is_on;
    }
}

double steps_mm(const SampleGrid& info) {
  const auto distances = info.distances_mm();
  return *std::max_element(distances.begin(), distances.end());
}

}  // namespace discmc::meshing
