#include "samples.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <string>

#include "volumes/formats/pictures/sample_packing.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

bool is_half(const TiffPage& page) {
  return page.bits == 16 && page.format == SAMPLEFORMAT_IEEEFP;
}

// Whether stored rows need no conversion.
bool is_direct(const TiffPage& page) {
  return page.samples_of_pixel() == 1 && page.bits % 8 == 0 && !is_half(page);
}

void convert(const TiffPage& page, std::uint32_t channel, unsigned char* stored,
             unsigned char* samples) {
  const std::size_t pixels = std::size_t{page.width} * page.height;
  if (page.bits % 8 != 0) {
    const std::size_t unpacked_row_bytes = page.width * sample_bytes(*sample_type(page));
    for (std::size_t y = 0; y < page.height; ++y)
      unpack_bits(stored + y * page.row_bytes(page.width), page.width, page.bits,
                  samples + y * unpacked_row_bytes);
    return;
  }
  unsigned char* const channel_samples = is_half(page) ? stored : samples;
  if (page.samples_of_pixel() > 1)
    copy_channel(stored, pixels, page.bits / 8, page.samples, channel, channel_samples);
  if (is_half(page)) widen_halves(stored, pixels, samples);
}

void swap_bytes(const TiffPage& page, unsigned char* stored) {
  const auto count = static_cast<tmsize_t>(page.plane_bytes() / (page.bits / 8U));
  if (page.bits == 16) TIFFSwabArrayOfShort(reinterpret_cast<std::uint16_t*>(stored), count);
  if (page.bits == 32) TIFFSwabArrayOfLong(reinterpret_cast<std::uint32_t*>(stored), count);
  if (page.bits == 64) TIFFSwabArrayOfLong8(reinterpret_cast<std::uint64_t*>(stored), count);
}

}  // namespace

PagesBehind pages_behind(TIFF* tiff, const TiffPage& page, std::uint64_t file_bytes) {
  const bool can_be = page.compression == COMPRESSION_NONE && !page.is_tiled() && page.depth == 1 &&
                      page.bits % 8 == 0 && (!page.is_planar || page.samples == 1) &&
                      page.plane_bytes() > 0;
  if (!can_be) return {};
  PagesBehind behind;
  behind.at = TIFFGetStrileOffset(tiff, 0);
  std::uint64_t end = behind.at;
  for (std::uint32_t strip = 0; strip < TIFFNumberOfStrips(tiff); ++strip) {
    if (TIFFGetStrileOffset(tiff, strip) != end) return {};
    end += TIFFGetStrileByteCount(tiff, strip);
  }
  if (end - behind.at != page.plane_bytes() || end > file_bytes) return {};
  behind.count = (file_bytes - behind.at) / page.plane_bytes();
  return behind;
}

void TiffSamples::read(TIFF* tiff, const TiffPage& page, std::uint32_t slice, std::uint32_t channel,
                       unsigned char* samples) {
  if (is_direct(page)) return read_plane(tiff, page, slice, channel, samples);
  stored_.resize(page.plane_bytes());
  read_plane(tiff, page, slice, channel, stored_.data());
  convert(page, channel, stored_.data(), samples);
}

void TiffSamples::read_behind(TIFF* tiff, const TiffPage& page, std::uint64_t at,
                              std::uint32_t channel, unsigned char* samples) {
  if (!is_direct(page)) stored_.resize(page.plane_bytes());
  unsigned char* const stored = is_direct(page) ? samples : stored_.data();
  std::ifstream in(file_, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(at));
  if (!in.read(reinterpret_cast<char*>(stored), static_cast<std::streamsize>(page.plane_bytes())))
    fail(file_, "the file ends within its samples", copy_or_export);
  if (TIFFIsByteSwapped(tiff) != 0) swap_bytes(page, stored);
  if (!is_direct(page)) convert(page, channel, stored, samples);
}

void TiffSamples::read_plane(TIFF* tiff, const TiffPage& page, std::uint32_t slice,
                             std::uint32_t channel, unsigned char* stored) {
  if (!page.is_tiled()) return read_strips(tiff, page, channel, stored);
  require_tiles(tiff, page);
  const std::uint32_t slab = slice / page.tile[2];
  if (page.tile[2] == 1) return read_slab(tiff, page, slab, channel, stored);
  const Slab wanted = {TIFFCurrentDirectory(tiff), slab, page.is_planar ? channel : 0};
  if (!(kept_slab_ == wanted)) {
    kept_slab_.reset();
    slab_.resize(page.plane_bytes() * std::min(page.tile[2], page.depth));
    read_slab(tiff, page, slab, channel, slab_.data());
    kept_slab_ = wanted;
  }
  std::memcpy(stored, slab_.data() + slice % page.tile[2] * page.plane_bytes(), page.plane_bytes());
}

