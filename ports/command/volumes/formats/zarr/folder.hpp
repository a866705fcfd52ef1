// Which folders are Zarr.
#pragma once

#include <filesystem>
#include <optional>

namespace discmc::command {

/// Whether a folder is a group or an array of Zarr, of version 2 or 3; or a file that identifies
/// one.
bool is_zarr(const std::filesystem::path& path);

/// Returns the folder of Zarr that a folder is, or holds and nothing else.
std::optional<std::filesystem::path> folder_of_zarr(const std::filesystem::path& folder);

}  // namespace discmc::command
