// MRC and CCP4 maps, field by field. container_table_test reads the files of mrcfile.
#include "volume_files.hpp"

namespace {

using namespace volume_files;

// A map of 5 columns, 3 rows and 4 sections of bytes in a cell of 10 x 6 x 8 angstrom.
class Map {
 public:
  explicit Map(bool is_big_endian = false) : is_big_endian_(is_big_endian) {
    numbers(0, {5, 3, 4, 0});
    numbers(28, {5, 3, 4});
    numbers(64, {1, 2, 3});
    reals(40, {10, 6, 8, 90, 90, 90});
    numbers(88, {1});
    header_.replace(208, 4, "MAP ");
    header_.replace(212, 2, is_big_endian ? "\x11\x11" : "\x44\x44");
  }
  Map& numbers(std::size_t offset, const std::vector<std::int32_t>& values) {
    for (const std::int32_t value : values) put(offset, value);
    return *this;
  }
  Map& reals(std::size_t offset, const std::vector<float>& values) {
    for (const float value : values) put(offset, value);
    return *this;
  }
  Map& mode(std::int32_t mode) { return numbers(12, {mode}); }
  Map& text(std::size_t offset, const std::string& text) {
    header_.replace(offset, text.size(), text);
    return *this;
  }
  std::string file(const std::string& samples) const { return header_ + samples; }

 private:
  template <class Number>
  void put(std::size_t& offset, Number value) {
    header_.replace(offset, sizeof value, bytes_of(value, is_big_endian_));
    offset += sizeof value;
  }

