// Pixels in RLE: a segment of PackBits for each byte of a sample (DICOM PS3.5, annex G).
//
// DCMTK does not decode it here: version 3.6.7 reads beyond a fragment if its header asks for that.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_RLE_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_RLE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "picture_size.hpp"

namespace discmc::command {

/// Decodes a frame into samples in native byte order. Size: of samples, that of the picture.
/// Returns what is wrong, empty if nothing.
std::string decode_rle(const std::vector<std::uint8_t>& bytes, PictureSize size,
                       unsigned char* samples);

}  // namespace discmc::command

#endif
