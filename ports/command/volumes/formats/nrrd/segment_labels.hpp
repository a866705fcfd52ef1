// What 3D Slicer tells of the segments of a segmentation, as keys in the header of NRRD.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_SEGMENT_LABELS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_SEGMENT_LABELS_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "volumes/volume_info.hpp"

namespace discmc::command {

/// The keys Segment0_Name, Segment0_LabelValue, Segment0_Color and Segment0_Layer, and those of
/// further numbers.
class SegmentLabels {
 public:
  /// Takes a key and its value; of no use are other keys.
  void take(std::string_view key, std::string_view value);

  /// The segments with a name and a label that is a whole number. layer: the one that is read,
  /// where that is known. A label that several segments have, in that layer, is none's; a note in
  /// info tells.
  LabelTable table(std::optional<std::uint32_t> layer, VolumeInfo& info) const;

 private:
  struct Segment {
    std::string name, label, colour, layer;
  };
  std::map<std::string, Segment, std::less<>> segments_;  // by the key up to its _
};

}  // namespace discmc::command

#endif