  bool is_big_endian_;
  std::string header_ = std::string(1024, '\0');
};

const std::string i8 = stored(SampleType::i8);

TEST_CASE_FIXTURE(
    Folder, "MRC maps, also of half floats, are read under any name; complex modes are refused") {
  check_volume(write("no-name", Map(true).file(i8)), SampleType::i8, "MRC");
  const std::string halves = std::string("\0\x3c", 2) + std::string(118, '\0');
  const auto reader = open_volume(write("a.mrc", Map().mode(12).file(halves)));
  CHECK(reader->info().type == SampleType::f32);
  CHECK(read_all(*reader)[0] == 1);
  check_refused(write("a.mrc", Map().mode(4).file(i8)), "mode 4 are not supported");
  check_refused(write("a.mrc", Map().mode(101).file(i8)), "newstack -mode 2");
}

TEST_CASE_FIXTURE(
    Folder,
    "MRC files without a machine stamp have the byte order that makes header numbers small") {
  for (const bool is_big_endian : {false, true})
    for (const std::int32_t mode : {0, 1}) {
      const SampleType type = mode == 0 ? SampleType::i8 : SampleType::i16;
      const Map map = Map(is_big_endian).mode(mode).text(208, std::string(8, '\0'));
      check_volume(write("a.mrc", map.file(stored(type, is_big_endian))), type, "MRC");
    }
}

TEST_CASE_FIXTURE(
    Folder, "bytes of IMOD's MRC files without the sign flag are read as unsigned, with a note") {
  const auto file = write("a.mrc", Map().numbers(152, {1146047817, 0}).file(u8));
  check_volume(file, "MRC");
  CHECK(noted(read_info(file), "bytes are read as u8, as IMOD wrote them"));
  check_volume(write("b.mrc", Map().numbers(152, {1146047817, 1}).file(i8)), SampleType::i8, "MRC");
}

TEST_CASE_FIXTURE(Folder, "the MRC cell gives the spacing, with angstroms written as millimetres") {
  const VolumeInfo info = read_info(write("a.mrc", Map().file(i8)));
  CHECK(info.spacing_mm == Spacing{2, 2, 2});
  CHECK(noted(info, "1 angstrom is written as 1 mm"));
  // A part of a cell.
  const VolumeInfo part = read_info(write("a.mrc", Map().numbers(28, {20, 3, 4}).file(i8)));
  CHECK(part.spacing_mm == Spacing{0.5, 2, 2});
  const VolumeInfo none = read_info(write("a.mrc", Map().reals(40, {0, 0, 0}).file(i8)));
  CHECK(noted(none, "no spacing given, 1 mm assumed"));
}

TEST_CASE_FIXTURE(Folder,
                  "the MRC origin is that of the header, or the first column, row and section") {
  const VolumeInfo with_origin =
      read_info(write("a.mrc", Map().reals(196, {7, 8, 9}).numbers(16, {1, 1, 1}).file(i8)));
  check_origin(with_origin, {7, 8, 9});
  const VolumeInfo steps = read_info(write("a.mrc", Map().numbers(16, {-3, 4, 5}).file(i8)));
  check_origin(steps, {-6, 8, 10});
}

TEST_CASE_FIXTURE(Folder, "columns, rows and sections of MRC may run along any axis") {
  // Columns along z, rows along x, sections along y.
  const Map map = Map().numbers(64, {3, 1, 2}).numbers(28, {3, 4, 5}).numbers(16, {1, 2, 3});
  const auto reader = open_volume(write("a.map", map.file(i8)));
  CHECK(reader->info().dims == Dims{3, 4, 5});
  const auto samples = read_all(*reader);
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 3; ++x) {
        const auto at = static_cast<std::size_t>((z * 4 + y) * 3 + x);
        CHECK(samples[at] == sample_at((y * 3 + x) * 5 + z, SampleType::i8));
      }
  REQUIRE(reader->info().placement);
  const std::array<double, 3> spacing{10.0 / 3, 6.0 / 4, 8.0 / 5};
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(std::fabs(reader->info().spacing_mm[axis] - spacing[axis]) < 1e-9);
  // The first section is the third along y.
  CHECK(std::fabs(reader->info().placement->origin_mm[0] - 2 * spacing[0]) < 1e-9);
  CHECK(std::fabs(reader->info().placement->origin_mm[1] - 3 * spacing[1]) < 1e-9);
  CHECK(std::fabs(reader->info().placement->origin_mm[2] - 1 * spacing[2]) < 1e-9);
  check_refused(write("a.map", Map().numbers(64, {1, 1, 3}).file(i8)),
                "MAPC, MAPR and MAPS are 1, 1 and 3");
  const VolumeInfo untold = read_info(write("a.map", Map().numbers(64, {0, 0, 0}).file(i8)));
  CHECK(noted(untold, "columns, rows and sections are read as x, y and z"));
}

TEST_CASE_FIXTURE(Folder, "an oblique crystal cell in MRC gives oblique axes") {
  const VolumeInfo info = read_info(write("a.map", Map().reals(52, {90, 90, 120}).file(i8)));
  REQUIRE(info.placement);
  const auto& axes = info.placement->axes_mm;
  CHECK(axes[0] == std::array<double, 3>{2, 0, 0});
  CHECK(std::fabs(axes[1][0] + 1) < 1e-9);
  CHECK(std::fabs(axes[1][1] - std::sqrt(3)) < 1e-9);
  CHECK(std::fabs(axes[2][2] - 2) < 1e-9);
}

TEST_CASE_FIXTURE(Folder,
                  "an extended MRC header is skipped, and one volume of an MRC stack is chosen") {
  check_volume(write("a.mrc", Map().numbers(92, {80}).file(std::string(80, 'x') + i8)),
               SampleType::i8, "MRC");
  check_refused(write("a.mrc", Map().numbers(92, {-1}).file(i8)), "-1 bytes");
  const Map stack = Map().numbers(8, {8}).numbers(88, {401});
  const auto file = write("a.mrc", stack.file(std::string(60, '\0') + i8));
  check_refused(file, "holds 2 volumes");
  check_volume(file, SampleType::i8, "MRC", of_frame(1));
  check_refused(write("a.mrc", Map().numbers(88, {401}).numbers(36, {3}).file(i8)),
                "a stack of volumes has 4 sections, but a volume 3");
}

}  // namespace
