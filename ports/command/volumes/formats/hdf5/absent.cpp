// In place of the reader, where it was built without its library.
#include "volumes/formats/readers.hpp"

namespace discmc::command {

std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name, const VolumeOptions&) {
  fail(name, "this is HDF5, and discmc was built without libhdf5",
       "install libhdf5-dev and build again, or convert, e.g. to NumPy with h5py");
}

}  // namespace discmc::command
