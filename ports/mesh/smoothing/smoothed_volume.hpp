// A mask without the steps of its voxels.
#ifndef DISCMC_MESH_SMOOTHING_SMOOTHED_VOLUME_HPP
#define DISCMC_MESH_SMOOTHING_SMOOTHED_VOLUME_HPP

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "extraction/selected_bits.hpp"
#include "gaussian_blur.hpp"
#include "samples/slice_reader.hpp"
#include "signed_distance.hpp"

namespace discmc::meshing {

/// The voxels that are selected, as samples: the distance to their surface, smoothed, positive
/// inside. The smooth surface is that of threshold 0. It keeps its volume and parts of two voxels,
/// unlike that of a blurred mask: a blur G draws a bent surface inwards, and 2G - GG, which is
/// taken here, to the next order does not. Units: millimetres.
///
/// Memory: about 36 slices of float for a deviation of one slice.
class SmoothedVolume final : public SliceReader {
 public:
  /// volume: not yet read; mask: or none; both have to live as long as this. deviation_mm: of G.
  SmoothedVolume(SliceReader& volume, const Selection& selection, SliceReader* mask,
                 double deviation_mm);

  const SampleGrid& info() const override { return info_; }
  void read_slice(void* samples) override;

  /// How far from the voxels that are selected others have a part in the surface. Units: voxels.
  static std::array<std::uint32_t, 3> reach(const SampleGrid& info, double deviation_mm);

  std::uint64_t not_numbers() const { return selected_.not_numbers(); }
  /// The voxels inside, of the slices that were read: before, and after.
  std::uint64_t selected_voxels() const { return selected_voxels_; }
  std::uint64_t smooth_voxels() const { return smooth_voxels_; }

 private:
  void read_mask(float* mask);

  SelectedBits selected_;
  SampleGrid info_;
  SignedDistance distance_;
  GaussianBlur once_, twice_;
  std::uint64_t selected_voxels_ = 0;
  std::uint64_t smooth_voxels_ = 0;
};

/// The deviation that removes the steps of voxels with this spacing: the largest distance.
double steps_mm(const SampleGrid& info);

}  // namespace discmc::meshing

#endif
