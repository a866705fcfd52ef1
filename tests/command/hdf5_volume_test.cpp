// HDF5 files of h5py (volumes/write_volumes.py): which of their arrays is the volume, what is
// refused, and slices that are skipped. container_table_test has every sample type.
// Without the library the test is disabled, but compiled.
#if __has_include(<hdf5.h>)
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "command.hpp"
#include "volume_files.hpp"
#include "volumes/formats/hdf5/dataset.hpp"
#include "volumes/formats/hdf5/handle.hpp"

namespace {

using namespace volume_files;
using command_tests::contents;
using discmc::command::Hdf5Handle;

constexpr H5Z_filter_t counting_filter = 256;  // the first of those for tests
unsigned unpacked_chunks = 0;

std::size_t count_unpacked(unsigned flags, std::size_t, const unsigned*, std::size_t bytes,
                           std::size_t*, void**) {
  if ((flags & H5Z_FLAG_REVERSE) != 0) ++unpacked_chunks;
  return bytes;
}

Hdf5Handle new_file(const fs::path& file) {
  return {H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, discmc::command::file_access().id()),
          H5Fclose};
}

Hdf5Handle no_creation() {
  return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
}

Hdf5Handle chunks_of(const std::array<hsize_t, 3>& chunk) {
  Hdf5Handle creation = no_creation();
  H5Pset_chunk(creation.id(), 3, chunk.data());
  return creation;
}

