#include "page.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

void require_read_colours(const std::filesystem::path& file, const TiffPage& page) {
  switch (page.photometric) {
    case PHOTOMETRIC_YCBCR:
      if (page.compression == COMPRESSION_JPEG && !page.is_planar) return;
      break;
    case PHOTOMETRIC_PALETTE:
      if (page.samples == 1) return;
      break;
    case PHOTOMETRIC_MINISWHITE:
    case PHOTOMETRIC_MINISBLACK:
    case PHOTOMETRIC_RGB:
    case PHOTOMETRIC_SEPARATED:
    case PHOTOMETRIC_MASK:
      return;
    default:
      break;
  }
  fail(file, "the colours, of kind " + std::to_string(page.photometric) + ", are not supported",
       "convert it to RGB or grey");
}

// Returns the number after "KEY = " in ScanImage's text, or nothing.
std::optional<std::uint32_t> number_of(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  text.remove_prefix(at + key.size());
  const std::string_view line = next_line(text).value_or("");
  return whole_number<std::uint32_t>(
      trimmed(line.substr(std::min(line.size(), line.find('=') + 1))));
}

}  // namespace

void require_slices_of_scan_image(const std::filesystem::path& file, TIFF* tiff,
                                  std::uint32_t pages) {
  // Versions of ScanImage differ in which tag has the text.
  const std::string text = software_of(tiff) + '\n' + description_of(tiff);
  constexpr std::string_view signs[] = {"SI.VERSION_MAJOR", "scanimage.SI", "state.acq."};
  const auto has = [&text](std::string_view sign) { return text.find(sign) != std::string::npos; };
  if (std::none_of(std::begin(signs), std::end(signs), has)) return;
  for (const char* key : {"numSlices", "actualNumSlices", "stackNumSlices", "numberOfZSlices"})
    if (number_of(text, key) == pages) return;
  fail(file,
       "its " + std::to_string(pages) +
           " pages are not one slice each: ScanImage also stores channels and times as pages",
       "save one channel from ImageJ with Stack to Hyperstack, or give --axes zyx if all pages are "
       "slices");
}

void require_read_layout(const std::filesystem::path& file, TIFF* tiff, std::uint32_t pages) {
  struct Kind {
    std::uint32_t tag;
    const char* name;
    bool is_of_one_page_too;
  };
  constexpr std::uint32_t tag_of_planes = 33629;
  constexpr Kind kinds[] = {{34412, "Zeiss LSM", true},
                            {34361, "Olympus FluoView", false},
                            {33560, "Olympus SIS", false}};
  const char* name = count_of(tiff, tag_of_planes) > pages ? "MetaMorph STK" : nullptr;
  for (const Kind& kind : kinds)
    if ((kind.is_of_one_page_too || pages > 1) && count_of(tiff, kind.tag) > 0) name = kind.name;
  if (name != nullptr)
    fail(file, std::string("this is ") + name + ", whose axes are not supported",
         "convert it to OME-TIFF with Bio-Formats: bfconvert IN OUT.ome.tif");
}

void require_read(const std::filesystem::path& file, const TiffPage& page) {
  require_read_colours(file, page);
  if (!sample_type(page))
    fail(file,
         "samples of " + std::to_string(page.bits) + " bits and format " +
             std::to_string(page.format) + " are not supported",
         "convert it to 8 or 16 bits, or 32 bits of floating point");
  if (TIFFIsCODECConfigured(page.compression) == 0)
    fail(file,
         "its compression, number " + std::to_string(page.compression) +
             ", is not supported by the LibTIFF of this discmc",
         "store it again, in Deflate or LZW");
  if (page.orientation > ORIENTATION_BOTLEFT)
    fail(file, "its rows are columns (Orientation " + std::to_string(page.orientation) + ')',
         "turn it upright");
  if (page.depth > 1 && !page.is_tiled())
    fail(file, "the pages have several slices (ImageDepth) in strips",
         "store it in tiles, or a page for each slice");
}

}  // namespace discmc::command
