#include "picture_file.hpp"

#include "volumes/byte_source.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

PictureKind kind_of(const std::filesystem::path& file) {
  ByteStream stream(file);
  return kind_of_head(stream.peek(picture_magic_bytes));
}

void read_orientation(PictureHeader& header, const std::filesystem::path& file,
                      std::string_view exif) {
  constexpr std::uint64_t tag = 0x0112, entry_bytes = 12;
  const auto number = [&](std::uint64_t at, std::size_t bytes) {
    return at + bytes <= exif.size() ? whole_of(&exif[at], bytes, exif[0] == 'M') : 0;
  };
  std::uint64_t orientation = 1;
  const std::uint64_t directory = number(4, 4), end = number(directory, 2);
  for (std::uint64_t i = 0; i < end; ++i) {
    const std::uint64_t entry = directory + 2 + entry_bytes * i;
    if (number(entry, 2) == tag) orientation = number(entry + 8, 2);
  }
  if (orientation >= 5 && orientation <= 8)
    fail(file, "its EXIF orientation exchanges rows and columns",
         "turn the pictures themselves, e.g. with: magick mogrify -auto-orient FILE");
  header.runs_backwards = {orientation == 2 || orientation == 3,
                           orientation == 3 || orientation == 4};
}

std::unique_ptr<PictureFile> open_picture(const std::filesystem::path& file) {
  switch (kind_of(file)) {
    case PictureKind::png:
      return open_png(file);
    case PictureKind::tiff:
      return open_tiff(file);
    case PictureKind::jpeg:
      return open_jpeg(file);
    case PictureKind::bmp:
      return open_bmp(file);
    case PictureKind::none:
      break;
  }
  fail(file, "this is not a PNG, TIFF, JPEG or BMP file, or it is damaged", copy_or_export);
}

}  // namespace discmc::command
