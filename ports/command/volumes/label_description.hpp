// The names and colours of the labels of a segmentation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshing.hpp"
#include "pictures/srgb.hpp"
#include "samples/label_value.hpp"
#include "text/value_text.hpp"

namespace discmc::command {

struct LabelDescription {
  std::string name;
  std::optional<Srgb> colour{};
  /// The values of its voxels; several for a region of nnU-Net. Empty means all except 0.
  std::vector<LabelValue> values{};
  /// The volume of the file that contains the label, as VolumeOptions::frame counts. Overlapping
  /// labels are in several volumes.
  std::uint32_t layer = 0;
};

/// The descriptions of labels, in the order of the file.
using LabelTable = std::vector<LabelDescription>;

/// Returns nothing if the text is not a whole number of 64 bits.
inline std::optional<LabelValue> label_value(std::string_view text) {
  if (const auto value = whole_number<std::uint64_t>(text)) return LabelValue(*value);
  if (const auto value = whole_number<std::int64_t>(text)) return LabelValue(*value);
  return std::nullopt;
}

}  // namespace discmc::command
