// TIFF, by libtiff: strips or tiles, of any compression that it knows.
#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "picture_file.hpp"
#include "text/words.hpp"
#include "volumes/header_text.hpp"
#include "volumes/length_unit.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

template <class Value>
Value field(TIFF* tiff, std::uint32_t tag, Value otherwise) {
  Value value{};
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : otherwise;
}

std::optional<SampleType> sample_type(std::uint16_t bits, std::uint16_t format) {
  struct Kind {
    std::uint16_t bits, format;
    SampleType type;
  };
  constexpr Kind kinds[] = {
      {8, SAMPLEFORMAT_UINT, SampleType::u8},     {8, SAMPLEFORMAT_INT, SampleType::i8},
      {16, SAMPLEFORMAT_UINT, SampleType::u16},   {16, SAMPLEFORMAT_INT, SampleType::i16},
      {32, SAMPLEFORMAT_UINT, SampleType::u32},   {32, SAMPLEFORMAT_INT, SampleType::i32},
      {64, SAMPLEFORMAT_UINT, SampleType::u64},   {64, SAMPLEFORMAT_INT, SampleType::i64},
      {32, SAMPLEFORMAT_IEEEFP, SampleType::f32}, {64, SAMPLEFORMAT_IEEEFP, SampleType::f64}};
  const std::uint16_t known = format == SAMPLEFORMAT_VOID ? SAMPLEFORMAT_UINT : format;
  for (const Kind& kind : kinds)
    if (kind.bits == bits && kind.format == known) return kind.type;
  return std::nullopt;
}

// The value of a "key=value" line of what ImageJ writes into its files.
std::string_view line_of(std::string_view description, std::string_view key) {
  while (const auto line = take_line(description))
    if (line->size() > key.size() && line->substr(0, key.size()) == key &&
        (*line)[key.size()] == '=')
      return line->substr(key.size() + 1);
  return {};
}

class TiffFile final : public PictureFile {
 public:
  explicit TiffFile(const std::filesystem::path& file) : file_(file) {
    // Its messages go nowhere; what it refuses is told below.
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    tiff_ = TIFFOpen(file.c_str(), "r");
    if (tiff_ == nullptr) fail(file_, "this is no TIFF file, or a damaged one", remedy);
  }
  ~TiffFile() override { TIFFClose(tiff_); }

  std::uint32_t pages() override { return TIFFNumberOfDirectories(tiff_); }

