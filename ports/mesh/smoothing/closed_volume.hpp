// Closes narrow gaps of a mask.
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

/// Returns 1 for the selected voxels, dilated by a ball and then eroded by it, otherwise 0. This
/// closes gaps without room for the ball, and changes nothing else. At the ends of the volume, all
/// outside counts as off. Memory: as two BitDilation objects.
class ClosedVolume final : public SliceReader {
 public:
  /// volume: not yet read. mask: may be null. Both must outlive this.
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
  BitGrid padded_;                   // no ball around a voxel of the volume reaches beyond it
  std::uint32_t padded_slices_ = 0;  // number read
  std::uint32_t slices_ = 0;         // number written
  BitDilation dilation_, erosion_;   // erosion_ dilates the voxels that are off
  std::vector<std::uint64_t> eroded_;
};

}  // namespace discmc::meshing

#endif
