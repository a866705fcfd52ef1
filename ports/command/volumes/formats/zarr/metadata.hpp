// The metadata of a folder of Zarr, https://zarr-specs.readthedocs.io: version 2 in .zgroup,
// .zarray and .zattrs, version 3 in zarr.json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace discmc::command {

using Json = nlohmann::json;

/// Returns a member of an object, or null where there is none.
const Json& member(const Json& object, const char* name);

/// Returns a text, or nothing where it is none.
std::string text_of(const Json& value);

/// Return the numbers of an array. Throw VolumeError where it is another thing. file, name: for it.
std::vector<std::int64_t> integers_of(const std::filesystem::path& file, const char* name,
                                      const Json& value);
std::vector<double> reals_of(const std::filesystem::path& file, const char* name,
                             const Json& value);

/// A group or an array.
struct ZarrNode {
  std::filesystem::path folder;
  std::filesystem::path file;  ///< for errors
  bool is_array = false;
  Json array{};       ///< of an array: .zarray, or zarr.json
  Json attributes{};  ///< of programs, such as OME
};

/// Throws VolumeError where the folder is none, or has no readable metadata.
ZarrNode read_zarr_node(const std::filesystem::path& folder);

}  // namespace discmc::command
