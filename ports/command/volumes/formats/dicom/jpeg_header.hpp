// The size of a picture in JPEG, by its own header.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_JPEG_HEADER_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_JPEG_HEADER_HPP

#include <cstddef>
#include <cstdint>
#include <string>

#include "picture_size.hpp"

namespace discmc::command {

/// Compares JPEG, other than JPEG 2000, with the size that the file declares. DCMTK compares only
/// JPEG-LS, and leaves what a smaller picture lacks. Returns what is wrong, empty if nothing.
std::string jpeg_mismatch(const std::uint8_t* bytes, std::size_t count, PictureSize size);

}  // namespace discmc::command

#endif
