// Arrays of NumPy: the order of axes, either order of storage, and halves. container_table_test has
// the sample types.
#include "volume_files.hpp"

namespace {

using namespace volume_files;

// u16 samples of an array, the last index fastest, with the values of value(index).
template <class Value>
std::string array_of(const std::vector<int>& sizes, Value value) {
  std::string bytes;
  std::vector<int> index(sizes.size(), 0);
  for (bool is_inside = true; is_inside;) {
    const int sample = value(index);
    bytes += {static_cast<char>(sample & 0xff), static_cast<char>(sample >> 8)};
    std::size_t axis = sizes.size();
    while (axis-- > 0 && ++index[axis] == sizes[axis]) index[axis] = 0;
    is_inside = axis < sizes.size();
  }
  return bytes;
}

// The volume of 5 x 3 x 4 voxels in which a sample encodes its position.
int sample_of(int x, int y, int z) {
  return 1000 + 100 * z + 10 * y + x;
}

void check_places(const fs::path& file, const VolumeOptions& options) {
  const auto reader = open_volume(file, options);
  CHECK(reader->info().dims == Dims{5, 3, 4});
  std::vector<double> expected;
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x) expected.push_back(sample_of(x, y, z));
  CHECK(read_all(*reader) == expected);
}

constexpr int size_along(char letter) {
  switch (letter) {
    case 'x':
      return 5;
    case 'y':
      return 3;
    case 'z':
      return 4;
    case 't':
      return 2;
    default:
      return 6;  // channels
  }
}

std::string shape_of(const std::string& letters) {
  std::string shape;
  for (const char letter : letters) shape += std::to_string(size_along(letter)) + ", ";
  return shape;
}

// An array with these axes, the first one slowest. Volume 1, channel 4 of it is the array above.
std::string array_with(const std::string& letters) {
  std::vector<int> sizes;
  for (const char letter : letters) sizes.push_back(size_along(letter));
  return array_of(sizes, [&letters](const std::vector<int>& index) {
    const auto at = [&](char letter) {
      const std::size_t axis = letters.find(letter);
      return axis == std::string::npos ? 0 : index[axis];
    };
    const bool is_other = (letters.find('t') != std::string::npos && at('t') != 1) ||
                          (letters.find('c') != std::string::npos && at('c') != 4);
    return is_other ? 7 : sample_of(at('x'), at('y'), at('z'));
  });
}

TEST_CASE_FIXTURE(Folder,
                  "NumPy arrays are read with --axes in any order, stored in C or Fortran order") {
  for (const std::string letters : {"zyx", "zxy", "yzx", "yxz", "xzy", "xyz", "tzyx", "xyzt",
                                    "zyxc", "czyx", "tczyx", "ztyxc", "cxyzt", "xytzc"}) {
    INFO(letters);
    VolumeOptions options = with_axes(letters);
    if (letters.find('t') != std::string::npos) options.frame = 1;
    if (letters.find('c') != std::string::npos) options.channel = 4;
    check_places(write("c.npy", npy("<u2", shape_of(letters), array_with(letters))), options);

    const std::string reversed(letters.rbegin(), letters.rend());
    options.axes = reversed;
    const bool is_fortran = true;
    check_places(write("f.npy", npy("<u2", shape_of(reversed), array_with(letters), is_fortran)),
                 options);
  }
}

TEST_CASE_FIXTURE(Folder,
                  "without --axes, the contiguous axis of a NumPy array is x, with a note") {
  const auto file = write("c.npy", npy("<u2", shape_of("zyx"), array_with("zyx")));
  check_places(file, {});
  CHECK(noted(read_info(file), "read as array[z][y][x]; to read others, give --axes, such as xyz"));
  CHECK_FALSE(noted(read_info(file, with_axes("zyx")), "read as"));
  const auto fortran = write("f.npy", npy("<u2", shape_of("xyz"), array_with("zyx"), true));
  check_places(fortran, {});
  CHECK(noted(read_info(fortran),
              "read as array[x][y][z]; to read others, give --axes, such as zyx"));
}

TEST_CASE_FIXTURE(Folder, "skipping slices of a NumPy array works for any order of axes") {
  for (const std::string letters : {"zxy", "xyz", "yzx"}) {
    INFO(letters);
    const auto file = write("a.npy", npy("<u2", shape_of(letters), array_with(letters)));
    const auto reader = open_volume(file, with_axes(letters));
    reader->skip_slice();
    reader->skip_slice();
    std::vector<std::uint16_t> slice(15);
    reader->read_slice(slice.data());
    CHECK(slice[7] == sample_of(2, 1, 2));
    reader->skip_slice();
    CHECK_THROWS_WITH_AS(reader->read_slice(slice.data()), doctest::Contains("all 4 slices"),
                         VolumeError);
  }
}

