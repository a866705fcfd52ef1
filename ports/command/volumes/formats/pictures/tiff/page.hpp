// The properties of a page by its directory in a TIFF file.
#pragma once

#include <tiffio.h>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "meshing.hpp"
#include "samples/sample_type.hpp"
#include "volumes/formats/pictures/sample_packing.hpp"

namespace discmc::command {

struct TiffPage {
  std::uint32_t width = 0, height = 0;
  std::uint32_t depth = 1;  ///< slices of a page, where it has several
  std::uint16_t bits = 1;   ///< of a sample
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::uint16_t samples = 1;  ///< of a pixel
  bool is_planar = false;     ///< whether channels are stored one behind the other
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  std::array<std::uint32_t, 3> tile{};  ///< width, height and depth; nothing of strips
  bool is_smaller_copy = false;         ///< of another page, by its own description
  bool is_mask = false;                 ///< likewise
  /// Pixels of a unit, and what one is; 0 if there is none.
  std::array<double, 2> resolution{};
  std::uint16_t resolution_unit = RESUNIT_INCH;

  bool is_tiled() const { return tile[0] > 0; }
  /// Samples that lie side by side.
  std::uint32_t samples_of_pixel() const { return is_planar ? 1 : samples; }
  /// Units: bytes of a row of this many pixels, as it is stored.
  std::uint64_t row_bytes(std::uint64_t pixels) const {
    return (pixels * samples_of_pixel() * bits + 7) / 8;
  }
  /// Units: bytes of a slice of a page, of all channels or of a plane of one.
  std::uint64_t plane_bytes() const { return row_bytes(width) * height; }
};

/// The page of the current directory.
TiffPage page_of(TIFF* tiff);

/// Empty where there is none.
std::string description_of(TIFF* tiff);
std::string software_of(TIFF* tiff);
Palette palette_of(TIFF* tiff, const TiffPage& page);

/// Returns how many values a tag has that the library does not support.
std::uint32_t count_of(TIFF* tiff, std::uint32_t tag);

/// Returns the type of the samples as they are read; nothing where they cannot be.
std::optional<SampleType> sample_type(const TiffPage& page);

/// Throws where pages are laid out by rules that are in tags of a maker.
void require_read_layout(const std::filesystem::path& file, TIFF* tiff, std::uint32_t pages);

/// Throws where pages are those of ScanImage, and not a slice each: channels and times are pages,
/// too.
void require_slices_of_scan_image(const std::filesystem::path& file, TIFF* tiff,
                                  std::uint32_t pages);

/// Throws where the samples of a page are of a kind that is not read.
void require_read(const std::filesystem::path& file, const TiffPage& page);

}  // namespace discmc::command
