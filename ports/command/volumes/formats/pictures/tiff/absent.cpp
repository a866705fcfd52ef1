// In place of the reader of TIFF, where it was built without its library.
#include "volumes/formats/pictures/picture_file.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {

std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file) {
  fail(file, "this is TIFF, and discmc was built without LibTIFF",
       "install libtiff-dev and build again, or convert to PNG");
}

}  // namespace discmc::command
