// Voxels that are on, spread by a ball.
#ifndef DISCMC_MESH_SMOOTHING_BIT_DILATION_HPP
#define DISCMC_MESH_SMOOTHING_BIT_DILATION_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "slice_window.hpp"

namespace discmc::meshing {

/// Slices of bits, rows in words of 64, the first voxel in the lowest bit.
struct BitGrid {
  std::array<std::uint32_t, 3> dims;

  std::size_t row_words() const { return (std::size_t{dims[0]} + 63) / 64; }
  std::size_t slice_words() const { return row_words() * dims[1]; }
};

/// The voxels around one that are within a radius of it.
struct VoxelBall {
  /// The greatest radius: beyond it memory and time are out of proportion.
  static constexpr double max_reach = 64;

  /// How far it reaches along each axis. Units: voxels
  std::array<std::uint32_t, 3> reach;
  /// How far along x, by distance along y and z: width[z][y]; negative where it does not reach.
  std::vector<std::vector<std::int32_t>> width;

  VoxelBall(double radius_mm, const std::array<double, 3>& spacing_mm);
};

/// Dilates: a voxel is on where one within the ball is. Beyond the ends of the volume all are off.
/// Memory: the bits of the slices within the radius, once for each voxel of the radius along x.
class BitDilation {
 public:
  /// Writes the next slice.
  using Source = std::function<void(std::uint64_t*)>;

  BitDilation(const BitGrid& grid, VoxelBall ball, Source source);

  /// Writes the next slice, dilated.
  void next(std::uint64_t* dilated);

 private:
  void add_slice();
  // Rows of a slice that was added, spread along x.
  const std::uint64_t* spread(std::uint32_t z, std::int32_t width, std::uint32_t y) const;

  BitGrid grid_;
  VoxelBall ball_;
  Source source_;
  SliceWindow<std::uint64_t> window_;
  std::uint32_t next_ = 0;
};

}  // namespace discmc::meshing

#endif
