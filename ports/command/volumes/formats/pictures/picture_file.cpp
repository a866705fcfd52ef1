#include "picture_file.hpp"

#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

PictureKind kind_of(const std::filesystem::path& file) {
  ByteStream stream(file);
  return kind_of_head(stream.peek(picture_magic_bytes));
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
  fail(file, "this is not a PNG, TIFF, JPEG or BMP file, or it is damaged",
       "copy or export the file again");
}

}  // namespace discmc::command
