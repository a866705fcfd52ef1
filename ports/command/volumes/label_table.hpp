// Tables of labels as files.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "label_description.hpp"

namespace discmc::command {

/// Reads a table of labels, as programs write them. Lines: "INDEX NAME RED GREEN BLUE" (3D Slicer,
/// FreeSurfer), "INDEX RED GREEN BLUE ALPHA VISIBLE MESH "NAME"" (ITK-SNAP). Columns with heads:
/// index, name, color between tabs (BIDS), or LabelValue, Name, Color_R ... between commas (3D
/// Slicer). Also a file of read_label_json(). Lines that are empty or begin with # are skipped.
/// Throws VolumeError with the number of a line that is none of that.
LabelTable read_label_table(const std::filesystem::path& file);

/// Reads the object "labels" of nnU-Net's dataset.json: {"liver": 1, "kidney": [2, 3]}. Its first
/// version and the Medical Segmentation Decathlon have {"1": "liver"}. Throws VolumeError where the
/// file is none of that.
/// https://github.com/MIC-DKFZ/nnUNet/blob/master/documentation/dataset_format.md
LabelTable read_label_json(const std::filesystem::path& file);

/// Red, green and blue from 0 to 1; nothing where one is no such number.
std::optional<Srgb> colour_of_shares(const std::array<std::string_view, 3>& texts);

}  // namespace discmc::command