  PictureHeader header(std::uint32_t page) override {
    go_to(page);
    const auto photometric =
        field<std::uint16_t>(tiff_, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    if (field<std::uint16_t>(tiff_, TIFFTAG_SAMPLESPERPIXEL, 1) != 1 ||
        (photometric != PHOTOMETRIC_MINISBLACK && photometric != PHOTOMETRIC_MINISWHITE))
      fail_colour(file_, "a colour picture");
    const auto bits = field<std::uint16_t>(tiff_, TIFFTAG_BITSPERSAMPLE, 1);
    const auto format = field<std::uint16_t>(tiff_, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    const auto type = sample_type(bits, format);
    if (!type)
      fail(file_,
           "samples of " + std::to_string(bits) + " bits and format " + std::to_string(format) +
               " are not read",
           "convert it to 8 or 16 bits, or 32 bits of floating point");
    PictureHeader header;
    header.width = field<std::uint32_t>(tiff_, TIFFTAG_IMAGEWIDTH, 0);
    header.height = field<std::uint32_t>(tiff_, TIFFTAG_IMAGELENGTH, 0);
    header.type = *type;
    header.is_inverted = photometric == PHOTOMETRIC_MINISWHITE;
    header.spacing_mm = spacing();
    return header;
  }

  void read(std::uint32_t page, unsigned char* samples) override {
    const PictureHeader told = header(page);
    const std::size_t sample = sample_bytes(told.type);
    if (TIFFIsTiled(tiff_) != 0)
      read_tiles(told, sample, samples);
    else
      read_strips(page, std::size_t{told.width} * told.height * sample, samples);
  }

 private:
  static constexpr const char* remedy = "copy or export the file again";

  void go_to(std::uint32_t page) {
    const std::uint32_t current = TIFFCurrentDirectory(tiff_);
    const bool is_next = page == current + 1;
    if (page != current &&
        (is_next ? TIFFReadDirectory(tiff_) : TIFFSetDirectory(tiff_, page)) == 0)
      fail_page(page);
  }

  [[noreturn]] void fail_page(std::uint32_t page) const {
    fail(file_, "page " + std::to_string(page) + " (the first is 0) is damaged", remedy);
  }

  // ImageJ tells the pixels of a unit and the distance of slices. What other programs tell is how
  // large the picture should be printed.
  std::optional<std::array<double, 3>> spacing() {
    const char* text = nullptr;
    if (TIFFGetField(tiff_, TIFFTAG_IMAGEDESCRIPTION, &text) != 1 || text == nullptr)
      return std::nullopt;
    const std::string_view description = text;
    if (description.rfind("ImageJ=", 0) != 0) return std::nullopt;
    for (const std::string_view key : {"channels", "frames"})
      if (const auto count = line_of(description, key); !count.empty() && count != "1")
        fail(file_, "the file has several " + std::string(key) + ": " + shown(count),
             "save one volume, e.g. with ImageJ's Duplicate");
    const double unit = millimetres_in(line_of(description, "unit")).value_or(0);
    const auto x = static_cast<double>(field<float>(tiff_, TIFFTAG_XRESOLUTION, 0));
    const auto y = static_cast<double>(field<float>(tiff_, TIFFTAG_YRESOLUTION, 0));
    if (!(unit > 0 && x > 0 && y > 0)) return std::nullopt;
    const auto distance = line_of(description, "spacing");
    const double z = distance.empty() ? 1 : std::fabs(real(file_, "spacing", distance));
    return std::array<double, 3>{unit / x, unit / y, unit * z};
  }

  void read_strips(std::uint32_t page, std::size_t bytes, unsigned char* samples) {
    std::size_t at = 0;
    const std::uint32_t strips = TIFFNumberOfStrips(tiff_);
    for (std::uint32_t strip = 0; strip < strips && at < bytes; ++strip) {
      const tmsize_t got =
          TIFFReadEncodedStrip(tiff_, strip, samples + at, static_cast<tmsize_t>(bytes - at));
      if (got < 0) fail_page(page);
      at += static_cast<std::size_t>(got);
    }
    if (at < bytes) fail_page(page);
  }

  void read_tiles(const PictureHeader& told, std::size_t sample, unsigned char* samples) {
    const auto tile_width = field<std::uint32_t>(tiff_, TIFFTAG_TILEWIDTH, 0);
    const auto tile_height = field<std::uint32_t>(tiff_, TIFFTAG_TILELENGTH, 0);
    const std::uint32_t page = TIFFCurrentDirectory(tiff_);
    const std::uint64_t tile_bytes = std::uint64_t{tile_width} * tile_height * sample;
    constexpr std::uint64_t max_padding = std::uint64_t{1} << 26;
    const std::uint64_t slice_bytes = std::uint64_t{told.width} * told.height * sample;
    if (tile_width == 0 || tile_height == 0 || tile_bytes > slice_bytes + max_padding ||
        tile_bytes != static_cast<std::uint64_t>(TIFFTileSize(tiff_)))
      fail_page(page);
    std::vector<unsigned char> tile(static_cast<std::size_t>(tile_bytes));
    for (std::uint32_t top = 0; top < told.height; top += tile_height)
      for (std::uint32_t left = 0; left < told.width; left += tile_width) {
        if (TIFFReadTile(tiff_, tile.data(), left, top, 0, 0) < 0) fail_page(page);
        const std::size_t columns = std::min(tile_width, told.width - left);
        const std::size_t rows = std::min(tile_height, told.height - top);
        for (std::size_t y = 0; y < rows; ++y)
          std::memcpy(samples + ((top + y) * told.width + left) * sample,
                      tile.data() + y * tile_width * sample, columns * sample);
      }
  }

  std::filesystem::path file_;
  TIFF* tiff_ = nullptr;
};

}  // namespace

std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file) {
  return std::make_unique<TiffFile>(file);
}

}  // namespace discmc::command
