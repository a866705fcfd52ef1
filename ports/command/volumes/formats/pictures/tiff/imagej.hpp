// What ImageJ writes into the description of a TIFF file, and others after it.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_TIFF_IMAGEJ_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_TIFF_IMAGEJ_HPP

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>

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

}  // namespace discmc::command

#endif
