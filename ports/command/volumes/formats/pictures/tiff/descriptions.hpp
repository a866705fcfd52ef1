// The descriptions in TIFF files: what ImageJ writes, tifffile and others, and OME-XML
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

/// Other properties of the file of a description.
struct TiffFacts {
  std::filesystem::path file;
  std::uint64_t pages = 1;
  std::uint64_t samples = 1;              ///< of a pixel
  std::array<double, 2> resolution = {};  ///< Units: pixels of what the description calls a unit
};

/// Whether a description is of ImageJ.
bool is_imagej(std::string_view description);

/// Returns the stack that it describes, which may have more planes than the file has pages. Above 4
/// GB ImageJ writes one page, and the others behind it.
Hyperstack imagej_stack(const TiffFacts& facts, std::string_view description);

/// Returns the number of pages of a TIFF file. Throws VolumeError when it cannot be opened.
using CountPages = std::function<std::uint64_t(const std::filesystem::path& file)>;

/// Whether a description is OME-XML.
bool is_ome(std::string_view description);

/// Returns the images that the OME-XML of a file describes, with pages of this file or of others
/// beside it. samples: of a pixel of the first page. Throws when a page does not exist.
std::vector<Hyperstack> ome_images(const std::filesystem::path& file,
                                   const std::string& description, std::uint64_t samples,
                                   const CountPages& count_pages);

/// An array in pages that begins where tifffile describes it.
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
