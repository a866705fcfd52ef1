// Decoders of packed pixels: DCMTK for JPEG and JPEG-LS, OpenJPEG for JPEG 2000, own code for RLE
// (DICOM PS3.5, annex G). DCMTK 3.6.7 can read beyond a fragment of RLE.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class DcmDataset;
class DcmPixelItem;
class DcmPixelSequence;

namespace discmc::command {

/// The size of a picture of one component. Units: samples; bytes per sample: 1, 2 or 4.
struct PictureSize {
  std::uint32_t columns, rows, sample_bytes;
};

/// Decodes a frame of a data set into samples in native byte order. Size: of samples, that of the
/// picture. Returns what is wrong; empty if nothing.
std::string decode_jpeg(const std::vector<std::uint8_t>& bytes, PictureSize size,
                        DcmDataset& dataset, unsigned char* samples);

/// Decodes a code stream into samples in native byte order, cut to their bytes. Size: of samples,
/// that of the picture. Returns what is wrong; empty if nothing.
std::string decode_jpeg2000(const std::vector<std::uint8_t>& bytes, PictureSize size,
                            unsigned char* samples);

/// Decodes a frame into samples in native byte order. Size: of samples, that of the picture.
/// Returns what is wrong; empty if nothing.
std::string decode_rle(const std::vector<std::uint8_t>& bytes, PictureSize size,
                       unsigned char* samples);

/// The fragments of compressed pixel data, and the frame of each. Lists them once, because DCMTK
/// counts from the first fragment at every access.
class DicomFragments {
 public:
  /// Owner of the sequence: the file, which stays open. frames: the number in the header.
  DicomFragments(DcmPixelSequence& sequence, std::uint32_t frames);

  /// Reads all fragments of a frame into bytes. Returns what is wrong; empty if nothing.
  std::string read(std::uint32_t frame, std::vector<std::uint8_t>& bytes);

  /// Returns the number of frames beyond the header's count, if offsets are missing.
  std::size_t left_out() const { return left_out_; }

 private:
  void set_starts_by_table(std::uint32_t frames);
  void set_starts_by_jpeg(std::uint32_t frames);
  const std::uint8_t* content(std::size_t fragment);

  std::vector<DcmPixelItem*> items_;  ///< the first item is the table of offsets
  std::vector<std::size_t> starts_;   ///< in items_, per frame, and the end; empty: unknown
  std::size_t left_out_ = 0;
};

}  // namespace discmc::command
