// Masks as files, one per label.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "volumes/volume.hpp"

namespace discmc::command {

/// Whether a file of this name can be one of several masks, which need single-file formats.
bool is_mask_name(const std::filesystem::path& file);

/// Returns the masks of a folder, without its subfolders.
std::vector<std::filesystem::path> mask_files(const std::filesystem::path& folder);

/// Opens mask files as volumes of equal extents and place, in the natural order of names;
/// options.frame is the index of one. Each mask is one label with the name of its file. If options
/// declare labels, reading refuses a file with two values besides 0. source: the named path. notes:
/// added to those of the volume.
std::unique_ptr<VolumeReader> open_masks(const std::filesystem::path& source,
                                         std::vector<std::filesystem::path> files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes = {});

}  // namespace discmc::command