void TiffSamples::read_strips(TIFF* tiff, const TiffPage& page, std::uint32_t channel,
                              unsigned char* stored) {
  const std::uint32_t planes = page.is_planar ? page.samples : 1;
  const std::uint32_t strips = TIFFNumberOfStrips(tiff) / planes;
  const std::uint32_t first = page.is_planar ? channel * strips : 0;
  const std::size_t bytes = page.plane_bytes();
  std::size_t at = 0;
  for (std::uint32_t strip = first; strip < first + strips && at < bytes; ++strip) {
    const tmsize_t got =
        TIFFReadEncodedStrip(tiff, strip, stored + at, static_cast<tmsize_t>(bytes - at));
    if (got < 0) fail_page(tiff);
    at += static_cast<std::size_t>(got);
  }
  if (at < bytes) fail_page(tiff);
}

// Tiles may declare any size, and most of a small page may be padding.
void TiffSamples::require_tiles(TIFF* tiff, const TiffPage& page) const {
  const auto [width, height, depth] = page.tile;
  const std::uint64_t row = page.row_bytes(width);
  constexpr std::uint64_t max_padding = std::uint64_t{1} << 26;
  const std::uint64_t max_tile_bytes = page.plane_bytes() * page.depth + max_padding;
  if (height == 0 || row * 8 != std::uint64_t{width} * page.samples_of_pixel() * page.bits ||
      row > max_tile_bytes / height / depth ||
      row * height != static_cast<std::uint64_t>(TIFFTileSize(tiff)))
    fail_page(tiff);
}

// Reads all slices of a layer of tiles.
void TiffSamples::read_slab(TIFF* tiff, const TiffPage& page, std::uint32_t slab,
                            std::uint32_t channel, unsigned char* stored) {
  const auto [width, height, depth] = page.tile;
  const std::uint64_t row = page.row_bytes(width);
  const std::uint64_t bytes = row * height * depth;
  tile_.resize(bytes);
  const std::uint32_t slices = std::min(depth, page.depth - slab * depth);
  for (std::uint32_t top = 0; top < page.height; top += height)
    for (std::uint32_t left = 0; left < page.width; left += width) {
      read_tile(
          tiff, page,
          TIFFComputeTile(tiff, left, top, slab * depth, static_cast<std::uint16_t>(channel)));
      const std::uint64_t columns = page.row_bytes(std::min(width, page.width - left));
      const std::uint32_t rows = std::min(height, page.height - top);
      for (std::uint64_t z = 0; z < slices; ++z)
        for (std::uint64_t y = 0; y < rows; ++y)
          std::memcpy(stored + z * page.plane_bytes() + (top + y) * page.row_bytes(page.width) +
                          page.row_bytes(left),
                      tile_.data() + (z * height + y) * row, columns);
    }
}

// libtiff decodes only the first slice of a tile.
void TiffSamples::read_tile(TIFF* tiff, const TiffPage& page, std::uint32_t tile) {
  const auto bytes = static_cast<tmsize_t>(tile_.size());
  if (page.tile[2] == 1) {
    if (TIFFReadEncodedTile(tiff, tile, tile_.data(), bytes) < 0) fail_page(tiff);
    return;
  }
  const std::uint64_t packed = TIFFGetStrileByteCount(tiff, tile);
  if (packed == 0 || packed > file_bytes_) fail_page(tiff);
  packed_.resize(packed);
  const auto packed_bytes = static_cast<tmsize_t>(packed);
  if (TIFFReadRawTile(tiff, tile, packed_.data(), packed_bytes) != packed_bytes ||
      TIFFReadFromUserBuffer(tiff, tile, packed_.data(), packed_bytes, tile_.data(), bytes) == 0)
    fail_page(tiff);
}

void TiffSamples::fail_page(TIFF* tiff) const {
  fail(file_, "page " + std::to_string(TIFFCurrentDirectory(tiff)) + " (the first is 0) is damaged",
       copy_or_export);
}

}  // namespace discmc::command
