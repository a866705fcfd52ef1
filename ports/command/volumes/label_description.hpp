// The names and colours of the labels of a segmentation.
#ifndef DISCMC_COMMAND_VOLUMES_LABEL_DESCRIPTION_HPP
#define DISCMC_COMMAND_VOLUMES_LABEL_DESCRIPTION_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meshing.hpp"
#include "pictures/srgb.hpp"
#include "samples/label_value.hpp"

namespace discmc::command {

struct LabelDescription {
  std::string name;
  std::optional<Srgb> colour{};
  /// That its voxels have: several of a region of nnU-Net. None means all but 0.
  std::vector<LabelValue> values{};
  /// The volume of the file that it is in, as VolumeOptions::frame counts: labels that overlap are
  /// in several.
  std::uint32_t layer = 0;
};

/// The descriptions of labels, in the order of the file.
using LabelTable = std::vector<LabelDescription>;

}  // namespace discmc::command

#endif
