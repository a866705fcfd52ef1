// The table of containers and sample types in the manual of the command. For every cell there is a
// file of an independent program (volumes/write_volumes.py), with the same volume.

#include "command.hpp"

namespace {

using namespace volume_files;
using discmc::meshing::sample_type_called;

const fs::path folder = fs::path(DISCMC_SOURCE_DIR) / "tests" / "command" / "volumes";

const std::set<std::string> all_types = {"u8",  "i8",  "u16", "i16", "u32",
                                         "i32", "u64", "i64", "f32", "f64"};

// Containers, and the sample types of their files.
const std::map<std::string, std::set<std::string>> table = {
    {"nrrd", all_types},
    {"nifti1", all_types},
    {"nifti2", all_types},
    {"analyze", {"u8", "i16", "i32", "f32", "f64"}},
    {"metaimage", all_types},
    {"vtk", all_types},
    {"vti", all_types},
    {"numpy", all_types},
    {"hdf5", all_types},
    {"invesalius", {"i16"}},
    {"tiff", all_types},
    {"npz", all_types},
    {"mgh", {"u8", "i16", "i32", "f32"}},
    {"zarr", all_types},
    {"mrc", {"i8", "i16", "u16", "f32"}},
};

// The expected samples of a file named TYPE-ORDER..., in the volume of all files.
void check_file(const std::string& container, const fs::path& file) {
  const std::string called = file.filename().string();
  INFO(container, "/", called);
  const SampleType type = *sample_type_called(called.substr(0, called.find('-')));
  VolumeOptions options;
  if (contains(called, "frame1")) options = of_frame(1);
  const auto reader = open_volume(file, options);
  const VolumeInfo& info = reader->info();
  CHECK(info.dims == Dims{5, 3, 4});
  CHECK(info.type == type);
  if (container != "numpy" && container != "npz" && container != "tiff")
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(std::fabs(info.spacing_mm[axis]) == std::array<double, 3>{0.5, 0.75, 2}[axis]);
  CHECK(read_all(*reader) == samples_as(type));
}

bool is_data(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".raw" || extension == ".img" || contains(file.string(), ".raw.gz");
}

}  // namespace

TEST_CASE(
    "files by other programs in every format hold the same volume in every type and byte order") {
  for (const auto& row : table) {
    const std::string& container = row.first;
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder / container)) {
      if (is_data(entry.path())) continue;
      check_file(container, entry.path());
      const std::string called = entry.path().filename().string();
      found.insert(called.substr(0, called.find('-')));
    }
    INFO(container);
    CHECK(found == row.second);
  }
}

TEST_CASE("the header and the data file of a pair may be compressed with gzip") {
  const Folder packed;
  for (const std::string pair : {"analyze/i16-big", "nifti1/i16-big", "nifti2/i16-big"}) {
    const auto file = packed.write("i16-.hdr.gz", gzip(contents(folder / (pair + ".hdr"))));
    packed.write("i16-.img.gz", gzip(contents(folder / (pair + ".img"))));
    check_file(pair, file);
  }
}

TEST_CASE("a file of several volumes is refused unless one of them is chosen") {
  for (const std::string name :
       {"nrrd/i16-big-frame1.nrrd", "nifti1/i16-little-frame1.nii", "nifti2/i16-little-frame1.nii",
        "numpy/i16-little-frame1.npy", "hdf5/i16-little-frame1.h5"}) {
    INFO(name);
    check_refused(folder / name, "holds 2 volumes, and one is read at a time; choose one");
    check_refused(folder / name, of_frame(2), "no volume 2: the file holds 2");
    for (const double sample : read_samples(folder / name, of_frame(0))) CHECK(sample == 0);
  }
}
