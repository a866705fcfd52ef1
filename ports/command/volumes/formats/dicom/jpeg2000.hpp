// Pixels in JPEG 2000, by OpenJPEG.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_JPEG2000_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_JPEG2000_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "picture_size.hpp"

namespace discmc::command {

/// Decodes a code stream into samples in native byte order, cut to their bytes.
/// Size: of samples, that of the picture. Returns what is wrong, empty if nothing.
std::string decode_jpeg2000(const std::vector<std::uint8_t>& bytes, PictureSize size,
                            unsigned char* samples);

}  // namespace discmc::command

#endif
