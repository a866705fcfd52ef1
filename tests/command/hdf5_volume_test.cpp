// HDF5 files of h5py (volumes/write_volumes.py): the choice of the array, refusals, and skipped
// slices. container_table_test has the sample types. Without the library the test is disabled, but
// compiled.
#if __has_include(<hdf5.h>)
#include <thread>

#include "command.hpp"
#include "volumes/formats/hdf5/dataset.hpp"
#include "volumes/formats/hdf5/handle.hpp"

namespace {

using namespace volume_files;
using discmc::command::Hdf5Handle;

constexpr H5Z_filter_t counting_filter = 256;  // the first number of filters for tests
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

Hdf5Handle reopened(const fs::path& file) {
  return {H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose};
}

using Sizes = std::vector<hsize_t>;

Hdf5Handle space_of(const Sizes& sizes) {
  return {H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose};
}

Hdf5Handle no_creation() {
  return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
}

Hdf5Handle chunks_of(const std::array<hsize_t, 3>& chunk) {
  Hdf5Handle creation = no_creation();
  H5Pset_chunk(creation.id(), 3, chunk.data());
  return creation;
}

// Makes the groups of a path.
Hdf5Handle with_groups() {
  Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  return links;
}

// A dataset of zeros, until samples are written.
Hdf5Handle new_dataset(const Hdf5Handle& file, const char* path, const Sizes& sizes = {4, 3, 5},
                       const Hdf5Handle& creation = no_creation(), hid_t type = H5T_STD_U8LE) {
  Hdf5Handle dataset(H5Dcreate2(file.id(), path, type, space_of(sizes).id(), with_groups().id(),
                                creation.id(), H5P_DEFAULT),
                     H5Dclose);
  REQUIRE(dataset);
  return dataset;
}

template <class Number>
void write_samples(const Hdf5Handle& dataset, const std::vector<Number>& samples, hid_t type) {
  REQUIRE(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, samples.data()) >= 0);
}

using Bytes = std::vector<std::uint8_t>;

Hdf5Handle new_dataset(const Hdf5Handle& file, const char* path, const Sizes& sizes,
                       const Bytes& samples) {
  Hdf5Handle dataset = new_dataset(file, path, sizes);
  write_samples(dataset, samples, H5T_NATIVE_UINT8);
  return dataset;
}

// A dataset of one chunk, packed before, that the filter unpacks.
void write_packed(const fs::path& file, const std::array<hsize_t, 3>& sizes, H5Z_filter_t filter,
                  const std::string& packed) {
  const Hdf5Handle creation = chunks_of(sizes);
  H5Pset_filter(creation.id(), filter, H5Z_FLAG_OPTIONAL, 0, nullptr);
  const Hdf5Handle opened = new_file(file);
  const Hdf5Handle dataset =
      new_dataset(opened, "volume", {sizes[0], sizes[1], sizes[2]}, creation);
  constexpr hsize_t first[] = {0, 0, 0};
  REQUIRE(H5Dwrite_chunk(dataset.id(), H5P_DEFAULT, 0, first, packed.size(), packed.data()) >= 0);
}

