// Reads tables of labels.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "label_description.hpp"

namespace discmc::command {

/// Reads a table of labels in one of these forms.
/// Lines: "INDEX NAME RED GREEN BLUE" (3D Slicer, FreeSurfer), or "INDEX RED GREEN BLUE ALPHA
/// VISIBLE MESH "NAME"" (ITK-SNAP).
/// Columns with heads: index, name, color between tabs (BIDS), or LabelValue, Name, Color_R ...
/// between commas (3D Slicer).
/// JSON: a file of read_label_json().
/// Skips empty lines, and lines that begin with #. Throws VolumeError with the number of an invalid
/// line.
LabelTable read_label_table(const std::filesystem::path& file);

/// Reads the object "labels" of nnU-Net's dataset.json: {"liver": 1, "kidney": [2, 3]}. Its first
/// version and the Medical Segmentation Decathlon have {"1": "liver"}. Throws VolumeError for other
/// content. https://github.com/MIC-DKFZ/nnUNet/blob/master/documentation/dataset_format.md
LabelTable read_label_json(const std::filesystem::path& file);

/// Parses red, green and blue from 0 to 1; returns nothing if a text is another number.
std::optional<Srgb> colour_of_shares(const std::array<std::string_view, 3>& texts);

}  // namespace discmc::command
