#include "voxel_bits.hpp"

#include <cstring>

#include "extraction/own_filter.hpp"
#include "extraction/selection.hpp"

namespace discmc::web {

void VoxelBits::select(const MemoryVolume& volume, double iso) {
  const command::VolumeInfo& info = volume.info();
  width_ = info.dims[0];
  height_ = info.dims[1];
  depth_ = info.dims[2];
  row_bytes_ = meshing::bit_row_bytes(width_);
  bits_.resize(row_bytes_ * rows());
  const meshing::SliceSelector selector(info, {iso});
  for (std::uint32_t z = 0; z < depth_; ++z)
    selector.select(volume.slice(z), bits_.data() + z * height_ * row_bytes_, row_bytes_);
}

// In place, because a row is returned long after it was added.
void VoxelBits::filter() {
  meshing::OwnFilter own({width_, height_});
  std::uint8_t* next = bits_.data();
  const auto keep = [&](const std::uint8_t* filtered) {
    if (filtered == nullptr) return false;
    std::memcpy(next, filtered, row_bytes_);
    next += row_bytes_;
    return true;
  };
  for (std::uint32_t number = 0; number < rows(); ++number) keep(own.filter.push(row(number)));
  while (keep(own.filter.drain())) {
  }
}

}  // namespace discmc::web