Hdf5Handle new_group(const Hdf5Handle& file, const char* path) {
  return {H5Gcreate2(file.id(), path, with_groups().id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

void write_attribute(const Hdf5Handle& object, const char* name, hid_t type, std::size_t count,
                     const void* values) {
  const Hdf5Handle attribute(
      H5Acreate2(object.id(), name, type, space_of({count}).id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  REQUIRE(H5Awrite(attribute.id(), type, values) >= 0);
}

void write_texts(const Hdf5Handle& object, const char* name,
                 const std::vector<std::string>& texts) {
  constexpr std::size_t bytes = 32;
  std::string all;
  for (const std::string& text : texts) all += text + std::string(bytes - text.size(), '\0');
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), bytes);
  write_attribute(object, name, type.id(), texts.size(), all.data());
}

void write_numbers(const Hdf5Handle& object, const char* name, const std::vector<double>& numbers) {
  write_attribute(object, name, H5T_NATIVE_DOUBLE, numbers.size(), numbers.data());
}

void write_virtual(const fs::path& file, const char* source) {
  const Hdf5Handle space = space_of({4, 3, 5}), creation = no_creation();
  REQUIRE(H5Pset_virtual(creation.id(), space.id(), source, "volume", space.id()) >= 0);
  new_dataset(new_file(file), "volume", {4, 3, 5}, creation);
}

// Four slices in two layers of four chunks, with a counting filter. The chunks exceed the library's
// cache (1 MiB).
void write_counted(const fs::path& file) {
  const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, counting_filter, 1,       1,
                               "counting",       nullptr,         nullptr, count_unpacked};
  REQUIRE(H5Zregister(&filter) >= 0);
  const Hdf5Handle creation = chunks_of({2, 512, 512});
  H5Pset_filter(creation.id(), counting_filter, 0, 0, nullptr);
  write_samples(new_dataset(new_file(file), "volume", {4, 1024, 1024}, creation),
                Bytes(std::size_t{4} << 20, 7), H5T_NATIVE_UINT8);
}

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes";
const std::string several = files / "hdf5_arrays/several.hdf5";

struct Hdf5File : Folder {
  const fs::path file = path() / "v.h5";
};

TEST_CASE("the only HDF5 array of three dimensions is the volume") {
  check_volume(files / "hdf5/i16-big-gzip.h5", SampleType::i16,
               "HDF5, /exchange/data, shuffle, gzip, fletcher32");
}

TEST_CASE("one of several HDF5 arrays is chosen by FILE:NAME") {
  check_refused(several, "holds 3 arrays: /scan/half (5 x 3 x 4), /scan/truth");
  check_volume(several + ":/scan/u8", "HDF5, /scan/u8, raw");
  check_volume(several + ":/scan/half", SampleType::f32, "HDF5, /scan/half, raw");
  CHECK(read_info(several + ":/scan/slice").dims == Dims{5, 3, 1});
  for (const double truth : read_samples(several + ":/scan/truth"))
    CHECK((truth == 0 || truth == 1));
}

TEST_CASE("FILE:NAME is refused if NAME is no array of numbers in the HDF5 file") {
  for (const std::string name : {"/scan/none", "/scan", "/scan/complex"})
    check_refused(several + ":" + name,
                  "there is no array '" + name +
                      "' of numbers with two or more dimensions in the file; choose one of "
                      "/scan/half (5 x 3 x 4)");
  check_refused(files / "none.h5", "there is no such file");
}

TEST_CASE_FIXTURE(Folder, "the name of an HDF5 file may contain a colon") {
  const fs::path file = write("a:/volume.h5", contents(files / "hdf5/u8-little.h5"));
  check_volume(file, "HDF5, /volume, raw");
  check_volume(file.string() + ":/volume", "HDF5, /volume, raw");
}

TEST_CASE_FIXTURE(Folder, "HDF5 is recognized by its first bytes") {
  check_volume(write("volume", contents(files / "hdf5/u8-little.h5")), "HDF5, /volume, raw");
}

TEST_CASE(
    "an HDF5 array with an unsupported filter or scales of its own is refused with the remedy") {
  const fs::path packed = files / "hdf5_arrays/packed.h5";
  check_refused(packed, "packed by the filter 32008 of HDF5, which is not installed");
  check_refused(packed, "h5py.File('" + packed.string() + "')['/volume'][()]");
  check_refused(files / "hdf5_arrays/minc.h5", "mnc2nii");
}

// Skipped unless Python has both modules: on Debian, python3-hdf5plugin and hdf5-filter-plugin.
TEST_CASE_FIXTURE(
    Folder, "the command advised for a packed HDF5 array unpacks the array into a readable file") {
  const command_tests::Workshop workshop;
  if (workshop.shell("/usr/bin/python3 -c 'import h5py, hdf5plugin'").code != 0) {
    MESSAGE("not run: this Python has no h5py or no hdf5plugin");
    return;
  }
  workshop.write("volume", u8);
  REQUIRE(workshop.shell("bzip2 -c volume > packed").code == 0);
  constexpr H5Z_filter_t bzip2 = 307;
  write_packed(path() / "a.h5", {4, 3, 5}, bzip2, workshop.read("packed"));
  workshop.write("a.h5", contents(path() / "a.h5"));
  const std::string refused =
      workshop.shell("HDF5_PLUGIN_PATH=/nonexistent \"$discmc\" info a.h5").error;
  const std::size_t begin = refused.find("python3 -c");
  INFO(refused);
  REQUIRE(begin != std::string::npos);
  const auto unpacked = workshop.shell("PATH=/usr/bin:$PATH; " + refused.substr(begin));
  INFO(unpacked.error);
  CHECK(unpacked.code == 0);
  check_volume(write("unpacked.h5", workshop.read("unpacked.h5")), "HDF5, /volume, raw");
}

TEST_CASE_FIXTURE(Hdf5File, "file names in an advised command are quoted for the shell") {
  {
    const Hdf5Handle creation = chunks_of({4, 3, 5});
    H5Pset_filter(creation.id(), 32008, H5Z_FLAG_OPTIONAL, 0, nullptr);
    new_dataset(new_file(file), "$(reboot)", {4, 3, 5}, creation);
  }
  check_refused(file, "')['NAME'][()]");
}

// An LZF stream with every kind of part, including a long one and one that overlaps its own output.
std::string lzf_of_runs() {
  const std::string literal("\3\1\2\3\4", 5);  // four literals
  const std::string again("\x20\x03", 2);      // three bytes, copied from four bytes before
  const std::string run("\xe0\x0c\0", 3);      // 21 times the last byte
  const std::string far("\x60\x1b", 2);        // five bytes, copied from 28 bytes before
  return literal + again + run + far;
}

TEST_CASE_FIXTURE(Hdf5File, "LZF of h5py is unpacked, and damaged LZF is refused") {
  check_volume(files / "hdf5/i16-big-lzf.h5", SampleType::i16, "HDF5, /volume, shuffle, lzf");
  const auto write = [&](const std::string& packed) {
    H5Zunregister(32000);  // it only reads, and prevents writing
    write_packed(file, {1, 1, 33}, 32000, packed);
  };
  write(lzf_of_runs());
  std::vector<double> expected = {1, 2, 3, 4, 1, 2, 3};
  expected.resize(28, 3);
  expected.insert(expected.end(), {1, 2, 3, 4, 1});
  CHECK(read_samples(file) == expected);
  for (const std::string& damaged :
       {std::string("\x20\x03", 2), std::string("\5\1", 2), std::string("\xe0", 1)}) {
    write(damaged);
    check_refused(file, "damaged or missing");
  }
}

TEST_CASE_FIXTURE(Folder,
                  "HDF5 links to other files are followed, and a linked array counts once") {
  check_volume(files / "hdf5_arrays/master.h5", "HDF5, /entry/data/data_000001, raw");
  write("master.h5", contents(files / "hdf5_arrays/master.h5"));
  check_refused(path() / "master.h5",
                "its links lead nowhere: /entry/data/data_000001 to data_000001.h5");
  new_dataset(reopened(path() / "master.h5"), "here");
  const VolumeInfo info = read_info(path() / "master.h5");
  CHECK(info.format == "HDF5, /here, raw");
  CHECK(noted(info, "links that lead nowhere: /entry/data/data_000001 to data_000001.h5"));
}

TEST_CASE("the axis names in ilastik's attributes determine x, y and z") {
  const fs::path file = files / "hdf5_arrays/ilastik.h5";
  check_volume(file, "HDF5, /exported_data, raw");
  CHECK_FALSE(noted(read_info(file), "dropped"));
}

TEST_CASE_FIXTURE(
    Hdf5File,
    "--axes names the axes of an HDF5 array in any order, and samples keep their coordinates") {
  Bytes samples(120);
  std::iota(samples.begin(), samples.end(), std::uint8_t{0});
  for (const bool is_chunked : {false, true})
    for (const std::string axes : {"zyx", "zxy", "yzx", "yxz", "xzy", "xyz"}) {
      INFO(axes, is_chunked ? " in chunks" : "");
      write_samples(new_dataset(new_file(file), "volume", {4, 5, 6},
                                is_chunked ? chunks_of({2, 2, 3}) : no_creation()),
                    samples, H5T_NATIVE_UINT8);
      const auto reader = open_volume(file, with_axes(axes));
      const auto& dims = reader->info().dims;
      const auto read = read_all(*reader);
      constexpr std::array<std::size_t, 3> sizes{4, 5, 6};
      std::array<std::size_t, 3> index{};
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        for (std::size_t axis = 0, rest = i; axis < 3; ++axis) {
          index[2 - axis] = rest % sizes[2 - axis];
          rest /= sizes[2 - axis];
        }
        const auto at = [&](char letter) { return index[axes.find(letter)]; };
        wrong += read[(at('z') * dims[1] + at('y')) * dims[0] + at('x')] != samples[i];
      }
      CHECK(wrong == 0);
    }
}

TEST_CASE_FIXTURE(Folder, "a note names which index of a MATLAB array is x") {
  const fs::path file = path() / "volume.mat";
  {
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_userblock(creation.id(), 512);
    const Hdf5Handle opened(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation.id(), H5P_DEFAULT),
                            H5Fclose);
    write_texts(new_dataset(opened, "V"), "MATLAB_class", {"uint8"});
    new_dataset(opened, "#refs#/a");
  }
  std::string bytes = contents(file);
  bytes.replace(0, 10, "MATLAB 7.3");
  write("volume.mat", bytes);
  const VolumeInfo info = read_info(file);
  CHECK(info.format == "HDF5, /V, raw");
  CHECK(noted(info, "its first index is read as x; if it is y, give --axes zxy"));
}

