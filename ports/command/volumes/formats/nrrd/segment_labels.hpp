// What 3D Slicer stores about the segments of a segmentation, as keys in the header of NRRD:
// https://slicer.readthedocs.io/en/latest/developer_guide/modules/segmentations.html
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_SEGMENT_LABELS_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_SEGMENT_LABELS_HPP

#include <cstdint>
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

}  // namespace discmc::command

#endif
