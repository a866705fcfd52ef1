// Slices in the same place, as of several times, echoes or phases, separated.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_SEPARATION_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_SEPARATION_HPP

#include <string>
#include <vector>

#include "image.hpp"

namespace discmc::command {

/// Frames of which no two lie in the same place, or that nothing separates.
struct SeparatedFrames {
  std::vector<DicomFrame> frames;
  /// If only an order separates them, not a trait: "number 2 by trigger time".
  std::string order;
};

/// Separates frames with places and one direction. Copies of one object count once, but where all
/// frames stay together.
std::vector<SeparatedFrames> separated(const std::vector<DicomFrame>& frames);

}  // namespace discmc::command

#endif