TEST_CASE_FIXTURE(Hdf5File, "padded Imaris arrays are refused with the name of a converter") {
  new_dataset(new_file(file), "DataSet/ResolutionLevel 0/TimePoint 0/Channel 0/Data");
  check_refused(file, "this is Imaris, which pads its arrays");
}

TEST_CASE_FIXTURE(Hdf5File,
                  "HDF5 bitfields, and samples of fewer bits than their storage, are read") {
  const auto check = [this](SampleType type, const auto& samples) {
    const auto reader = open_volume(file);
    CHECK(reader->info().type == type);
    CHECK(read_all(*reader) == std::vector<double>(samples.begin(), samples.end()));
  };
  const std::vector<std::uint32_t> samples = {0, 1, 77, 4095, 0, 2048, 300, 9};
  const Hdf5Handle of_12_bits(H5Tcopy(H5T_STD_U32LE), H5Tclose);
  REQUIRE(H5Tset_precision(of_12_bits.id(), 12) >= 0);
  write_samples(new_dataset(new_file(file), "volume", {2, 2, 2}, no_creation(), of_12_bits.id()),
                samples, H5T_NATIVE_UINT32);
  check(SampleType::u32, samples);
  const Bytes bits = {0, 1, 1, 0, 0, 0, 1, 0};  // as PyTables stores truth values
  write_samples(new_dataset(new_file(file), "mask", {2, 2, 2}, no_creation(), H5T_STD_B8LE), bits,
                H5T_NATIVE_B8);
  check(SampleType::u8, bits);
}

