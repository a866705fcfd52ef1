// Reads samples of TIFF pages: strips, tiles, blocks of several slices, and pages without a
// directory.
#pragma once

#include <tiffio.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "page.hpp"

namespace discmc::command {

/// Pages without directories, which follow the page of the only directory.
struct PagesBehind {
  std::uint64_t at = 0;     ///< offset of the page with the directory. Units: bytes
  std::uint64_t count = 0;  ///< pages that the file can hold from there on; 0: none
};
PagesBehind pages_behind(TIFF* tiff, const TiffPage& page, std::uint64_t file_bytes);

/// Reads slices of pages.
class TiffSamples {
 public:
  TiffSamples(std::filesystem::path file, std::uint64_t file_bytes)
      : file_(std::move(file)), file_bytes_(file_bytes) {}

  /// Reads a slice of the current page. Size: of samples, width times height of sample_type().
  /// Throws VolumeError.
  void read(TIFF* tiff, const TiffPage& page, std::uint32_t slice, std::uint32_t channel,
            unsigned char* samples);

  /// Likewise reads a page at an offset in the file. Units: bytes.
  void read_behind(TIFF* tiff, const TiffPage& page, std::uint64_t at, std::uint32_t channel,
                   unsigned char* samples);

 private:
  struct Slab {
    std::uint32_t page, number, channel;
    bool operator==(const Slab& other) const {
      return page == other.page && number == other.number && channel == other.channel;
    }
  };

  void read_plane(TIFF* tiff, const TiffPage& page, std::uint32_t slice, std::uint32_t channel,
                  unsigned char* stored);
  void read_strips(TIFF* tiff, const TiffPage& page, std::uint32_t channel, unsigned char* stored);
  void require_tiles(TIFF* tiff, const TiffPage& page) const;
  void read_slab(TIFF* tiff, const TiffPage& page, std::uint32_t slab, std::uint32_t channel,
                 unsigned char* stored);
  void read_tile(TIFF* tiff, const TiffPage& page, std::uint32_t tile);
  [[noreturn]] void fail_page(TIFF* tiff) const;

  std::filesystem::path file_;
  std::uint64_t file_bytes_;
  std::vector<unsigned char> stored_;  // a slice before conversion
  std::vector<unsigned char> tile_;
  std::vector<unsigned char> packed_;  // a tile as in the file
  std::vector<unsigned char> slab_;    // the slices that share tiles
  std::optional<Slab> kept_slab_;
};

}  // namespace discmc::command
