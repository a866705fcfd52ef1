// The samples of DICOM frames.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image.hpp"

class DcmDataset;
class DcmElement;
class DcmFileFormat;

namespace discmc::command {

class DicomFragments;
struct StoredPicture;

/// Reads frames, one at a time. The last file stays open for the next frame.
class DicomPixels {
 public:
  DicomPixels();
  ~DicomPixels();

  /// Writes the samples as stored, in native byte order. Bits outside a sample, such as overlays,
  /// become 0 or copies of its sign. Size: of samples, that of the frame. Throws VolumeError if
  /// they are missing or damaged.
  void read(const DicomFrame& frame, void* samples);

  /// Returns the number of pictures beyond the header's count in the last frame's file.
  std::uint64_t left_out() const { return left_out_; }

 private:
  // Decodes into decoded_, in the stored form.
  void decode(const StoredPicture& picture);
  void read_bytes(DcmElement& element, const StoredPicture& picture, std::uint64_t begin,
                  std::uint64_t bytes);
  void read_bits(DcmDataset& dataset, DcmElement& element, const StoredPicture& picture);
  void read_compressed(DcmDataset& dataset, DcmElement& element, const StoredPicture& picture);
  void read_uncompressed(DcmDataset& dataset, DcmElement& element, const StoredPicture& picture);

  std::unique_ptr<DcmFileFormat> opened_;
  std::shared_ptr<const DicomImage> image_;    ///< of the open file
  std::unique_ptr<DicomFragments> fragments_;  ///< of the open file, if it is compressed
  std::vector<std::uint8_t> compressed_;
  std::uint64_t left_out_ = 0;
  bool is_decoded_ = false;  ///< whether decoded_ has the only picture of the open file
  std::vector<unsigned char> decoded_;
};

}  // namespace discmc::command