TEST_CASE_FIXTURE(Folder,
                  "a virtual HDF5 array is read, and refused if one of its files is missing") {
  write("source.h5", contents(files / "hdf5/u8-little.h5"));
  write_virtual(path() / "there.h5", "source.h5");
  CHECK(read_samples(path() / "there.h5") == read_samples(path() / "source.h5"));
  write_virtual(path() / "missing.h5", "none.h5");
  check_refused(path() / "missing.h5", "the file 'none.h5', which is missing");
}

TEST_CASE_FIXTURE(
    Folder,
    "the size limit of a linked HDF5 array's slices depends on the file that holds the array") {
  const Hdf5Handle packed = chunks_of({1, 4000, 4000});
  H5Pset_deflate(packed.id(), 1);
  write_samples(new_dataset(new_file(path() / "large.h5"), "volume", {1, 4000, 4000}, packed),
                Bytes(16000000, 7), H5T_NATIVE_UINT8);
  H5Lcreate_external("large.h5", "/volume", new_file(path() / "link.h5").id(), "volume",
                     H5P_DEFAULT, H5P_DEFAULT);
  const auto reader = open_volume(path() / "link.h5:/volume");
  Bytes slice(16000000);
  reader->read_slice(slice.data());
  CHECK(slice.back() == 7);
}

