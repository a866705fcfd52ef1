// Computes the distance of each voxel from the surface of a mask.
#ifndef DISCMC_MESH_SMOOTHING_SIGNED_DISTANCE_HPP
#define DISCMC_MESH_SMOOTHING_SIGNED_DISTANCE_HPP

#include <cstdint>
#include <vector>

#include "slice_window.hpp"

namespace discmc::meshing {

/// The distance from each voxel to the nearest midpoint between an on and an off voxel, which is a
/// vertex of the merged surface. Positive inside. Exact up to a limit, which replaces larger
/// distances. The ends of the volume have no midpoints. Units: millimetres.
///
/// Midpoints lie in planes: in a slice, or between two slices. Distances are computed within each
/// plane, along one axis and then the other, and finally across the planes. Memory: three times the
/// slices within the limit.
class SignedDistance {
 public:
  /// mask: 1 if the voxel is on, else 0. limit_mm: at least a voxel.
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
  std::vector<float> plane_distances_;  // of a plane: squared distances along one axis
  std::uint32_t next_ = 0;
};

}  // namespace discmc::meshing

#endif
