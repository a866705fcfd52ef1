// The header of an NRRD file, where its volume lies, and what 3D Slicer stores about segments:
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

/// The keys Segment0_Name, Segment0_LabelValue, Segment0_Color and Segment0_Layer, and those of
/// further numbers.
class SegmentLabels {
 public:
  /// Takes a key and its value; of no use are other keys.
  void take(std::string_view key, std::string_view value);

  /// Adds the segments that have a name and are in one of the volumes of the file, with a note of
  /// those that are not. info: its frames are known.
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
  HeaderFields fields;  ///< by the first of their spellings, in lower case
  SegmentLabels segments{};
  bool closed = false;  ///< by the empty line that data may follow
};

/// Reads the header, or up to a list of data files, which is its rest.
NrrdHeader read_nrrd_header(ByteStream& stream);

/// Whether a word of the header is one of those.
inline bool one_of(std::string_view text, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), text) != names.end();
}

/// Throws the refusal of an axis that is none of space. what: follows the number of the axis.
[[noreturn]] void fail_axis(const HeaderFields& fields, std::size_t axis, const std::string& what);

/// As the header declares it: by directions, spacings, bounds of axes or thicknesses. info: with
/// the extents; gets the notes.
DeclaredPlace nrrd_place(VolumeInfo& info, const HeaderFields& fields);

}  // namespace discmc::command