TEST_CASE_FIXTURE(
    Folder, "an HDF5 array with too many chunks is still found, and refused by its slice size") {
  new_dataset(new_file(path() / "chunks.h5"), "volume", {3, 32766, 32766}, chunks_of({1, 1, 1}));
  check_refused(path() / "chunks.h5", "a slice of 1073610756 bytes cannot be in");
}

TEST_CASE_FIXTURE(Hdf5File, "control characters in names of HDF5 arrays are not printed") {
  new_dataset(new_file(file), "a\x1b[31m");
  CHECK(read_info(file).format == "HDF5, /a_[31m, raw");
  new_dataset(reopened(file), "b");
  check_refused(file, "/a_[31m (5 x 3 x 4), /b");
}

TEST_CASE("libhdf5 prints no errors of its own, in any thread") {
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

TEST_CASE("reading an HDF5 array continues at the right slice after a skip") {
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

TEST_CASE_FIXTURE(Hdf5File, "an HDF5 chunk of several slices is unpacked once") {
  write_counted(file);
  unpacked_chunks = 0;
  CHECK(read_samples(file) == std::vector<double>(std::size_t{4} << 20, 7));
  CHECK(unpacked_chunks == 8);
}

TEST_CASE_FIXTURE(Folder, "an HDF5 file truncated at any byte is refused") {
  const std::string bytes = contents(files / "hdf5/i16-big-gzip.h5");
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    INFO("cut at ", size);
    refusal(write("cut.h5", bytes.substr(0, size)));
  }
}

void write_dataset(const Hdf5Handle& file, const char* path, const Sizes& sizes,
                   const std::vector<double>& numbers, const char* unit = nullptr) {
  const Hdf5Handle dataset = new_dataset(file, path, sizes, no_creation(), H5T_IEEE_F64LE);
  write_samples(dataset, numbers, H5T_NATIVE_DOUBLE);
  if (unit != nullptr) write_texts(dataset, "units", {unit});
}

// Coordinates of each axis, as in NetCDF.
struct Scale {
  const char* name;
  std::vector<double> coordinates;
};

void write_coordinates(const Hdf5Handle& file, const Scale& scale, const char* unit = "mm") {
  write_dataset(file, scale.name, {scale.coordinates.size()}, scale.coordinates, unit);
}

void write_scales(const Hdf5Handle& file, const Hdf5Handle& dataset,
                  const std::vector<Scale>& scales) {
  std::vector<hobj_ref_t> references(scales.size());
  std::vector<hvl_t> list;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    write_coordinates(file, scales[i]);
    H5Rcreate(&references[i], file.id(), scales[i].name, H5R_OBJECT, -1);
    list.push_back({1, &references[i]});
  }
  const Hdf5Handle type(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
  write_attribute(dataset, "DIMENSION_LIST", type.id(), list.size(), list.data());
}

TEST_CASE_FIXTURE(Folder, "NetCDF dimension scales name and place the axes, in any order") {
  const fs::path file = path() / "v.nc";
  {
    const Hdf5Handle opened = new_file(file);
    const Hdf5Handle dataset =
        new_dataset(opened, "density", {3, 2, 2}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    write_scales(opened, dataset, {{"lon", {5, 7, 9}}, {"lat", {50, 48.5}}, {"lev", {0, 4}}});
  }
  const auto reader = open_volume(file);
  CHECK(reader->info().dims == Dims{3, 2, 2});
  check_grid(reader->info(), {2, -1.5, 4}, {5, 50, 0});
  CHECK(read_all(*reader) == std::vector<double>{1, 5, 9, 3, 7, 11, 2, 6, 10, 4, 8, 12});
}

TEST_CASE_FIXTURE(Hdf5File, "uneven NetCDF coordinates are refused, unless --spacing is given") {
  {
    const Hdf5Handle opened = new_file(file);
    write_scales(opened, new_dataset(opened, "density", {3, 2, 2}),
                 {{"lev", {0, 4, 9}}, {"lat", {0, 1}}, {"lon", {0, 1}}});
  }
  check_refused(file, "the coordinates of the axis 'lev' are uneven, from 0 to 9");
  CHECK(read_info(file, {{}, Spacing{1, 1, 2}}).spacing_mm == Spacing{1, 1, 2});
}

TEST_CASE_FIXTURE(Hdf5File, "NetCDF's packed values are scaled, and its fill value becomes NaN") {
  {
    const Hdf5Handle dataset =
        new_dataset(new_file(file), "density", {1, 2, 2}, {10, 200, 255, 10});
    write_numbers(dataset, "scale_factor", {2});
    write_numbers(dataset, "add_offset", {20});
    write_numbers(dataset, "_FillValue", {255});
  }
  const auto reader = open_volume(file);
  const auto values = read_all(*reader);
  CHECK(reader->info().slope == 1);
  CHECK(values[0] == 40);
  CHECK(values[1] == 420);
  CHECK(std::isnan(values[2]));
  CHECK(read_samples(file, with(&VolumeOptions::holds_labels, true))[2] == 530);
}

TEST_CASE_FIXTURE(
    Hdf5File, "NetCDF's _Unsigned determines the sign of integer samples and of the fill value") {
  for (const bool is_unsigned : {true, false}) {
    {
      const Hdf5Handle dataset = new_dataset(new_file(file), "density", {1, 2, 2}, no_creation(),
                                             is_unsigned ? H5T_STD_I8LE : H5T_STD_U8LE);
      write_samples(dataset, Bytes{10, 200, 254, 255},
                    is_unsigned ? H5T_NATIVE_INT8 : H5T_NATIVE_UINT8);
      write_texts(dataset, "_Unsigned", {is_unsigned ? "true" : "False"});
      write_numbers(dataset, "_FillValue", {is_unsigned ? -1.0 : 255.0});
    }
    const auto values = read_samples(file);
    CHECK(values[0] == 10);
    CHECK(values[1] == (is_unsigned ? 200 : -56));
    CHECK(values[2] == (is_unsigned ? 254 : -2));
    CHECK(std::isnan(values[3]));
  }
}

TEST_CASE_FIXTURE(Hdf5File, "a NetCDF fill value of NaN leaves other samples unchanged") {
  for (const char* const name : {"_FillValue", "missing_value"}) {
    const bool is_nan = name[0] == '_';
    write_numbers(new_dataset(new_file(file), "density", {1, 2, 2}), name,
                  {is_nan ? std::nan("") : 0});
    CHECK(std::isnan(read_samples(file)[0]) != is_nan);
  }
}

TEST_CASE_FIXTURE(Folder, "the geometry of DREAM3D-NX places its arrays") {
  const fs::path file = path() / "v.dream3d";
  {
    const Hdf5Handle group = new_group(new_file(file), "DataStructure/Image");
    write_numbers(group, "_SPACING", {2, 3, 4});
    write_numbers(group, "_ORIGIN", {5, 6, 7});
    new_dataset(group, "Cell Data/Ids", {4, 3, 5, 1});
  }
  check_grid(read_info(file), {2, 3, 4}, {5, 6, 7});
}

TEST_CASE_FIXTURE(Hdf5File, "an ITK image in HDF5 has the stored spacing, origin and directions") {
  {
    const Hdf5Handle opened = new_file(file);
    new_dataset(opened, "ITKImage/0/VoxelData");
    write_dataset(opened, "ITKImage/0/Spacing", {3}, {2, 3, 4});
    write_dataset(opened, "ITKImage/0/Origin", {3}, {5, 6, 7});
    write_dataset(opened, "ITKImage/0/Directions", {3, 3}, {0, 1, 0, -1, 0, 0, 0, 0, 1});
  }
  const VolumeInfo info = read_info(file);
  check_grid(info, {2, 3, 4}, {5, 6, 7});
  CHECK(info.placement->space == Space::lps);
  CHECK(info.placement->axes_mm[0] == Vector{0, 2, 0});
  CHECK(info.placement->axes_mm[1] == Vector{-3, 0, 0});
}

TEST_CASE_FIXTURE(
    Hdf5File,
    "signed samples of BigDataViewer are read as unsigned, and an unapplied valid_max is noted") {
  {
    const Hdf5Handle cells =
        new_dataset(new_file(file), "t00000/s00/0/cells", {1, 2, 2}, no_creation(), H5T_STD_I16LE);
    write_samples(cells, std::vector<std::int16_t>{-1, 2, 3, 4}, H5T_NATIVE_INT16);
    write_numbers(cells, "valid_max", {9});
  }
  const auto reader = open_volume(file);
  CHECK(noted(reader->info(), "valid_max is not applied"));
  CHECK(read_all(*reader)[0] == 65535);
}

TEST_CASE_FIXTURE(Hdf5File, "resolution and offset of CREMI files are in nanometres") {
  {
    const Hdf5Handle dataset = new_dataset(new_file(file), "labels");
    write_numbers(dataset, "resolution", {40, 4, 8});
    write_numbers(dataset, "offset", {400, 0, 0});
  }
  const VolumeInfo info = read_info(file);
  CHECK(info.spacing_mm[0] == doctest::Approx(8e-6));
  CHECK(info.spacing_mm[2] == doctest::Approx(40e-6));
  REQUIRE(info.placement);
  CHECK(info.placement->origin_mm[2] == doctest::Approx(400e-6));
}

TEST_CASE_FIXTURE(Hdf5File, "an HDF5 spacing attribute of unknown order and unit is noted") {
  write_numbers(new_dataset(new_file(file), "v"), "spacing", {4, 2, 1});
  const VolumeInfo info = read_info(file);
  CHECK(noted(info, "spacing is not used, because its order and unit are unknown"));
  CHECK(noted(info, "no spacing given"));
}

TEST_CASE_FIXTURE(Folder,
                  "NeXus axes place an array, whether they list voxel centres or voxel borders") {
  const fs::path file = path() / "v.nxs";
  for (const bool is_older : {false, true}) {
    {
      const Hdf5Handle group = new_group(new_file(file), "entry");
      const Hdf5Handle dataset = new_dataset(group, "data");
      if (is_older) {
        write_texts(dataset, "axes", {"[height:theta,x]"});
      } else {
        write_texts(group, "signal", {"data"});
        write_texts(group, "axes", {"height", "theta", "x"});
      }
      write_coordinates(group, {"height", {0, 3, 6, 9}}, "um");
      write_coordinates(group, {"x", {1, 3, 5, 7, 9, 11}});
    }
    const VolumeInfo info = read_info(file);
    check_grid(info, {2, 1, 0.003}, {2, 0, 0});
    CHECK(noted(info, "no spacing of axis 2 given"));
  }
  write_coordinates(reopened(file), {"/entry/theta", {0, 1, 5}});
  check_refused(file, "the coordinates of the axis 'theta' are uneven, from 0 to 5");
}

TEST_CASE_FIXTURE(Folder, "the dimensions of an EMD file name and place the axes of its array") {
  const fs::path file = path() / "v.emd";
  for (const std::size_t first : {1U, 0U}) {
    {
      const Hdf5Handle group = new_group(new_file(file), "scan");
      write_numbers(group, "emd_group_type", {1});
      new_dataset(group, "data", {5, 3, 4});
      // Version 1 counts from 0, and stores two coordinates.
      const std::vector<double> x =
          first == 1 ? std::vector<double>{5, 7, 9, 11, 13} : std::vector<double>{5, 7};
      const std::vector<double> all[] = {x, {0, 3, 6}, {0, 4, 8, 12}};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::string name = "dim" + std::to_string(first + i);
        write_coordinates(group, {name.c_str(), all[i]}, i == 0 ? "[u_m]" : "um");
        write_texts({H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), H5Oclose}, "name",
                    {std::string(1, "xyz"[i])});
      }
    }
    const VolumeInfo info = read_info(file);
    CHECK(info.dims == Dims{5, 3, 4});
    check_grid(info, {0.002, 0.003, 0.004}, {0.005, 0, 0});
  }
}

