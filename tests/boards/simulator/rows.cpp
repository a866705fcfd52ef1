#include "rows.hpp"

#include <rows/row_frame.hpp>
#include <stdexcept>
#include <string>

namespace discmc::simulator {

Rows::Rows(command::VolumeReader& volume) : info_(volume.info()) {
  if (bytes() > row_frame::max_samples)
    throw std::invalid_argument(
        "a row of the volume has " + std::to_string(bytes()) + " bytes and a frame takes " +
        std::to_string(row_frame::max_samples) + ": use a volume with narrower slices");
  if (std::uint64_t{info_.dims[1]} * info_.dims[2] >= UINT32_MAX)
    throw std::invalid_argument(
        "the volume has more rows than a frame can number: use a part of it");
  const std::size_t slice_bytes = info_.slice_bytes();
  samples_.resize(slice_bytes * info_.dims[2]);
  for (std::uint32_t z = 0; z < info_.dims[2]; ++z) volume.read_slice(&samples_[z * slice_bytes]);
}

}  // namespace discmc::simulator
