// Files that are the masks of labels, one each.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "volumes/volume.hpp"

namespace discmc::command {

/// Whether a file of this name can be one of several masks: of a format that is one file.
bool is_mask_name(const std::filesystem::path& file);

/// Returns those of a folder; what is in further folders in it is left.
std::vector<std::filesystem::path> mask_files(const std::filesystem::path& folder);

/// Volumes of the same extents at the same place, in the natural order of names: options.frame is
/// the number of one. Each is all of a label, which has the name of the file. If options declare
/// that they hold labels, a file with two values but 0 is refused when it is read. source: what was
/// named. notes: added to those of the volume.
std::unique_ptr<VolumeReader> open_masks(const std::filesystem::path& source,
                                         std::vector<std::filesystem::path> files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes = {});

}  // namespace discmc::command
