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
  /// That its voxels have: several of a region of nnU-Net. None means all but 0.
  std::vector<LabelValue> values{};
  /// The volume of the file that it is in, as VolumeOptions::frame counts: labels that overlap are
  /// in several.
  std::uint32_t layer = 0;
};

/// The descriptions of labels, in the order of the file.
using LabelTable = std::vector<LabelDescription>;

/// Nothing where the text is no whole number of 64 bits.
inline std::optional<LabelValue> label_value(std::string_view text) {
  if (const auto value = whole_number<std::uint64_t>(text)) return LabelValue(*value);
  if (const auto value = whole_number<std::int64_t>(text)) return LabelValue(*value);
  return std::nullopt;
}

}  // namespace discmc::command
