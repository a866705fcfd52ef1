// Reads a mask as bits, and applies it.
#ifndef DISCMC_MESH_EXTRACTION_MASK_BITS_HPP
#define DISCMC_MESH_EXTRACTION_MASK_BITS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "samples/slice_reader.hpp"
#include "selection.hpp"

namespace discmc::meshing {

/// Reads a mask of open_mask(), slice by slice. Memory: one slice.
class MaskBits {
 public:
  /// mask: must outlive this.
  explicit MaskBits(SliceReader& mask);

  /// Returns the rows of the next slice, bit_row_bytes() each. Valid until the next call.
  const std::uint8_t* next_slice();
  void skip_slice() { mask_.skip_slice(); }

 private:
  SliceReader& mask_;
  SliceSelector selector_;
  std::vector<std::uint8_t> slice_, bits_;
};

/// Clears the bits that are off in the mask.
template <class Mask>
void keep_masked(std::uint8_t* bits, Mask mask, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i, ++mask)
    bits[i] = static_cast<std::uint8_t>(bits[i] & *mask);
}

}  // namespace discmc::meshing

#endif
