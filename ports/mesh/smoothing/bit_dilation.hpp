// Dilates the voxels that are on by a ball.
#ifndef DISCMC_MESH_SMOOTHING_BIT_DILATION_HPP
#define DISCMC_MESH_SMOOTHING_BIT_DILATION_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "slice_window.hpp"

namespace discmc::meshing {

/// Slices of bits, with rows in words of 64, the first voxel in the lowest bit.
struct BitGrid {
  std::array<std::uint32_t, 3> dims;

  std::size_t row_words() const { return (std::size_t{dims[0]} + 63) / 64; }
  std::size_t slice_words() const { return row_words() * dims[1]; }
};

/// The voxels within a radius of the centre voxel.
struct VoxelBall {
  /// The largest radius; larger ones need excessive memory and time.
  static constexpr double max_reach = 64;

  /// The radius along each axis. Units: voxels
  std::array<std::uint32_t, 3> reach;
  /// The radius along x, by distance along y and z: width[z][y]; negative if none.
  std::vector<std::vector<std::int32_t>> width;

  VoxelBall(double radius_mm, const std::array<double, 3>& spacing_mm);
};

/// Dilates: a voxel is on if any voxel within the ball is on. Voxels outside the volume are off.
/// Memory: the bits of the slices within the radius, once per voxel of the radius along x.
class BitDilation {
 public:
  /// Writes the next slice.
  using Source = std::function<void(std::uint64_t*)>;

  BitDilation(const BitGrid& grid, VoxelBall ball, Source source);

  /// Writes the next slice, dilated.
  void next(std::uint64_t* dilated);

 private:
  void add_slice();
  // Returns a row of an added slice, spread along x.
  const std::uint64_t* spread(std::uint32_t z, std::int32_t width, std::uint32_t y) const;

  BitGrid grid_;
  VoxelBall ball_;
  Source source_;
  SliceWindow<std::uint64_t> window_;
  std::uint32_t next_ = 0;
};

}  // namespace discmc::meshing

#endif
