// The messages of a discmc built without optional libraries, and the files that it still reads.
#include "command/volume_files.hpp"
#include "mesh_files/mesh_reader.hpp"
#include "test.hpp"

namespace {

using namespace volume_files;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes";

TEST_CASE_FIXTURE(
    Folder, "a file that needs a missing library is refused, and the error names the library") {
  check_refused(files / "dicom/series", "built without DCMTK and OpenJPEG");
  check_refused(files / "dicom/u16.dcm", "install libdcmtk-dev");
  check_refused(files / "pictures/u16.tif", "built without LibTIFF; install libtiff-dev");
  check_refused(files / "hdf5/u8-little.h5", "built without libhdf5; install libhdf5");
  check_refused(files / "vti/u8-little-appended-raw.vti", "built without pugixml");
  check_refused(files / "invesalius/i16-little.inv3", "libarchive or pugixml");
  check_refused(files / "nrrd/i16-big-bzip2.nrrd",
                "packed by bzip2, and discmc was built without libarchive; unpack it");
  check_refused(files / "npz/u8-little.npz", "built without libarchive; unzip it");
  check_refused(files / "zarr/u8-little.zarr", "built without nlohmann-json; install");
  check_refused(write("series.zip", "PK\3\4"), "built without libarchive");
  CHECK_THROWS_WITH(discmc::command::read_meshes("a.stl"),
                    doctest::Contains("built without Assimp; install"));
}

TEST_CASE("files in formats that need no library are read") {
  check_volume(files / "nrrd/u16-little.nrrd", SampleType::u16, "NRRD, raw");
  CHECK(open_volume(files / "pictures/stack")->info().format == "PNG");
}

}  // namespace
