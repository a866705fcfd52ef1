// The descriptions in TIFF files: by ImageJ, tifffile and others, and OME-XML
// (https://docs.openmicroscopy.org/ome-model/), which names the page and file of each slice.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "volumes/formats/pictures/hyperstack.hpp"

namespace discmc::command {

/// Other properties of the described file.
struct TiffFacts {
  std::filesystem::path file;
  std::uint64_t pages = 1;
  std::uint64_t samples = 1;              ///< per pixel
  std::array<double, 2> resolution = {};  ///< pixels per unit, which the description names
};

/// Whether ImageJ wrote the description.
bool is_imagej(std::string_view description);

/// Returns the described stack, which may have more planes than the file has pages. Above 4 GB,
/// ImageJ writes one page and appends the other planes without directories.
Hyperstack imagej_stack(const TiffFacts& facts, std::string_view description);

/// Returns the number of pages of a TIFF file. Throws VolumeError when it cannot be opened.
using CountPages = std::function<std::uint64_t(const std::filesystem::path& file)>;

/// Whether a description is OME-XML.
bool is_ome(std::string_view description);

/// Returns the images that the OME-XML of a file describes, with pages of this file or of files
/// beside it. samples: per pixel of the first page. Throws if a page does not exist.
std::vector<Hyperstack> ome_images(const std::filesystem::path& file,
                                   const std::string& description, std::uint64_t samples,
                                   const CountPages& count_pages);

/// An array in pages, which begins where tifffile describes it.
struct ShapedArray {
  std::string name;                  ///< for people; may be empty
  std::vector<std::uint64_t> sizes;  ///< of its axes, the slowest first
  std::string axes;                  ///< one letter per axis, such as "TZYX", or empty
};

/// Returns nothing if tifffile did not write the description. file: for the VolumeError in builds
/// without a parser for it.
std::optional<ShapedArray> shaped_array(const std::filesystem::path& file,
                                        const std::string& description);

/// Returns the planes of an array, without runs, or nothing if its last axes differ from the
/// page's. page: the sizes of the last axes, with rows and columns.
std::optional<Hyperstack> planes_of(const ShapedArray& array,
                                    const std::vector<std::uint64_t>& page);

}  // namespace discmc::command
