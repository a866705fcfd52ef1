// Makes bits of the voxels of a volume that are on.
#ifndef DISCMC_MESH_EXTRACTION_SELECTED_BITS_HPP
#define DISCMC_MESH_EXTRACTION_SELECTED_BITS_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "mask_bits.hpp"
#include "samples/slice_reader.hpp"
#include "selection.hpp"

namespace discmc::meshing {

/// Reads a volume slice by slice, and keeps voxels that are selected and in the mask.
class SelectedBits {
 public:
  /// volume: not yet read. mask: may be null. Both must outlive this.
  SelectedBits(SliceReader& volume, const Selection& selection, SliceReader* mask);

  /// Returns the rows of the next slice, bit_row_bytes() each. Valid until the next call.
  const std::uint8_t* next_slice();

  /// Returns the number of NaN samples, which count as off.
  std::uint64_t not_numbers() const { return not_numbers_; }

 private:
  SliceReader& volume_;
  SliceSelector selector_;
  std::unique_ptr<MaskBits> mask_;
  std::vector<std::uint8_t> slice_, bits_;
  std::uint64_t not_numbers_ = 0;
};

/// Returns the description of a volume whose samples are made from these bits.
SampleGrid info_of_mask(SampleGrid info, SampleType type);

}  // namespace discmc::meshing

#endif
