// Finds folders of Zarr.
#pragma once

#include <filesystem>
#include <optional>

namespace discmc::command {

/// Whether a path is a Zarr group or array of version 2 or 3, or its metadata file.
bool is_zarr(const std::filesystem::path& path);

/// Returns the Zarr folder that `folder` is, or that is its only content.
std::optional<std::filesystem::path> folder_of_zarr(const std::filesystem::path& folder);

}  // namespace discmc::command
