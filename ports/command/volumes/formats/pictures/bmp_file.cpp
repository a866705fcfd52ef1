// Uncompressed BMP, as Windows and SkyScan's NRecon write it, with grey values, numbers of a
// palette, or colours. https://learn.microsoft.com/windows/win32/gdi/bitmap-storage
#include <algorithm>
#include <cstring>
#include <fstream>
#include <string>

#include "picture_file.hpp"
#include "sample_packing.hpp"
#include "volumes/byte_source.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// The headers: little-endian fields at fixed offsets.
class BmpHeader {
 public:
  BmpHeader(const std::filesystem::path& file, std::istream& in) : file_(file) {
    constexpr std::size_t max_bytes = 138;  // with a header of version 5
    bytes_.resize(max_bytes);
    in.read(bytes_.data(), static_cast<std::streamsize>(max_bytes));
    bytes_.resize(static_cast<std::size_t>(in.gcount()));
    in.clear();
  }

  std::uint64_t pixels_at() const { return field(10, 4); }
  std::uint32_t header_bytes() const { return field(14, 4); }
  bool is_of_os2() const { return header_bytes() == 12; }
  std::uint32_t width() const { return is_of_os2() ? field(18, 2) : field(18, 4); }
  bool is_from_the_top() const { return !is_of_os2() && (field(22, 4) >> 31) != 0; }
  std::uint32_t height() const {
    if (is_of_os2()) return field(20, 2);
    return is_from_the_top() ? 0 - field(22, 4) : field(22, 4);
  }
  std::uint32_t bits() const { return is_of_os2() ? field(24, 2) : field(28, 2); }
  std::uint32_t compression() const { return is_of_os2() ? 0 : field(30, 4); }
  std::optional<Resolution> resolution() const {
    if (is_of_os2() || field(38, 4) == 0 || field(42, 4) == 0) return std::nullopt;
    return Resolution{{1.0 * field(38, 4), 1.0 * field(42, 4)}, mm_of_metre};
  }
  /// Returns the offset of the palette.
  std::uint64_t palette_at() const { return 14 + std::uint64_t{header_bytes()}; }
  std::uint32_t colour_bytes() const { return is_of_os2() ? 3 : 4; }
  std::uint32_t colours() const {
    const std::uint32_t max_colours = bits() <= 8 ? 1U << bits() : 0;
    const std::uint32_t count = is_of_os2() ? 0 : field(46, 4);
    return count == 0 ? max_colours : std::min(count, max_colours);
  }

 private:
  std::uint32_t field(std::size_t at, std::size_t size) const {
    if (at + size > bytes_.size()) fail(file_, "the BMP file is cut off", copy_or_export);
    return static_cast<std::uint32_t>(whole_of(&bytes_[at], size, false));
  }

  std::filesystem::path file_;
  std::string bytes_;
};

class BmpFile final : public SinglePicture {
 public:
  using SinglePicture::SinglePicture;

  PictureHeader header(std::uint32_t) override {
    std::ifstream in = opened();
    const BmpHeader bmp(file(), in);
    require_read_kind(bmp);
    PictureHeader header;
    header.width = bmp.width();
    header.height = bmp.height();
    header.resolution = bmp.resolution();
    if (bmp.bits() > 8) {
      header.channels = 3;
      header.channel_names = rgb_names;
    } else {
      greys_ = palette(in, bmp);
      if (!is_grey(greys_)) header.palette = std::exchange(greys_, {});
    }
    return header;
  }

  void read(std::uint32_t, std::uint32_t channel, unsigned char* samples) override {
    const PictureHeader picture = header(0);
    std::ifstream in = opened();
    const BmpHeader bmp(file(), in);
    in.seekg(static_cast<std::streamoff>(bmp.pixels_at()));
    const std::size_t row_bytes = (std::size_t{picture.width} * bmp.bits() + 31) / 32 * 4;
    std::vector<unsigned char> row(row_bytes);
    for (std::uint32_t i = 0; i < picture.height; ++i) {
      if (!in.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(row_bytes)))
        fail(file(), "the BMP file is cut off", copy_or_export);
      const std::size_t y = bmp.is_from_the_top() ? i : picture.height - 1 - i;
      unsigned char* const out = samples + y * picture.width;
      if (bmp.bits() <= 8) {
        unpack_bits(row.data(), picture.width, bmp.bits(), out);
        resolve_greys(greys_, out, picture.width);
      } else {
        // Blue comes first. A fourth byte is unused.
        copy_channel(row.data(), picture.width, 1, bmp.bits() / 8, 2 - channel, out);
      }
    }
  }

 private:
  std::ifstream opened() const {
    std::ifstream in(file(), std::ios::binary);
    if (!in) fail(file(), "the file cannot be opened", "check its permissions");
    return in;
  }

  void require_read_kind(const BmpHeader& bmp) const {
    const std::uint32_t bits = bmp.bits();
    const bool is_read = bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32;
    if (!is_read || bmp.compression() != 0)
      fail(file(),
           "BMP of " + std::to_string(bits) + " bits and compression " +
               std::to_string(bmp.compression()) + " is not supported",
           "convert it to PNG");
  }

  Palette palette(std::istream& in, const BmpHeader& bmp) const {
    std::vector<char> stored(std::size_t{bmp.colours()} * bmp.colour_bytes());
    in.seekg(static_cast<std::streamoff>(bmp.palette_at()));
    if (!in.read(stored.data(), static_cast<std::streamsize>(stored.size())))
      fail(file(), "the BMP file is cut off", copy_or_export);
    Palette palette(bmp.colours());
    for (std::size_t i = 0; i < palette.size(); ++i)
      for (std::size_t part = 0; part < 3; ++part)
        palette[i][part] = static_cast<std::uint8_t>(stored[i * bmp.colour_bytes() + 2 - part]);
    return palette;
  }

  Palette greys_;
};

}  // namespace

std::unique_ptr<PictureFile> open_bmp(const std::filesystem::path& file) {
  return std::make_unique<BmpFile>(file);
}

}  // namespace discmc::command
