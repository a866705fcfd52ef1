#include "selected_bits.hpp"

namespace discmc::meshing {

SelectedBits::SelectedBits(SliceReader& volume, const Selection& selection, SliceReader* mask)
    : volume_(volume),
      selector_(volume.info(), selection),
      mask_(mask == nullptr ? nullptr : std::make_unique<MaskBits>(*mask)),
      slice_(volume.info().slice_bytes()),
      bits_(bit_row_bytes(volume.info().dims[0]) * volume.info().dims[1]) {}

const std::uint8_t* SelectedBits::next_slice() {
  volume_.read_slice(slice_.data());
  not_numbers_ +=
      selector_.select(slice_.data(), bits_.data(), bit_row_bytes(volume_.info().dims[0]));
  if (mask_) keep_masked(bits_.data(), mask_->next_slice(), bits_.size());
  return bits_.data();
}

SampleGrid info_of_mask(SampleGrid info, SampleType type) {
  info.type = type;
  info.slope = 1;
  info.intercept = 0;
  return info;
}

}  // namespace discmc::meshing
