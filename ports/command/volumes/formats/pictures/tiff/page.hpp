// The properties of a page in its TIFF directory.
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
  std::uint32_t depth = 1;  ///< number of slices in the page
  std::uint16_t bits = 1;   ///< per sample
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::uint16_t samples = 1;  ///< per pixel
  bool is_planar = false;     ///< whether each channel is stored on its own
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  std::array<std::uint32_t, 3> tile{};  ///< width, height and depth; nothing for strips
  bool is_smaller_copy = false;         ///< declared as a smaller copy of another page
  bool is_mask = false;                 ///< declared as a mask of another page
  /// Pixels per unit, and the unit's length; 0 if there is none.
  std::array<double, 2> resolution{};
  std::uint16_t resolution_unit = RESUNIT_INCH;

  bool is_tiled() const { return tile[0] > 0; }
  /// Returns the number of adjacent samples.
  std::uint32_t samples_of_pixel() const { return is_planar ? 1 : samples; }
  /// Returns the bytes of a stored row of this many pixels.
  std::uint64_t row_bytes(std::uint64_t pixels) const {
    return (pixels * samples_of_pixel() * bits + 7) / 8;
  }
  /// Returns the bytes of a slice of a page, for all channels or one channel's plane.
  std::uint64_t plane_bytes() const { return row_bytes(width) * height; }
};

/// Returns the page of the current directory.
TiffPage page_of(TIFF* tiff);

/// Returns an empty text if there is none.
std::string description_of(TIFF* tiff);
std::string software_of(TIFF* tiff);
Palette palette_of(TIFF* tiff, const TiffPage& page);

/// Returns the number of values of a tag that the library does not support.
std::uint32_t count_of(TIFF* tiff, std::uint32_t tag);

/// Returns the type of samples after reading, or nothing if they are unsupported.
std::optional<SampleType> sample_type(const TiffPage& page);

/// Throws if a vendor's tags define the layout of pages.
void require_read_layout(const std::filesystem::path& file, TIFF* tiff, std::uint32_t pages);

/// Throws if ScanImage wrote the pages and some are channels or times, not slices.
void require_slices_of_scan_image(const std::filesystem::path& file, TIFF* tiff,
                                  std::uint32_t pages);

/// Throws if the samples of a page are of an unsupported kind.
void require_read(const std::filesystem::path& file, const TiffPage& page);

}  // namespace discmc::command
