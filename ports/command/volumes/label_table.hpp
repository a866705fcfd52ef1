// The names and colours of the labels of a segmentation, and their tables.
#pragma once

#include <array>
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

/// Reads a table of labels in one of these forms.
/// Lines: "INDEX NAME RED GREEN BLUE" (3D Slicer, FreeSurfer), or "INDEX RED GREEN BLUE ALPHA
/// VISIBLE MESH "NAME"" (ITK-SNAP).
/// Columns with heads: index, name, color between tabs (BIDS), or LabelValue, Name, Color_R ...
/// between commas (3D Slicer).
/// JSON: a file of read_label_json().
/// Skips empty lines, and lines that begin with #. Throws VolumeError with the number of an invalid
/// line.
LabelTable read_label_table(const std::string& file);

/// Reads the object "labels" of nnU-Net's dataset.json: {"liver": 1, "kidney": [2, 3]}. Its first
/// version and the Medical Segmentation Decathlon have {"1": "liver"}. Throws VolumeError for other
/// content. https://github.com/MIC-DKFZ/nnUNet/blob/master/documentation/dataset_format.md
LabelTable read_label_json(const std::string& file);

/// Parses red, green and blue from 0 to 1; returns nothing if a text is another number.
std::optional<Srgb> colour_of_shares(const std::array<std::string_view, 3>& texts);

}  // namespace discmc::command
