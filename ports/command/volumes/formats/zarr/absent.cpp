// In place of the reader, where it was built without its library.
#include "volumes/formats/readers.hpp"

namespace discmc::command {

std::unique_ptr<VolumeReader> open_zarr(const std::filesystem::path& path, const VolumeOptions&) {
  fail(path, "this is Zarr, and discmc was built without nlohmann-json",
       "install nlohmann-json3-dev and build again, or convert, e.g. to NumPy with zarr in Python");
}

}  // namespace discmc::command
