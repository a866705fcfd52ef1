// The samples of DICOM frames.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_PIXELS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_PIXELS_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "image.hpp"

class DcmDataset;
class DcmElement;
class DcmFileFormat;

namespace discmc::command {

/// Reads frames, one at a time. The file of the last one stays open for the next.
class DicomPixels {
 public:
  DicomPixels();
  ~DicomPixels();

  /// Writes the samples as they are stored, in native byte order; bits beyond those of a sample,
  /// such as overlays, are cleared, or copies of its sign. Size: of samples, that of the frame.
  /// Throws VolumeError when they are not there or damaged.
  void read(const DicomFrame& frame, void* samples);

 private:
  // Into decoded_. DCMTK decodes all but JPEG 2000.
  void read_floats(DcmElement& element, const DicomFrame& frame);
  void read_jpeg2000(DcmDataset& dataset, DcmElement& element, const DicomFrame& frame);
  void read_frame(DcmDataset& dataset, DcmElement& element, const DicomFrame& frame);

  std::unique_ptr<DcmFileFormat> opened_;
  std::shared_ptr<const DicomImage> image_;  ///< of the open file
  std::uint32_t next_frame_ = 0;
  std::uint32_t next_fragment_ = 0;
  std::vector<unsigned char> decoded_;
};

}  // namespace discmc::command

#endif
