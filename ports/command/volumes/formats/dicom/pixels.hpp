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

/// Reads frames, one at a time. The file of the last one stays open for the next.
class DicomPixels {
 public:
  DicomPixels();
  ~DicomPixels();

  /// Writes the samples as they are stored, in native byte order. Bits beyond those of a sample,
  /// such as overlays, are cleared, or copies of its sign. Size: of samples, that of the frame.
  /// Throws VolumeError when they are not there or damaged.
  void read(const DicomFrame& frame, void* samples);

  /// The pictures that the file of the last frame has beyond those that its header counts.
  std::uint64_t left_out() const { return left_out_; }

 private:
  // Into decoded_, as the samples are stored.
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
  bool is_decoded_ = false;  ///< the picture of the open file, if it is the only one
  std::vector<unsigned char> decoded_;
};

}  // namespace discmc::command
