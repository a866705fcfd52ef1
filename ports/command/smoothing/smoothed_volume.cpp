#include "smoothed_volume.hpp"

#include <algorithm>
#include <cmath>

namespace discmc::command {
namespace {

// Distances beyond four deviations have no part in the surface.
double limit_mm(const VolumeInfo& info, double deviation_mm) {
  return std::max(4 * deviation_mm, steps_mm(info));
}

Grid grid_of(const VolumeInfo& info) {
  Grid grid{info.dims, info.spacing_mm};
  for (double& spacing : grid.spacing_mm) spacing = std::fabs(spacing);
  return grid;
}

VolumeInfo info_of_distances(VolumeInfo info) {
  info.type = SampleType::f32;
  info.slope = 1;
  info.intercept = 0;
  info.padding.reset();
  info.is_in_hounsfield = false;
  return info;
}

}  // namespace

SmoothedVolume::SmoothedVolume(VolumeReader& volume, const Selection& selection, VolumeReader* mask,
                               double deviation_mm)
    : volume_(volume),
      selector_(volume.info(), selection),
      mask_(mask == nullptr ? nullptr : std::make_unique<MaskBits>(*mask)),
      info_(info_of_distances(volume.info())),
      slice_(volume.info().slice_bytes()),
      bits_(bit_row_bytes(info_.dims[0]) * info_.dims[1]),
      distance_(grid_of(info_), limit_mm(info_, deviation_mm),
                [this](float* mask_slice) { read_mask(mask_slice); }),
      once_(grid_of(info_), deviation_mm, [this](float* slice) { distance_.next(slice); }),
      twice_(grid_of(info_), deviation_mm, [this](float* slice) { once_.next(slice); }) {}

// One more, whose distance is the limit as that of all beyond.
std::array<std::uint32_t, 3> SmoothedVolume::reach(const VolumeInfo& info, double deviation_mm) {
  auto voxels = command::reach(grid_of(info), limit_mm(info, deviation_mm));
  for (std::uint32_t& each : voxels) ++each;
  return voxels;
}

void SmoothedVolume::read_slice(void* samples) {
  auto* result = static_cast<float*>(samples);
  twice_.next(result);
  const float* once = twice_.sharp();
  for (std::size_t i = 0; i < std::size_t{info_.dims[0]} * info_.dims[1]; ++i)
    result[i] = 2 * once[i] - result[i];
}

void SmoothedVolume::read_mask(float* mask) {
  volume_.read_slice(slice_.data());
  const std::size_t row_bytes = bit_row_bytes(info_.dims[0]);
  not_numbers_ += selector_.select(slice_.data(), bits_.data(), row_bytes);
  if (mask_) keep_masked(bits_.data(), mask_->next_slice(), bits_.size());
  for (std::size_t row = 0; row < bits_.size(); row += row_bytes)
    for (std::uint32_t x = 0; x < info_.dims[0]; ++x)
      *mask++ = static_cast<float>(bits_[row + x / 8] >> x % 8 & 1);
}

double steps_mm(const VolumeInfo& info) {
  double largest = 0;
  for (const double spacing : info.spacing_mm) largest = std::max(largest, std::fabs(spacing));
  return largest;
}

}  // namespace discmc::command
