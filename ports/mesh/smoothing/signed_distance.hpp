// How far each voxel is from the surface of a mask.
#ifndef DISCMC_MESH_SMOOTHING_SIGNED_DISTANCE_HPP
#define DISCMC_MESH_SMOOTHING_SIGNED_DISTANCE_HPP

#include <cstdint>
#include <vector>

#include "slice_window.hpp"

namespace discmc::meshing {

/// The distance from each voxel to the nearest midpoint between an on and an off voxel: to a vertex
/// of the merged surface. Exact up to a limit, which replaces all larger distances. Positive
/// inside. There are no midpoints at the ends of the volume. Units: millimetres.
///
/// Midpoints lie in planes: in a slice, or between two slices. In each plane distances are found
/// along one axis, then along the other, then across the planes. Memory: three times the slices
/// within the limit.
class SignedDistance {
 public:
  /// mask: 1 for an on voxel, else 0. limit_mm: at least a voxel.
  SignedDistance(const Grid& grid, double limit_mm, SliceSource mask);

  /// Writes the distances of the next slice.
  void next(float* distances);

 private:
  void add_slice();
  void find_along_rows(const float* mask, float* squares);
  void find_along_columns(const float* mask, float* squares);
  void find_between(const float* below, const float* above, float* squares);
  void spread_to_columns(float* squares);
  void spread_to_rows(float* squares);

  std::uint32_t width_, height_;
  std::array<float, 3> spacing_;
  float limit_squared_;
  std::array<std::uint32_t, 3> reach_;  // of the limit; Units: voxels
  SliceSource mask_;
  SliceWindow<float> masks_, in_slices_, between_;
  std::vector<float> found_;  // of a plane: squared distances along one axis
  std::uint32_t next_ = 0;
};

}  // namespace discmc::meshing

#endif
