// The names and colours of the labels of a segmentation.
#ifndef DISCMC_COMMAND_VOLUMES_LABEL_DESCRIPTION_HPP
#define DISCMC_COMMAND_VOLUMES_LABEL_DESCRIPTION_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshing.hpp"
#include "pictures/srgb.hpp"
#include "samples/label_value.hpp"
#include "text/number_text.hpp"
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

/// Red, green and blue from 0 to 1; nothing where one is no such number.
inline std::optional<Srgb> colour_of_shares(const std::array<std::string_view, 3>& texts) {
  Srgb colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const auto share = finite_number(texts[i]);
    if (!share || *share < 0 || *share > 1) return std::nullopt;
    colour[i] = byte_of_share(*share);
  }
  return colour;
}

}  // namespace discmc::command

#endif