// A dataset of zeros, until others are written.
Hdf5Handle new_dataset(const Hdf5Handle& file, const char* path,
                       const std::array<hsize_t, 3>& sizes, const Hdf5Handle& creation,
                       hid_t type = H5T_STD_U8LE) {
  const Hdf5Handle space(H5Screate_simple(3, sizes.data(), nullptr), H5Sclose);
  Hdf5Handle dataset(
      H5Dcreate2(file.id(), path, type, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose);
  REQUIRE(dataset);
  return dataset;
}

// Takes all its samples from a dataset of another file.
void write_virtual(const fs::path& file, const char* source) {
  constexpr hsize_t sizes[] = {4, 3, 5};
  const Hdf5Handle space(H5Screate_simple(3, sizes, nullptr), H5Sclose);
  const Hdf5Handle creation = no_creation();
  REQUIRE(H5Pset_virtual(creation.id(), space.id(), source, "volume", space.id()) >= 0);
  new_dataset(new_file(file), "volume", {4, 3, 5}, creation);
}

// Four slices in two layers of four chunks, more than the library keeps by itself (1 MiB), in a
// filter that counts.
void write_counted(const fs::path& file) {
  const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, counting_filter, 1,       1,
                               "counting",       nullptr,         nullptr, count_unpacked};
  REQUIRE(H5Zregister(&filter) >= 0);
  constexpr hsize_t sizes[] = {4, 1024, 1024};
  constexpr hsize_t chunk[] = {2, 512, 512};
  const Hdf5Handle opened(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                          H5Fclose);
  const Hdf5Handle space(H5Screate_simple(3, sizes, nullptr), H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(creation.id(), 3, chunk);
  H5Pset_filter(creation.id(), counting_filter, 0, 0, nullptr);
  const Hdf5Handle dataset(H5Dcreate2(opened.id(), "volume", H5T_STD_U8LE, space.id(), H5P_DEFAULT,
                                      creation.id(), H5P_DEFAULT),
                           H5Dclose);
  const std::vector<std::uint8_t> samples(std::size_t{4} << 20, 7);
  REQUIRE(H5Dwrite(dataset.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, samples.data()) >=
          0);
}

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes";
const std::string several = files / "hdf5_arrays/several.hdf5";

TEST_CASE("the only array of three dimensions is the volume, whatever lies beside it") {
  check_volume(files / "hdf5/i16-big-gzip.h5", SampleType::i16,
               "HDF5, /exchange/data, shuffle, gzip, fletcher32");
}

TEST_CASE("of several arrays one is chosen by its name behind that of the file") {
  check_refusal(refusal(several), "holds 3 arrays: /scan/half (5 x 3 x 4), /scan/truth");
  check_volume(several + ":/scan/u8", SampleType::u8, "HDF5, /scan/u8, raw");
  check_volume(several + ":/scan/half", SampleType::f32, "HDF5, /scan/half, raw");
  CHECK(open_volume(several + ":/scan/slice")->info().dims ==
        std::array<std::uint32_t, 3>{5, 3, 1});
  for (const double truth : read_all(*open_volume(several + ":/scan/truth")))
    CHECK((truth == 0 || truth == 1));
}

TEST_CASE("a name behind that of a file which is no array of numbers is refused") {
  check_refusal(refusal(several + ":/scan/none"), "there is no dataset '/scan/none'");
  check_refusal(refusal(several + ":/scan"), "there is no dataset '/scan'");
  check_refusal(refusal(several + ":/scan/complex"), "holds other things than numbers");
  check_refusal(refusal(files / "none.h5"), "there is no such file");
}

TEST_CASE("a file whose name has a colon is taken as it is called") {
  const Folder folder;
  fs::create_directory(folder.path() / "a:");
  const fs::path file = folder.write("a:/volume.h5", contents(files / "hdf5/u8-little.h5"));
  check_volume(file, SampleType::u8, "HDF5, /volume, raw");
  check_volume(file.string() + ":/volume", SampleType::u8, "HDF5, /volume, raw");
}

TEST_CASE("the first bytes tell HDF5, but not in a pipe or packed") {
  const Folder folder;
  const std::string bytes = contents(files / "hdf5/u8-little.h5");
  check_volume(folder.write("volume", bytes), SampleType::u8, "HDF5, /volume, raw");
  check_refusal(refusal(folder.write("packed", gzip(bytes))),
                "HDF5 is not read from a pipe, nor packed");
}

TEST_CASE("what cannot be unpacked or has scales of its own is refused with the remedy") {
  check_refusal(refusal(files / "hdf5_arrays/packed.h5"),
                "filter 32001 of HDF5, which is not here");
  check_refusal(refusal(files / "hdf5_arrays/packed.h5"), "h5repack");
  check_refusal(refusal(files / "hdf5_arrays/minc.h5"), "mnc2nii");
}

TEST_CASE("samples of fewer bits than they have room for are numbers as others are") {
  const Folder folder;
  const fs::path file = folder.path() / "bits.h5";
  const std::vector<std::uint32_t> samples = {0, 1, 77, 4095, 0, 2048, 300, 9};
  {
    const Hdf5Handle type(H5Tcopy(H5T_STD_U32LE), H5Tclose);
    REQUIRE(H5Tset_precision(type.id(), 12) >= 0);
    const Hdf5Handle opened = new_file(file);
    const Hdf5Handle dataset = new_dataset(opened, "volume", {2, 2, 2}, no_creation(), type.id());
    H5Dwrite(dataset.id(), H5T_NATIVE_UINT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, samples.data());
  }
  const auto reader = open_volume(file);
  CHECK(reader->info().type == SampleType::u32);
  CHECK(read_all(*reader) == std::vector<double>(samples.begin(), samples.end()));
}

TEST_CASE("a virtual array is read from other files, and refused where one is not there") {
  const Folder folder;
  folder.write("source.h5", contents(files / "hdf5/u8-little.h5"));
  write_virtual(folder.path() / "there.h5", "source.h5");
  CHECK(read_all(*open_volume(folder.path() / "there.h5")) ==
        read_all(*open_volume(folder.path() / "source.h5")));
  write_virtual(folder.path() / "missing.h5", "none.h5");
  check_refusal(refusal(folder.path() / "missing.h5"), "the file 'none.h5', which is not there");
}

TEST_CASE("how large a slice can be is told by the file that it is in, behind a link") {
  const Folder folder;
  {
    const Hdf5Handle packed = chunks_of({1, 4000, 4000});
    H5Pset_deflate(packed.id(), 1);
    const std::vector<std::uint8_t> samples(16000000, 7);
    const Hdf5Handle opened = new_file(folder.path() / "large.h5");
    const Hdf5Handle dataset = new_dataset(opened, "volume", {1, 4000, 4000}, packed);
    H5Dwrite(dataset.id(), H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, samples.data());
    H5Lcreate_external("large.h5", "/volume", new_file(folder.path() / "link.h5").id(), "volume",
                       H5P_DEFAULT, H5P_DEFAULT);
  }
  const auto reader = open_volume(folder.path() / "link.h5:/volume");
  std::vector<std::uint8_t> slice(16000000);
  reader->read_slice(slice.data());
  CHECK(slice.back() == 7);
}

TEST_CASE("chunks too many to be kept are no reason to say that there is no array") {
  const Folder folder;
  new_dataset(new_file(folder.path() / "chunks.h5"), "volume", {3, 32766, 32766},
              chunks_of({1, 1, 1}));
  check_refusal(refusal(folder.path() / "chunks.h5"), "a slice of 1073610756 bytes cannot be in");
}

TEST_CASE("names with control characters are shown without") {
  const Folder folder;
  const fs::path file = folder.path() / "names.h5";
  new_dataset(new_file(file), "a\x1b[31m", {4, 3, 5}, no_creation());
  CHECK(open_volume(file)->info().format == "HDF5, /a_[31m, raw");
  {
    const Hdf5Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    new_dataset(opened, "b", {4, 3, 5}, no_creation());
  }
  check_refusal(refusal(file), "/a_[31m (5 x 3 x 4), /b");
}

TEST_CASE("the library tells no errors of its own, whichever thread reads") {
  const auto reader = open_volume(files / "hdf5/u8-little.h5");
  std::thread([&reader] {
    std::uint8_t slice[15];
    reader->read_slice(slice);
    H5E_auto2_t teller = nullptr;
    void* context = nullptr;
    REQUIRE(H5Eget_auto2(H5E_DEFAULT, &teller, &context) >= 0);
    const bool is_silent = teller == nullptr;
    CHECK(is_silent);
  }).join();
}

TEST_CASE("slices that are skipped are not those that are read") {
  for (const std::string name : {"i16-big-gzip.h5", "i16-little.h5"}) {
    const auto reader = open_volume(files / "hdf5" / name);
    reader->skip_slice();
    reader->skip_slice();
    std::int16_t slice[15];
    reader->read_slice(slice);
    for (int i = 0; i < 15; ++i) CHECK(slice[i] == sample_at(30 + i, SampleType::i16));
    reader->skip_slice();
    CHECK_THROWS_WITH_AS(reader->skip_slice(), doctest::Contains("all 4 slices"), VolumeError);
  }
}

TEST_CASE("a chunk is unpacked once, though several slices go through it") {
  const Folder folder;
  const fs::path file = folder.path() / "counted.h5";
  write_counted(file);
  unpacked_chunks = 0;
  const std::vector<double> samples = read_all(*open_volume(file));
  CHECK(samples == std::vector<double>(std::size_t{4} << 20, 7));
  CHECK(unpacked_chunks == 8);
}

TEST_CASE("a file that is cut off is refused, wherever it is cut") {
  const Folder folder;
  const std::string bytes = contents(files / "hdf5/i16-big-gzip.h5");
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    INFO("cut at ", size);
    const fs::path file = folder.write("cut.h5", bytes.substr(0, size));
    refusal(file);
  }
}

}  // namespace
#endif
