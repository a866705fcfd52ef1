// OME-XML, https://docs.openmicroscopy.org/ome-model/: which page of which file is which slice,
// channel and time, and how large voxels are.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_TIFF_OME_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_TIFF_OME_HPP

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "volumes/formats/pictures/hyperstack.hpp"

namespace discmc::command {

/// Returns the number of pages of a TIFF file. Throws VolumeError when it cannot be opened.
using CountPages = std::function<std::uint64_t(const std::filesystem::path& file)>;

/// Whether a description is OME-XML.
bool is_ome(std::string_view description);

/// Returns the images that the OME-XML of a file describes, with pages of this file or of others
/// beside it. samples: of a pixel of the first page. Throws when a page does not exist.
std::vector<Hyperstack> ome_images(const std::filesystem::path& file,
                                   const std::string& description, std::uint64_t samples,
                                   const CountPages& count_pages);

}  // namespace discmc::command

#endif
