// The segments of a DICOM segmentation.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_SEGMENTS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_SEGMENTS_HPP

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "pictures/srgb.hpp"

class DcmItem;

namespace discmc::command {

struct DicomSegment {
  std::string name;
  std::optional<Srgb> colour;
};

struct DicomSegments {
  /// Whether a frame holds one segment, as bits or as fractions, or the numbers of all segments.
  enum class Kind { bits, fractions, numbers };
  Kind kind = Kind::bits;
  /// The fraction of a whole voxel.
  std::uint32_t full = 1;
  /// Whether the file declares that no voxel is of two segments.
  bool are_disjoint = false;
  /// By their numbers.
  std::map<std::uint32_t, DicomSegment> all;
};

/// Reads the names and colours of the segments.
DicomSegments segments_of(DcmItem& dataset);

/// Returns the colour of CIELab values as DICOM encodes them, relative to the white of sRGB, as
/// those who write segmentations take them.
Srgb srgb_of_cielab(const std::array<std::uint16_t, 3>& encoded);

}  // namespace discmc::command

#endif
