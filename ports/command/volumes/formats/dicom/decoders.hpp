// Pixels that are packed: JPEG and JPEG-LS by DCMTK, JPEG 2000 by OpenJPEG, RLE (DICOM PS3.5, annex
// G) by neither. DCMTK 3.6.7 reads beyond a fragment of RLE if its header asks for that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class DcmDataset;
class DcmPixelItem;
class DcmPixelSequence;

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

/// The fragments of compressed pixel data, and the frame that each belongs to. Lists them once:
/// DCMTK counts from the first fragment each time that one is asked for.
class DicomFragments {
 public:
  /// Owner of the sequence: the file, which stays open. frames: as the header counts.
  DicomFragments(DcmPixelSequence& sequence, std::uint32_t frames);

  /// Reads all fragments of a frame into bytes. Returns what is wrong, empty if nothing.
  std::string read(std::uint32_t frame, std::vector<std::uint8_t>& bytes);

  /// Frames beyond those that the header counts, if offsets are missing.
  std::size_t left_out() const { return left_out_; }

 private:
  void set_starts_by_table(std::uint32_t frames);
  void set_starts_by_jpeg(std::uint32_t frames);
  const std::uint8_t* content(std::size_t fragment);

  std::vector<DcmPixelItem*> items_;  ///< the first is the table of offsets
  std::vector<std::size_t> starts_;   ///< of frames, in items_, and the end; empty if unknown
  std::size_t left_out_ = 0;
};

}  // namespace discmc::command