TEST_CASE_FIXTURE(Folder,
                  "a ChimeraX map has its step and origin; its smaller copies are ignored") {
  const fs::path file = path() / "v.cmap";
  for (const bool is_oblique : {false, true}) {
    {
      const Hdf5Handle group = new_group(new_file(file), "Chimera/image1");
      new_dataset(group, "data_zyx");
      new_dataset(group, "data_zyx_2", {2, 2, 3});
      write_numbers(group, "step", {2, 3, 4});
      write_numbers(group, "origin", {5, 6, 7});
      write_numbers(group, "cell_angles", {90, 90, is_oblique ? 120.0 : 90});
    }
    const VolumeInfo info = read_info(file);
    CHECK(info.dims == Dims{5, 3, 4});
    check_grid(info, {2, 3, 4}, {5, 6, 7});
    CHECK(noted(info, "1 angstrom is written as 1 mm"));
    CHECK(noted(info, "its cell is oblique") == is_oblique);
  }
}

// An image of VTK with an array of zeros, and with ghost marks.
void write_vtk(const fs::path& file, const char* type, const std::vector<double>& extent,
               const char* array, const Sizes& sizes, bool has_times = false) {
  const Hdf5Handle group = new_group(new_file(file), "VTKHDF");
  write_texts(group, "Type", {type});
  write_numbers(group, "WholeExtent", extent);
  write_numbers(group, "Origin", {1, 2, 3});
  write_numbers(group, "Spacing", {2, 3, 4});
  write_numbers(group, "Direction", {0, -1, 0, 1, 0, 0, 0, 0, 1});
  for (const char* const name : {"PointData", "CellData"}) new_group(group, name);
  if (has_times) new_group(group, "Steps");
  new_dataset(group, array, sizes);
  new_dataset(group, "PointData/vtkGhostType");
}

