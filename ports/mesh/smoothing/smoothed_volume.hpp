// Smooths the steps of a mask's voxels.
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

/// Returns the smoothed distance to the surface of the selected voxels, positive inside. The smooth
/// surface has the threshold 0. A blur G moves a curved surface inwards; 2G - GG, used here, does
/// not to the next order. Every voxel keeps its side of the surface, by min_distance_mm(), so no
/// part, gap or tunnel is lost. keep_volumes() then moves the surface to keep the volume of each
/// body. Units: millimetres.
///
/// Memory: about 36 slices of float for a deviation of one slice.
class SmoothedVolume final : public SliceReader {
 public:
  /// volume: not yet read. mask: may be null. Both must outlive this. deviation_mm: of G.
  SmoothedVolume(SliceReader& volume, const Selection& selection, SliceReader* mask,
                 double deviation_mm);

  const SampleGrid& info() const override { return info_; }
  void read_slice(void* samples) override;

  /// Returns the settings with which keep_volumes() moves the surface of such a volume.
  static VolumeKeeping keeping(const SampleGrid& info, double deviation_mm, double tolerance,
                               Border border);

  /// Returns the distance from the selected voxels within which other voxels affect the surface.
  /// Units: voxels.
  static std::array<std::uint32_t, 3> reach(const SampleGrid& info, double deviation_mm);

  std::uint64_t not_numbers() const { return selected_.not_numbers(); }

 private:
  void read_mask(float* mask);

  SelectedBits selected_;
  SampleGrid info_;
  SignedDistance distance_;
  GaussianBlur once_, twice_;
  std::uint32_t slices_ = 0;  // number read
};

/// Returns the deviation that removes the steps of voxels: 1.5 voxels if all spacings are equal,
/// otherwise the largest spacing.
double steps_mm(const SampleGrid& info);

/// Returns the least distance between the smooth surface and a voxel: 1/20 of the smallest spacing.
double min_distance_mm(const SampleGrid& info);

}  // namespace discmc::meshing

#endif
