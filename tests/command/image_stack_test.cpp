// Stacks of pictures that write_pictures.py wrote by other programs.
#include "command.hpp"

namespace {

using namespace volume_files;
using command_tests::Workshop;

constexpr int width = 8;
constexpr int height = 6;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes/pictures";

// The values of the first slices of write_pictures.py.
template <class Change>
std::vector<double> values(int depth, Change change) {
  std::vector<double> values = patterned(0, depth);
  for (double& value : values) value = change(value);
  return values;
}

double in_u8(double value) {
  return std::fmod(value + 251 * 8, 251);
}
double in_u16(double value) {
  return value + 2000;
}

TEST_CASE("a folder of PNG files is a volume with slices in the natural order of names") {
  for (const std::string name : {"stack", "stack/slice*.png", "stack/slice[0-9]*"}) {
    INFO(name);
    const auto reader = open_volume(files / name);
    CHECK(reader->info().dims == Dims{width, height, 12});
    CHECK(reader->info().type == SampleType::u16);
    CHECK(reader->info().format == "PNG");
    CHECK(noted(reader->info(), "no spacing given"));
    CHECK(read_all(*reader) == values(12, in_u16));
  }
  CHECK(noted(read_info(files / "stack/slice1.png"),
              "this is one slice; for a whole stack, give its folder, or a pattern"));
  const VolumeInfo some = read_info(files / "stack/slice?.png", {{}, Spacing{0.5, 0.5, 2}});
  CHECK(some.dims[2] == 10);
  CHECK(some.spacing_mm == Spacing{0.5, 0.5, 2});
}

// container_table_test reads every sample type.
TEST_CASE("TIFF pages are read as slices in every layout and byte order") {
  for (const std::string name : {"u16", "big-endian", "tiles", "deflate", "imagej"}) {
    INFO(name);
    const auto reader = open_volume(files / (name + ".tif"));
    CHECK(reader->info().dims == Dims{width, height, 5});
    CHECK(reader->info().type == SampleType::u16);
    CHECK(reader->info().format == "TIFF");
    CHECK(read_all(*reader) == values(5, in_u16));
  }
}

TEST_CASE("pictures of eight bits or fewer keep their values") {
  CHECK(read_samples(files / "u8.png") == values(1, in_u8));
  CHECK(read_samples(files / "bits.png") ==
        values(1, [](double value) { return std::fmod(in_u8(value), 2); }));
  const auto greys = open_volume(files / "palette.png");  // a palette of greys
  CHECK(read_all(*greys) == values(1, in_u8));
  CHECK(!noted(greys->info(), "palette"));
}

TEST_CASE("the --channel option advised for a colour picture selects one of its channels") {
  check_refused(files / "rgb.png",
                "the file holds 3 channels ('red', 'green', 'blue'), and one is read at a time; "
                "choose one with --channel N, the first is 0");
  check_refused(files / "alpha.png", "2 channels ('grey', 'alpha')");
  CHECK(read_samples(files / "alpha.png", of_channel(0)) == values(1, in_u8));
  for (const std::string name : {"rgb.png", "rgb.tif"})
    for (const std::uint32_t channel : {0U, 1U, 2U})
      CHECK(read_samples(files / name, of_channel(channel)) == values(1, in_u8));
  const std::vector<double> all = values(3, in_u8);
  for (const std::string name : {"colours.png", "colours.bmp"})
    for (const std::uint32_t channel : {0U, 1U, 2U}) {
      INFO(name, " ", channel);
      const auto first = all.begin() + channel * width * height;
      CHECK(read_samples(files / name, of_channel(channel)) ==
            std::vector<double>(first, first + width * height));
    }
}

TEST_CASE_FIXTURE(Folder, "grey JPEG is read as slices, and colour JPEG by --channel") {
  const auto near = [](const std::vector<double>& read, int slice) {
    const std::vector<double> all = values(slice + 1, in_u8);
    double most = 0;
    for (std::size_t i = 0; i < read.size(); ++i)
      most = std::max(most,
                      std::fabs(read[i] - all[static_cast<std::size_t>(slice) * read.size() + i]));
    return most;
  };
  const auto grey = open_volume(files / "u8.jpg");
  CHECK(grey->info().format == "JPEG");
  CHECK(near(read_all(*grey), 0) < 4);
  CHECK(near(read_samples(files / "colours.jpg", of_channel(2)), 2) < 16);
  check_refused(files / "colours.jpg", "3 channels");
  // Otherwise the library would fill a truncated picture with grey.
  const std::string bytes = contents(files / "u8.jpg");
  for (const std::size_t cut : {2U, 10U, 60U})
    check_refused(write("v.jpg", bytes.substr(0, bytes.size() - cut)),
                  "the JPEG file is damaged (Premature end of JPEG file)");
}

TEST_CASE_FIXTURE(Folder, "the EXIF orientation of JPEG turns the picture, or is refused") {
  const std::string bytes = contents(files / "u8.jpg");
  const auto turned = [&](char orientation, std::size_t cut) {
    std::string exif("Exif\0\0MM\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1\0", 25);
    exif += orientation + std::string("\0\0\0\0\0\0", 6);
    exif.resize(exif.size() - cut);
    const std::string size{'\0', static_cast<char>(exif.size() + 2)};
    return write("v.jpg", bytes.substr(0, 2) + "\xff\xe1" + size + exif + bytes.substr(2));
  };
  for (const bool is_lowest : {false, true}) {
    const auto info = read_info(turned(is_lowest ? 3 : 2, 0));
    CHECK(noted(info, "the first column is the right one"));
    CHECK(noted(info, "the first row is the lowest") == is_lowest);
  }
  CHECK_FALSE(noted(read_info(turned(4, 0)), "the first column"));
  check_refused(turned(6, 0), "its EXIF orientation exchanges rows and columns", "-auto-orient");
  for (std::size_t cut = 7; cut < 30; ++cut) CHECK(!noted(read_info(turned(6, cut)), "row"));
}

std::string with_chunk(const std::string& png, const std::string& chunk) {
  const auto big = [](std::uint64_t number) {
    return bytes_of(static_cast<std::uint32_t>(number), true);
  };
  constexpr std::size_t head = 8 + 25;
  const auto sum = crc32(0, reinterpret_cast<const unsigned char*>(chunk.data()),
                         static_cast<unsigned>(chunk.size()));
  return png.substr(0, head) + big(chunk.size() - 4) + chunk + big(sum) + png.substr(head);
}

TEST_CASE_FIXTURE(Folder, "the EXIF orientation of PNG turns the picture, or is refused") {
  const std::string png = contents(files / "u8.png");
  const auto turned = [&](char orientation) {
    const std::string exif("eXIfMM\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1\0", 23);
    return write("v.png", with_chunk(png, exif + orientation + std::string(6, '\0')));
  };
  CHECK(noted(read_info(turned(4)), "the first row is the lowest"));
  check_refused(turned(6), "its EXIF orientation exchanges rows and columns");
}

TEST_CASE_FIXTURE(Folder, "a picture resolution without a unit is noted if pixels are not square") {
  const std::string png = contents(files / "u8.png");
  const auto notes = [&](char y) {
    const std::string pixels("pHYs\0\0\0\2\0\0\0", 11);
    const auto file = write("v.png", with_chunk(png, pixels + y + '\0'));
    return read_info(file);
  };
  CHECK(noted(notes(1), "which has no unit, is not used; to use it, give --spacing 1,2,Z"));
  CHECK(!noted(notes(2), "resolution"));
}

TEST_CASE_FIXTURE(Folder, "a picture is recognized by its first bytes under any name") {
  for (const std::string name : {"u8.png", "u8.tif", "u8.jpg", "u8.bmp"}) {
    const std::string bytes = contents(files / name);
    if (name != "u8.bmp") CHECK(read_info(write("picture", bytes)).dims[0] == width);
    CHECK(read_info(write("v.png", bytes)).dims[0] == width);
  }
  check_refused(write("v.png", "no picture"), "not a PNG, TIFF, JPEG or BMP file");
  for (const std::string name : {"slice1", "slice2"}) write(name, contents(files / "u8.png"));
  CHECK(read_info(path() / "slice*").dims[2] == 2);
}

TEST_CASE_FIXTURE(Folder, "a picture of another size or type in a stack is refused by its name") {
  write("a1.png", contents(files / "stack/slice0.png"));
  write("a2.png", contents(files / "u8.png"));
  check_refused(path(),
                "a2.png: page 0 has 8 x 6 samples of u8, and a1.png has 8 x 6 samples of u16");
  check_refused(path() / "b*.png", "no file matches the pattern");
}

std::string slice(int z) {
  return contents(files / "stack" / ("slice" + std::to_string(z) + ".png"));
}

class NumberedStack : public Folder {
 public:
  explicit NumberedStack(const std::vector<int>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      write("a2_" + std::to_string(numbers[i]) + ".png", slice(static_cast<int>(i)));
  }
};

TEST_CASE("a missing number among picture names is refused with the place of the gap") {
  const NumberedStack stack({8, 9, 10, 12, 13, 14, 17});
  check_refused(stack.path(),
                "3 slices are missing, the largest of 2 gaps between a2_14.png and a2_17.png; ",
                "--allow-gaps");
}

TEST_CASE("with gaps allowed, the nearest picture replaces a missing slice, with a note") {
  const NumberedStack stack({8, 9, 11, 12, 13, 16});
  const auto reader = open_volume(stack.path(), gaps_allowed);
  CHECK(noted(reader->info(), "3 slices are missing, the largest of 2 gaps between a2_13.png and"));
  CHECK(reader->info().dims[2] == 9);
  const std::vector<double> all = read_all(*reader);
  const std::vector<double> there = values(6, in_u16);
  constexpr std::ptrdiff_t of_slice = width * height;
  std::vector<double> expected;
  for (const std::ptrdiff_t z : {0, 1, 1, 2, 3, 4, 4, 5, 5})
    expected.insert(expected.end(), there.begin() + z * of_slice,
                    there.begin() + (z + 1) * of_slice);
  CHECK(all == expected);
}

TEST_CASE(
    "picture names with even steps, two numbers or constant numbers are not reported as having "
    "gaps") {
  for (const std::vector<int>& numbers :
       {std::vector<int>{0, 10, 20, 30}, {3, 9}, {17, 23, 31, 40, 45}}) {
    const NumberedStack stack(numbers);
    const VolumeInfo info = read_info(stack.path(), {{}, Spacing{1, 1, 1}});
    CHECK(info.dims[2] == numbers.size());
    CHECK(info.notes.empty());
  }
  const Folder two_numbers;
  for (int z = 0; z < 4; ++z)
    two_numbers.write("a" + std::to_string(z / 3) + "b" + std::to_string(z * z) + ".png", slice(z));
  CHECK(read_info(two_numbers.path()).dims[2] == 4);
}

TEST_CASE("picture stacks with more missing than present slices are refused with the largest gap") {
  const NumberedStack stack({1, 2, 3, 5, 900});
  for (const VolumeOptions& options : {VolumeOptions{}, gaps_allowed})
    check_refused(stack.path(), options,
                  "895 slices are missing, the largest of 2 gaps between a2_5.png and a2_900.png, "
                  "which is too many to fill");
}

TEST_CASE("a folder with several kinds of pictures is refused with the remedy") {
  const NumberedStack stack({1, 2});
  stack.write("a.tif", contents(files / "u16.tif"));
  check_refused(stack.path(),
                "2 PNG and 1 TIFF files are not one volume; give a pattern "
                "of one kind, such as '" +
                    (stack.path() / "*.png").string());
  CHECK(read_info(stack.path() / "*.png").dims[2] == 2);
  stack.write("notes.txt", "of a colleague");
  check_refused(stack.path() / "*[gt]",
                "and other files, such as 'notes.txt'; give a "
                "pattern of one kind, such as '" +
                    (stack.path() / "*.png").string());
}

TEST_CASE_FIXTURE(Folder, "truncated pictures are refused") {
  for (const std::string name : {"stack/slice0.png", "u16.tif", "tiles.tif", "deflate.tif",
                                 "u8.jpg", "u8.bmp", "deep-tiles4.tif"}) {
    const std::string bytes = contents(files / name);
    const std::string cut = "cut" + fs::path(name).extension().string();
    // A truncated table of pages looks like a shorter one without the last page.
    for (std::size_t size = 0; size < 100; size += 7) {
      INFO(name, " cut at ", size);
      refusal(write(cut, bytes.substr(0, size)));
    }
  }
}

TEST_CASE_FIXTURE(Workshop, "one command converts a stack of pictures to a mesh") {
  done("extract '" + (files / "stack/*.png").string() +
       "' --iso 2000 --spacing 0.5,0.5,2 -o v.stl");
  CHECK(!mesh_in("v.stl").vertices_mm.empty());
}

}  // namespace
