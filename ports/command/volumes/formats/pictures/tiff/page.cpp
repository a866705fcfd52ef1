#include "page.hpp"

#include <algorithm>

namespace discmc::command {
namespace {

template <class Value>
Value field(TIFF* tiff, std::uint32_t tag, Value otherwise) {
  Value value{};
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : otherwise;
}

std::string text(TIFF* tiff, std::uint32_t tag) {
  const char* text = nullptr;
  return TIFFGetField(tiff, tag, &text) == 1 && text != nullptr ? text : "";
}

// Returns the type of samples that fill whole bytes.
std::optional<SampleType> type_of_bytes(std::uint16_t bits, std::uint16_t format) {
  struct Kind {
    std::uint16_t bits, format;
    SampleType type;
  };
  constexpr Kind kinds[] = {
      {8, SAMPLEFORMAT_UINT, SampleType::u8},     {8, SAMPLEFORMAT_INT, SampleType::i8},
      {16, SAMPLEFORMAT_UINT, SampleType::u16},   {16, SAMPLEFORMAT_INT, SampleType::i16},
      {32, SAMPLEFORMAT_UINT, SampleType::u32},   {32, SAMPLEFORMAT_INT, SampleType::i32},
      {64, SAMPLEFORMAT_UINT, SampleType::u64},   {64, SAMPLEFORMAT_INT, SampleType::i64},
      {16, SAMPLEFORMAT_IEEEFP, SampleType::f32}, {32, SAMPLEFORMAT_IEEEFP, SampleType::f32},
      {64, SAMPLEFORMAT_IEEEFP, SampleType::f64}};
  for (const Kind& kind : kinds)
    if (kind.bits == bits && kind.format == format) return kind.type;
  return std::nullopt;
}

}  // namespace

TiffPage page_of(TIFF* tiff) {
  TiffPage page;
  page.width = field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  page.height = field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  page.depth = std::max<std::uint32_t>(1, field<std::uint32_t>(tiff, TIFFTAG_IMAGEDEPTH, 1));
  page.bits = field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  page.format = field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  if (page.format == SAMPLEFORMAT_VOID) page.format = SAMPLEFORMAT_UINT;
  page.samples = field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  page.is_planar = field<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) ==
                   PLANARCONFIG_SEPARATE;
  page.photometric = field<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  page.compression = field<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  page.orientation = field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  if (TIFFIsTiled(tiff) != 0)
    page.tile = {field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0),
                 field<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0),
                 std::max<std::uint32_t>(1, field<std::uint32_t>(tiff, TIFFTAG_TILEDEPTH, 1))};
  const auto kind = field<std::uint32_t>(tiff, TIFFTAG_SUBFILETYPE, 0);
  const auto old_kind = field<std::uint16_t>(tiff, TIFFTAG_OSUBFILETYPE, 0);
  page.is_smaller_copy = (kind & FILETYPE_REDUCEDIMAGE) != 0 || old_kind == OFILETYPE_REDUCEDIMAGE;
  page.is_mask = (kind & FILETYPE_MASK) != 0;
  page.resolution = {static_cast<double>(field<float>(tiff, TIFFTAG_XRESOLUTION, 0)),
                     static_cast<double>(field<float>(tiff, TIFFTAG_YRESOLUTION, 0))};
  page.resolution_unit = field<std::uint16_t>(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  return page;
}

std::string description_of(TIFF* tiff) {
  return text(tiff, TIFFTAG_IMAGEDESCRIPTION);
}

std::string software_of(TIFF* tiff) {
  return text(tiff, TIFFTAG_SOFTWARE);
}

Palette palette_of(TIFF* tiff, const TiffPage& page) {
  std::array<const std::uint16_t*, 3> parts{};
  if (page.photometric != PHOTOMETRIC_PALETTE || page.bits > 16 ||
      TIFFGetField(tiff, TIFFTAG_COLORMAP, &parts[0], &parts[1], &parts[2]) != 1)
    return {};
  const std::size_t colours = std::size_t{1} << page.bits;
  // Some programs store 8-bit values in the 16 bits of each entry.
  const bool is_of_bytes = std::all_of(parts.begin(), parts.end(), [colours](const auto* part) {
    return std::all_of(part, part + colours, [](std::uint16_t value) { return value < 256; });
  });
  Palette palette(colours);
  for (std::size_t i = 0; i < colours; ++i)
    for (std::size_t part = 0; part < 3; ++part)
      palette[i][part] = static_cast<std::uint8_t>(parts[part][i] >> (is_of_bytes ? 0 : 8));
  return palette;
}

std::uint32_t count_of(TIFF* tiff, std::uint32_t tag) {
  if (TIFFFindField(tiff, tag, TIFF_ANY) == nullptr) return 0;
  std::uint32_t count = 0;
  const void* values = nullptr;
  return TIFFGetField(tiff, tag, &count, &values) == 1 ? count : 0;
}

std::optional<SampleType> sample_type(const TiffPage& page) {
  if (page.bits % 8 == 0) return type_of_bytes(page.bits, page.format);
  const bool is_packed =
      page.bits < 16 && page.format == SAMPLEFORMAT_UINT && page.samples_of_pixel() == 1;
  if (!is_packed) return std::nullopt;
  return page.bits < 8 ? SampleType::u8 : SampleType::u16;
}

}  // namespace discmc::command
