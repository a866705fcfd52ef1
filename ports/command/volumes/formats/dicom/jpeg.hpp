// Pixels in JPEG and JPEG-LS, by DCMTK.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_JPEG_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_JPEG_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "picture_size.hpp"

class DcmDataset;

namespace discmc::command {

/// Decodes a frame of a data set into samples in native byte order. Size: of samples, that of the
/// picture. Returns what is wrong, empty if nothing.
std::string decode_jpeg(const std::vector<std::uint8_t>& bytes, PictureSize size,
                        DcmDataset& dataset, unsigned char* samples);

}  // namespace discmc::command

#endif
