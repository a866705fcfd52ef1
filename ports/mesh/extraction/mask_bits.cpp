#include "mask_bits.hpp"

namespace discmc::meshing {

MaskBits::MaskBits(SliceReader& mask)
    : mask_(mask),
      selector_(mask.info(), {1}),
      slice_(mask.info().slice_bytes()),
      bits_(bit_row_bytes(mask.info().dims[0]) * mask.info().dims[1]) {}

const std::uint8_t* MaskBits::next_slice() {
  mask_.read_slice(slice_.data());
  selector_.select(slice_.data(), bits_.data(), bit_row_bytes(mask_.info().dims[0]));
  return bits_.data();
}

}  // namespace discmc::meshing
