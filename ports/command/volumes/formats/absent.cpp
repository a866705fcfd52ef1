// Replaces readers in builds without their libraries.
#include <utility>

#include "volumes/formats/pictures/picture_file.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/label_table.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {

#ifndef DISCMC_WITH_DICOM
std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>&,
                                         const VolumeOptions&, const std::vector<std::string>&) {
  fail(
      source, "this is DICOM, and discmc was built without DCMTK and OpenJPEG",
      "install libdcmtk-dev and libopenjp2-7-dev and build again, or convert to NIfTI-1, e.g. with "
      "dcm2niix");
}
#endif

#ifndef DISCMC_WITH_HDF5
std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name, const VolumeOptions&) {
  fail(name, "this is HDF5, and discmc was built without libhdf5",
       "install libhdf5-dev and build again, or convert, e.g. to NumPy with h5py");
}
#endif

#ifndef DISCMC_WITH_JPEG
std::unique_ptr<PictureFile> open_jpeg(const std::filesystem::path& file) {
  fail(file, "this is JPEG, and discmc was built without libjpeg",
       "install libjpeg-dev and build again, or convert to PNG");
}
#endif

#ifndef DISCMC_WITH_PUGIXML
std::unique_ptr<VolumeReader> open_vti(ByteStream stream, const VolumeOptions&) {
  fail(stream.file(), "this is VTK XML, and discmc was built without pugixml",
       "install libpugixml-dev and build again, or store the volume as .vtk");
}

std::unique_ptr<VolumeReader> open_pvti(ByteStream stream, const VolumeOptions& options) {
  return open_vti(std::move(stream), options);
}
#endif

#ifndef DISCMC_WITH_TIFF
std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file) {
  fail(file, "this is TIFF, and discmc was built without LibTIFF",
       "install libtiff-dev and build again, or convert to PNG");
}
#endif

#ifndef DISCMC_WITH_JSON
std::unique_ptr<VolumeReader> open_zarr(const std::filesystem::path& path, const VolumeOptions&) {
  fail(path, "this is Zarr, and discmc was built without nlohmann-json",
       "install nlohmann-json3-dev and build again, or convert, e.g. to NumPy with zarr in Python");
}

LabelTable read_label_json(const std::string& file) {
  fail(file, "this is JSON, and discmc was built without nlohmann-json",
       "give a table with a line per label, such as: 1 liver");
}
#endif

}  // namespace discmc::command
