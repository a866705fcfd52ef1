// Finds folders of Zarr.
#include <algorithm>
#include <iterator>
#include <string_view>
#include <system_error>

#include "volumes/formats/readers.hpp"

namespace discmc::command {
namespace {

constexpr std::string_view metadata_names[] = {".zgroup", ".zarray", "zarr.json"};

}  // namespace

bool is_zarr(const std::filesystem::path& path) {
  const bool is_metadata = std::find(std::begin(metadata_names), std::end(metadata_names),
                                     path.filename().native()) != std::end(metadata_names);
  return (is_metadata && is_file(path)) ||
         std::any_of(std::begin(metadata_names), std::end(metadata_names),
                     [&path](std::string_view name) { return is_file(path / name); });
}

std::optional<std::filesystem::path> folder_of_zarr(const std::filesystem::path& folder) {
  if (is_zarr(folder)) return folder;
  std::error_code ignored;
  const std::filesystem::directory_iterator entries(folder, ignored);
  if (entries == std::filesystem::directory_iterator() || !is_zarr(entries->path()))
    return std::nullopt;
  const std::filesystem::path inner = entries->path();
  return std::next(entries) == std::filesystem::directory_iterator() ? std::optional(inner)
                                                                     : std::nullopt;
}

}  // namespace discmc::command
