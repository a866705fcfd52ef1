// The size of a picture, for decoders.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_PICTURE_SIZE_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_PICTURE_SIZE_HPP

#include <cstdint>

namespace discmc::command {

/// The size of a picture of one component. Units: samples, and bytes of a sample: 1, 2 or 4.
struct PictureSize {
  std::uint32_t columns, rows, sample_bytes;
};

}  // namespace discmc::command

#endif
