// In place of the reader of JPEG, where it was built without its library.
#include "picture_file.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {

std::unique_ptr<PictureFile> open_jpeg(const std::filesystem::path& file) {
  fail(file, "this is JPEG, and discmc was built without libjpeg",
       "install libjpeg-dev and build again, or convert to PNG");
}

}  // namespace discmc::command