TEST_CASE_FIXTURE(Folder, "a VTK image in HDF5 is placed by its attributes") {
  const fs::path file = path() / "v.vtkhdf";
  write_vtk(file, "ImageData", {5, 9, 0, 2, -1, 2}, "PointData/a", {4, 3, 5});
  const VolumeInfo info = read_info(file);
  check_axes(info, {{{0, 2, 0}, {-3, 0, 0}, {0, 0, 4}}}, {1, 12, -1});
  CHECK_FALSE(noted(info, "the axes are not named"));
  CHECK(read_info(file, with_axes("yzx")).placement->axes_mm ==
        Axes{{{0, 2, 0}, {0, 0, 4}, {-3, 0, 0}}});

  const std::vector<double> larger = {0, 5, 0, 3, 0, 4};
  write_vtk(file, "ImageData", larger, "CellData/a", {4, 3, 5});
  CHECK(read_info(file).placement->origin_mm == Vector{-0.5, 3, 5});
  write_vtk(file, "ImageData", larger, "PointData/a", {4, 3, 5});
  check_refused(file, "the array has 5 voxels along axis 1, and WholeExtent 6");
  write_vtk(file, "ImageData", larger, "PointData/a", {5, 4, 6, 2});
  check_refused(file, "the file holds 2 channels");
  write_vtk(file, "ImageData", larger, "PointData/a", {2, 5, 4, 6}, true);
  check_refused(file, "the file holds 2 volumes");
  write_vtk(file, "UnstructuredGrid", {0, 4, 0, 2, 0, 3}, "PointData/a", {4, 3, 5});
  check_refused(file, "this is VTK's 'UnstructuredGrid', not ImageData");
}

}  // namespace
#endif
