// The voxels of a volume that are on, as bits.
#ifndef DISCMC_COMMAND_EXTRACTION_SELECTED_BITS_HPP
#define DISCMC_COMMAND_EXTRACTION_SELECTED_BITS_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "mask_bits.hpp"
#include "selection.hpp"
#include "volumes/volume_reader.hpp"

namespace discmc::command {

/// Reads a volume slice by slice, and keeps what is selected and in the mask.
class SelectedBits {
 public:
  /// volume: not yet read; mask: or none; both have to live as long as this.
  SelectedBits(VolumeReader& volume, const Selection& selection, VolumeReader* mask);

  /// The rows of the next slice, bit_row_bytes() each. Valid until the next call.
  const std::uint8_t* next_slice();

  /// Samples that were not a number, and taken as off.
  std::uint64_t not_numbers() const { return not_numbers_; }

 private:
  VolumeReader& volume_;
  SliceSelector selector_;
  std::unique_ptr<MaskBits> mask_;
  std::vector<std::uint8_t> slice_, bits_;
  std::uint64_t not_numbers_ = 0;
};

/// The description of a volume of samples of another kind that are made of these bits.
VolumeInfo info_of_mask(VolumeInfo info, SampleType type);

}  // namespace discmc::command

#endif
