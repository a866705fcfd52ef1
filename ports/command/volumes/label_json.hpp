// The names of labels in files of JSON.
#ifndef DISCMC_COMMAND_VOLUMES_LABEL_JSON_HPP
#define DISCMC_COMMAND_VOLUMES_LABEL_JSON_HPP

#include <filesystem>

#include "label_description.hpp"

namespace discmc::command {

/// Reads the object "labels" of nnU-Net's dataset.json: {"liver": 1, "kidney": [2, 3]}. Its first
/// version and the Medical Segmentation Decathlon have {"1": "liver"}. Throws VolumeError where the
/// file is none of that.
/// https://github.com/MIC-DKFZ/nnUNet/blob/master/documentation/dataset_format.md
LabelTable read_label_json(const std::filesystem::path& file);

}  // namespace discmc::command

#endif
