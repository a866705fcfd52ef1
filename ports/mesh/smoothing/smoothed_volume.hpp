// A mask without the steps of its voxels.
#ifndef DISCMC_MESH_SMOOTHING_SMOOTHED_VOLUME_HPP
#define DISCMC_MESH_SMOOTHING_SMOOTHED_VOLUME_HPP

#include <array>
#include <cstdint>
#include <discmc/limits.hpp>
#include <memory>
#include <vector>

#include "extraction/selected_bits.hpp"
#include "gaussian_blur.hpp"
#include "kept_volumes.hpp"
#include "samples/slice_reader.hpp"
#include "signed_distance.hpp"

namespace discmc::meshing {

/// The voxels that are selected, as samples: the distance to their surface, smoothed, positive
/// inside. The smooth surface is that of threshold 0. A blur G draws a bent surface inwards, and
/// 2G - GG, which is taken here, to the next order does not. Every voxel keeps its side of the
/// surface, by min_distance_mm(): no part, gap or tunnel is lost. keep_volumes() then moves the
/// surface to keep the volume of each body. Units: millimetres.
///
/// Memory: about 36 slices of float for a deviation of one slice.
class SmoothedVolume final : public SliceReader {
 public:
  /// volume: not yet read; mask: or none; both have to live as long as this. deviation_mm: of G.
  SmoothedVolume(SliceReader& volume, const Selection& selection, SliceReader* mask,
                 double deviation_mm);

  const SampleGrid& info() const override { return info_; }
  void read_slice(void* samples) override;

  /// How keep_volumes() moves the surface of one such volume.
  static VolumeKeeping keeping(const SampleGrid& info, double deviation_mm, double tolerance,
                               Border border);

  /// How far from the voxels that are selected others have a part in the surface. Units: voxels.
  static std::array<std::uint32_t, 3> reach(const SampleGrid& info, double deviation_mm);

  std::uint64_t not_numbers() const { return selected_.not_numbers(); }

 private:
  void read_mask(float* mask);

  SelectedBits selected_;
  SampleGrid info_;
  SignedDistance distance_;
  GaussianBlur once_, twice_;
  std::uint32_t slices_ = 0;  // read
};

/// The deviation that removes the steps of voxels with this spacing: 1.5 voxels if the distances
/// are equal, otherwise the largest distance.
double steps_mm(const SampleGrid& info);

/// How near the smooth surface comes to a voxel: 1/20 of the least distance between voxels.
double min_distance_mm(const SampleGrid& info);

}  // namespace discmc::meshing

#endif
