// What tifffile writes into the description of a page: the shape of the array that begins there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "volumes/formats/pictures/hyperstack.hpp"

namespace discmc::command {

/// An array in pages.
struct ShapedArray {
  std::string name;                  ///< for people, may be empty
  std::vector<std::uint64_t> sizes;  ///< of its axes, the slowest first
  std::string axes;                  ///< a letter for each, such as "TZYX", or none
};

/// Returns nothing where a description is not of tifffile. The file is for the VolumeError thrown
/// where discmc was built without what reads it.
std::optional<ShapedArray> shaped_array(const std::filesystem::path& file,
                                        const std::string& description);

/// Returns the planes of an array, without runs; nothing where its last axes are not those of the
/// page. page: the sizes of the last axes, rows and columns among them.
std::optional<Hyperstack> planes_of(const ShapedArray& array,
                                    const std::vector<std::uint64_t>& page);

}  // namespace discmc::command
