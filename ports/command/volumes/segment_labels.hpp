// What 3D Slicer tells of the segments of a segmentation, as keys in the header of NRRD.
#ifndef DISCMC_COMMAND_VOLUMES_SEGMENT_LABELS_HPP
#define DISCMC_COMMAND_VOLUMES_SEGMENT_LABELS_HPP

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "label_table.hpp"

namespace discmc::host {

/// The keys Segment0_Name, Segment0_LabelValue and Segment0_Color, and those of further numbers.
class SegmentLabels {
 public:
  /// Takes a key and its value; of no use are other keys.
  void take(std::string_view key, std::string_view value);

  /// The segments with a name and a label that is a whole number; of equal labels one.
  LabelTable table() const;

 private:
  struct Segment {
    std::string name, label, colour;
  };
  std::map<std::string, Segment, std::less<>> segments_;  // by the key up to its _
};

}  // namespace discmc::host

#endif
