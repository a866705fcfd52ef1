// The on voxels of a whole volume.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "memory_volume.hpp"

namespace discmc::web {

/// Rows of bits like those of Extractor::push_bits(): eight voxels per byte, the first in bit 0.
class VoxelBits {
 public:
  /// A voxel is on if its value is >= iso. Memory: an eighth of a byte per voxel.
  void select(const MemoryVolume& volume, double iso);
  /// Removes noise: see majority_filter.hpp. Limit: after select().
  void filter();

  std::uint32_t rows() const { return height_ * depth_; }
  const std::uint8_t* row(std::uint32_t number) const { return bits_.data() + number * row_bytes_; }
  bool at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return (row(z * height_ + y)[x / 8] >> x % 8 & 1) != 0;
  }

 private:
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::uint32_t depth_ = 0;
  std::size_t row_bytes_ = 0;
  std::vector<std::uint8_t> bits_;
};

}  // namespace discmc::web
