// The header of an NRRD file, the place of its volume, and 3D Slicer's segments:
// https://slicer.readthedocs.io/en/latest/developer_guide/modules/segmentations.html
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "volumes/declared_place.hpp"
#include "volumes/header_fields.hpp"
#include "volumes/volume_info.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

/// The keys Segment0_Name, Segment0_LabelValue, Segment0_Color and Segment0_Layer, also with other
/// numbers.
class SegmentLabels {
 public:
  /// Stores a key and its value; ignores other keys.
  void add(std::string_view key, std::string_view value);

  /// Adds the segments that have a name and belong to a volume of the file, and notes the others.
  /// info: its frames are set.
  void describe(VolumeInfo& info) const;

 private:
  struct Segment {
    std::string name, id, colour;
    std::optional<std::string> label, layer;
  };
  std::map<std::uint32_t, Segment> segments_;
  bool is_fractional_ = false;
};

struct NrrdHeader {
  HeaderFields fields;  ///< keyed by the first spelling, in lower case
  SegmentLabels segments{};
  bool closed = false;  ///< whether an empty line, which data may follow, ends it
};

/// Reads the header up to its end or to a list of data files.
NrrdHeader read_nrrd_header(ByteStream& stream);

/// Whether a word of the header is one of `names`.
inline bool one_of(std::string_view text, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), text) != names.end();
}

/// Throws VolumeError for an axis that is not an axis of space. what: follows the number of the
/// axis.
[[noreturn]] void fail_axis(const HeaderFields& fields, std::size_t axis, const std::string& what);

/// Returns the place declared by directions, spacings, bounds of axes or thicknesses. info: has the
/// extents, and receives notes.
DeclaredPlace nrrd_place(VolumeInfo& info, const HeaderFields& fields);

}  // namespace discmc::command
