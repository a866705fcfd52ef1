// A mask whose narrow gaps are closed.
#ifndef DISCMC_MESH_SMOOTHING_CLOSED_VOLUME_HPP
#define DISCMC_MESH_SMOOTHING_CLOSED_VOLUME_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bit_dilation.hpp"
#include "extraction/selected_bits.hpp"
#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// The voxels that are selected, dilated by a ball and then eroded by it: 1, all others 0. Gaps
/// without room for the ball are closed. Nothing else changes, also at the ends of the volume, as
/// all beyond counts as off. Memory: as two of BitDilation.
class ClosedVolume final : public SliceReader {
 public:
  /// volume: not yet read; mask: or none; both have to live as long as this.
  ClosedVolume(SliceReader& volume, const Selection& selection, SliceReader* mask,
               double radius_mm);

  const SampleGrid& info() const override { return info_; }
  void read_slice(void* samples) override;

  std::uint64_t not_numbers() const { return selected_.not_numbers(); }

 private:
  void read_padded(std::uint64_t* bits);
  void read_complement(std::uint64_t* bits);

  SelectedBits selected_;
  SampleGrid info_;
  VoxelBall ball_;
  BitGrid padded_;  // so that no ball around a voxel of the volume reaches beyond its ends
  std::uint32_t padded_slices_ = 0;  // read
  std::uint32_t slices_ = 0;         // written
  BitDilation dilation_, erosion_;   // erosion: dilates what is off
  std::vector<std::uint64_t> eroded_;
};

}  // namespace discmc::meshing

#endif