TEST_CASE_FIXTURE(Folder, "NumPy axes of size 1 are dropped at any position, with a note") {
  for (const std::string shape :
       {"1, 4, 3, 5", "4, 3, 5, 1", "1, 4, 3, 5, 1", "1, 1, 4, 3, 5", "4, 1, 3, 5"}) {
    INFO(shape);
    const auto file = write("a.npy", npy("<u2", shape, array_with("zyx")));
    check_places(file, {});
    CHECK(noted(read_info(file), "axes of size 1 are dropped from "));
  }
  const auto image = write("image.npy", npy("<u2", "1, 1, 12, 5", array_with("zyx")));
  CHECK(read_info(image).dims == Dims{5, 12, 1});
}

TEST_CASE_FIXTURE(Folder,
                  "a NumPy array with more than three axes requires --frame or suitable --axes") {
  const auto file = write("a.npy", npy("<u2", shape_of("zyxc"), array_with("zyxc")));
  check_refused(
      file,
      "holds 4 volumes, and one is read at a time; choose one with --frame N, the first is 0; or "
      "name the axes of the array, 4 x 3 x 5 x 6, with --axes, as in --axes zyxc");
  check_refused(file, with_axes("zyxc"), "holds 6 channels, and one is read at a time");
  check_refused(file, with_axes("zyx"), "the axes are named 'zyx', but the array is 4 x 3 x 5 x 6");
  VolumeOptions options = with_axes("zyxc");
  options.channel = 6;
  check_refused(file, options, "no channel 6: the file holds 6");
  const auto plain = write("plain.npy", npy("<u2", shape_of("zyx"), array_with("zyx")));
  options.axes = "zyx";
  check_refused(plain, options, "no channel 6: the file holds 1; leave out --channel");
  check_refused(write("none.npy", npy("<u2", "0, 3, 5", "")), "0 x 3 x 5");
  const std::string beyond = "4294967296, 4294967296, 5";
  check_refused(write("beyond.npy", npy("<u2", beyond, "")), "more than a file can hold");
}

TEST_CASE_FIXTURE(Folder, "--axes is refused for a format with fixed axes") {
  const auto file = write("a.nii", Nifti().file(u8));
  check_refused(file, with_axes("zyx"), "--axes applies to arrays and TIFF, and this is NIfTI-1");
}

TEST_CASE_FIXTURE(Folder, "16-bit floating-point samples are read as 32-bit floating point") {
  // Numbers of every kind, from their bits in IEEE 754.
  struct Half {
    std::uint16_t bits;
    double value;
  };
  const Half halves[] = {{0x0000, 0},
                         {0x3c00, 1},
                         {0xc000, -2},
                         {0x7bff, 65504},
                         {0x3555, 0.333251953125},
                         {0x0400, 0x1p-14},
                         {0x03ff, 1023 * 0x1p-24},
                         {0x8001, -0x1p-24}};
  for (const bool is_big_endian : {false, true}) {
    std::string samples;
    for (const Half& half : halves) {
      const char high = static_cast<char>(half.bits >> 8),
                 low = static_cast<char>(half.bits & 0xff);
      samples += is_big_endian ? std::string{high, low} : std::string{low, high};
    }
    const auto file = write("half.npy", npy(is_big_endian ? ">f2" : "<f2", "2, 2, 2", samples));
    const auto reader = open_volume(file);
    CHECK(reader->info().type == SampleType::f32);
    std::vector<double> expected;
    for (const Half& half : halves) expected.push_back(half.value);
    CHECK(read_all(*reader) == expected);
  }
  const std::string special = std::string("\0\x7c\0\xfc\x01\x7e\0\0", 8);
  const auto read = read_samples(write("special.npy", npy("<f2", "1, 2, 2", special)));
  CHECK(read[0] == INFINITY);
  CHECK(read[1] == -INFINITY);
  CHECK(std::isnan(read[2]));
  check_refused(write("short.npy", npy("<f2", "2, 2, 2", special + special.substr(1))),
                "4 bytes of it are missing");
}

TEST_CASE_FIXTURE(Folder, "samples behind a NumPy array are noted for any order of axes") {
  for (const std::string letters : {"zyx", "xyz", "zyxc"}) {
    INFO(letters);
    VolumeOptions options = with_axes(letters);
    if (letters == "zyxc") options.channel = 4;
    const auto file = write("a.npy", npy("<u2", shape_of(letters), array_with(letters) + "more"));
    const auto reader = open_volume(file, options);
    read_all(*reader);
    bool is_noted = false;
    for (const std::string& note : reader->notes())
      is_noted = is_noted || note.find("4 bytes after the samples") != std::string::npos;
    CHECK(is_noted);
  }
}

}  // namespace
