// A mask whose narrow gaps are closed.
#ifndef DISCMC_COMMAND_SMOOTHING_CLOSED_VOLUME_HPP
#define DISCMC_COMMAND_SMOOTHING_CLOSED_VOLUME_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bit_dilation.hpp"
#include "extraction/selected_bits.hpp"
#include "volumes/volume_reader.hpp"

namespace discmc::command {

/// The voxels that are selected, dilated by a ball and then eroded by it: 1, all others 0. Gaps in
/// which the ball has no room are closed; nothing else changes, also at the ends of the volume, as
/// all beyond counts as off. Memory: as two of BitDilation.
class ClosedVolume final : public VolumeReader {
 public:
  /// volume: not yet read; mask: or none; both have to live as long as this.
  ClosedVolume(VolumeReader& volume, const Selection& selection, VolumeReader* mask,
               double radius_mm);

  const VolumeInfo& info() const override { return info_; }
  const std::vector<std::string>& notes() const override { return volume_.notes(); }
  void read_slice(void* samples) override;

  std::uint64_t not_numbers() const { return selected_.not_numbers(); }

 private:
  void read_padded(std::uint64_t* bits);
  void read_complement(std::uint64_t* bits);

  VolumeReader& volume_;
  SelectedBits selected_;
  VolumeInfo info_;
  VoxelBall ball_;
  BitGrid padded_;  // so that no ball around a voxel of the volume reaches beyond its ends
  std::uint32_t padded_slices_ = 0;  // read
  std::uint32_t slices_ = 0;         // written
  BitDilation dilation_, erosion_;   // erosion: dilates what is off
  std::vector<std::uint64_t> eroded_;
};

}  // namespace discmc::command

#endif
