#include "unread.hpp"

#include <string>

#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

void require_known_colours(const std::filesystem::path& file, const TiffPage& page) {
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
  fail(file, "its colours, of kind " + std::to_string(page.photometric) + ", are not read",
       "convert it to RGB or grey");
}

}  // namespace

void require_known_layout(const std::filesystem::path& file, TIFF* tiff, std::uint32_t pages) {
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
    fail(file, std::string("this is ") + name + ", whose axes are not read",
         "convert it to OME-TIFF with Bio-Formats: bfconvert IN OUT.ome.tif");
}

void require_read(const std::filesystem::path& file, const TiffPage& page) {
  require_known_colours(file, page);
  if (!sample_type(page))
    fail(file,
         "samples of " + std::to_string(page.bits) + " bits and format " +
             std::to_string(page.format) + " are not read",
         "convert it to 8 or 16 bits, or 32 bits of floating point");
  if (TIFFIsCODECConfigured(page.compression) == 0)
    fail(file,
         "its compression, number " + std::to_string(page.compression) +
             ", is not read by the LibTIFF of this discmc",
         "store it again, in Deflate or LZW");
  if (page.orientation > ORIENTATION_BOTLEFT)
    fail(file, "its rows are columns (Orientation " + std::to_string(page.orientation) + ')',
         "turn it upright");
  if (page.depth > 1 && !page.is_tiled())
    fail(file, "its pages have several slices (ImageDepth) in strips",
         "store it in tiles, or a page for each slice");
}

}  // namespace discmc::command
