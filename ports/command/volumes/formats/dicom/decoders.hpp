// Pixels that are packed: JPEG and JPEG-LS by DCMTK, JPEG 2000 by OpenJPEG, RLE (DICOM PS3.5, annex
// G) by neither. DCMTK 3.6.7 reads beyond a fragment of RLE if its header asks for that.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class DcmDataset;

namespace discmc::command {

/// The size of a picture of one component. Units: samples, and bytes of a sample: 1, 2 or 4.
struct PictureSize {
  std::uint32_t columns, rows, sample_bytes;
};

/// Decodes a frame of a data set into samples in native byte order. Size: of samples, that of the
/// picture. Returns what is wrong, empty if nothing.
std::string decode_jpeg(const std::vector<std::uint8_t>& bytes, PictureSize size,
                        DcmDataset& dataset, unsigned char* samples);

/// Decodes a code stream into samples in native byte order, cut to their bytes.
/// Size: of samples, that of the picture. Returns what is wrong, empty if nothing.
std::string decode_jpeg2000(const std::vector<std::uint8_t>& bytes, PictureSize size,
                            unsigned char* samples);

/// Decodes a frame into samples in native byte order. Size: of samples, that of the picture.
/// Returns what is wrong, empty if nothing.
std::string decode_rle(const std::vector<std::uint8_t>& bytes, PictureSize size,
                       unsigned char* samples);

}  // namespace discmc::command
