// What is not read of TIFF, by its name.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_TIFF_UNREAD_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_TIFF_UNREAD_HPP

#include <tiffio.h>

#include <cstdint>
#include <filesystem>

#include "page.hpp"

namespace discmc::command {

/// Throws where pages are laid out by rules that are in tags of a maker.
void require_read_layout(const std::filesystem::path& file, TIFF* tiff, std::uint32_t pages);

/// Throws where pages are those of ScanImage, and not a slice each: channels and times are pages,
/// too.
void require_slices_of_scan_image(const std::filesystem::path& file, TIFF* tiff,
                                  std::uint32_t pages);

/// Throws where the samples of a page are of a kind that is not read.
void require_read(const std::filesystem::path& file, const TiffPage& page);

}  // namespace discmc::command

#endif
