// Folders with several stacks of pictures: they are refused, with a pattern that selects one stack.
#include "command.hpp"

namespace {

using namespace volume_files;

class Pictures : public Folder {
 public:
  explicit Pictures(const std::vector<std::string>& names) {
    const std::string picture =
        contents(fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes/pictures/u8.png");
    for (const std::string& name : names) write(name, picture);
  }
};

std::uint32_t slices(const fs::path& stack) {
  return read_info(stack).dims[2];
}

std::string advised(const std::string& text) {
  const std::size_t end = text.rfind('\'');
  const std::size_t begin = text.rfind('\'', end - 1);
  REQUIRE(begin != std::string::npos);
  return text.substr(begin + 1, end - begin - 1);
}

// Checks that a folder is refused, and that the advised pattern selects this number of slices.
void check_advice(const std::vector<std::string>& names, const std::string& what,
                  const std::string& pattern, std::uint32_t expected) {
  const Pictures pictures(names);
  const std::string text = refusal(pictures.path());
  check_refusal(text, what);
  CHECK(advised(text) == (pictures.path() / pattern).string());
  CHECK(slices(advised(text)) == expected);
}

TEST_CASE("picture names with two counting numbers form one stack per value of one number") {
  const std::string what = "the names count in several numbers";
  check_advice({"img_z000_c0.png", "img_z000_c1.png", "img_z001_c0.png", "img_z001_c1.png",
                "img_z002_c0.png", "img_z002_c1.png"},
               what, "*_c0.png", 3);
  check_advice({"t1_z8.png", "t1_z9.png", "t1_z10.png", "t2_z8.png", "t2_z9.png", "t2_z10.png"},
               what, "t1_z*.png", 3);
  check_advice({"r02c03ch1_0.png", "r02c03ch2_0.png", "r02c03ch1_1.png", "r02c03ch2_1.png",
                "r02c04ch1_0.png", "r02c04ch2_0.png", "r02c04ch1_1.png", "r02c04ch2_1.png",
                "r02c03ch1_2.png", "r02c03ch2_2.png", "r02c04ch1_2.png", "r02c04ch2_2.png"},
               what, "r02c03ch1_*.png", 3);
  // Numbered in sequence, but of two alternating channels.
  check_advice({"0001_c0.png", "0002_c1.png", "0003_c0.png", "0004_c1.png"}, what, "*_c0.png", 2);
}

TEST_CASE("picture names that differ in more than numbers are refused as several stacks") {
  check_advice({"bone1.png", "bone2.png", "bone3.png", "dye1.png", "dye2.png"},
               "names of 2 kinds, such as 'bone1.png' (3) and 'dye1.png' (2)", "bone*.png", 3);
  check_advice({"s1.png", "s2.png", "s3.png", "overview.png"},
               "names of 2 kinds, such as 's1.png' (3) and 'overview.png' (1)", "s*.png", 3);
  // The prefix of one number is also a prefix of the other.
  check_advice({"s1.png", "s2.png", "s3.png", "s1_mask.png", "s2_mask.png"}, "names of 2 kinds",
               "s*[0-9].png", 3);
  check_advice({"s1.png", "s12.png", "s3.png", "s1m.png", "s12m.png"}, "names of 2 kinds",
               "s*[0-9].png", 3);
}

TEST_CASE("a pattern that selects two stacks of pictures is refused like the folder") {
  const Pictures pictures({"a_c0_1.png", "a_c0_2.png", "a_c1_1.png", "a_c1_2.png", "b_c0_1.png"});
  const std::string text = refusal(pictures.path() / "a_*.png");
  check_refusal(text, "count in several numbers");
  CHECK(slices(advised(text)) == 2);
}

TEST_CASE("the pattern advised for a stack is valid even if picture names contain wildcards") {
  const Pictures pictures({"[a]*1.png", "[a]*2.png", "b1.png"});
  const std::string text = refusal(pictures.path());
  CHECK(slices(advised(text)) == 2);
}

TEST_CASE("if no pattern selects a stack, the refusal advises a separate folder for the stack") {
  check_refused(Pictures({"a1b.png", "a2b.png", "a1b1b.png"}).path(),
                "copy the pictures of one stack into a folder of their own");
}

TEST_CASE("picture names with a second number that varies with the first form one stack") {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"img_001_20210101.png", "img_002_20210102.png",
                                 "img_003_20210105.png"},
        {"part1_0001.png", "part1_0002.png", "part2_0003.png", "part2_0004.png"},
        {"a_001_10-59-58.png", "a_002_10-59-59.png", "a_003_11-00-00.png"},
        {"a001.PNG", "a002.png", "a003.PNG", "a004.png"},
        {"left.png", "middle.png", "right.png"}}) {
    INFO(names[0]);
    const Pictures pictures(names);
    CHECK(slices(pictures.path()) == names.size());
  }
}

// Gives successive slices these names, and returns the order in which they are read.
std::vector<int> read_order(const std::vector<std::string>& names,
                            const VolumeOptions& options = {}) {
  const Folder folder;
  const fs::path stack = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes/pictures/stack";
  for (std::size_t i = 0; i < names.size(); ++i)
    folder.write(names[i], contents(stack / ("slice" + std::to_string(i) + ".png")));
  const auto reader = open_volume(folder.path(), options);
  CHECK(noted(reader->info(), "the decimal or signed numbers in the names give the order"));
  CHECK(noted(reader->info(), "no spacing given, 1 mm assumed"));
  const std::vector<double> samples = read_all(*reader);
  std::vector<int> order;
  for (std::size_t begin = 0; begin < samples.size();
       begin += samples.size() / reader->info().dims[2])
    for (int slice = 0; slice < static_cast<int>(names.size()); ++slice)
      if (samples[begin] == patterned(slice, 1)[0] + 2000) order.push_back(slice);
  return order;
}

TEST_CASE("decimals and signs in picture names determine the order of slices") {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"s_0.5.png", "s_1.0.png", "s_1.5.png", "s_2.0.png"},
        {"z=8.50.png", "z=9.25.png", "z=10.00.png", "z=10.75.png"},
        {"s_0.25.png", "s_0.5.png", "s_0.75.png", "s_1.png"},
        {"s_0.33.png", "s_0.67.png", "s_1.00.png", "s_1.33.png"},
        {"s_9,5mm.png", "s_10,0mm.png", "s_10,5mm.png", "s_11,0mm.png"},
        {"z-1.5.png", "z-0.5.png", "z0.5.png", "z1.5.png"},
        {"z=-12.png", "z=-11.png", "z=-10.png", "z=-9.png"},
        {"z_-2.png", "z_-1.png", "z_+0.png", "z_+1.png"}}) {
    INFO(names[0]);
    CHECK(read_order(names) == std::vector<int>{0, 1, 2, 3});
  }
}

TEST_CASE("a decimal missing among picture names is a missing slice") {
  const std::vector<std::string> names = {"s_0.0.png", "s_0.5.png", "s_1.0.png", "s_2.0.png"};
  CHECK(read_order(names, gaps_allowed) == std::vector<int>{0, 1, 2, 2, 3});
  check_refused(Pictures({"s_0.0.png", "s_0.5.png", "s_1.0.png", "s_2.0.png"}).path(),
                "between s_1.0.png and s_2.0.png");
}

TEST_CASE(
    "unevenly spaced decimals in picture names are refused, and the message advises whole "
    "numbers") {
  check_refused(Pictures({"s_0.5.png", "s_1.1.png", "s_1.9.png", "s_3.1.png"}).path(),
                "if uneven decimals count them, rename them by whole numbers");
}

TEST_CASE(
    "numbers around a decimal point count separately if they form no evenly spaced decimals") {
  check_advice({"t1.7.png", "t1.8.png", "t2.7.png", "t2.8.png"},
               "the names count in several numbers", "t1.*.png", 2);
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"s.1.9.png", "s.1.10.png", "s.1.11.png"},
        {"2021.03.01.png", "2021.03.02.png", "2021.03.03.png"},
        {"2021-03-01.png", "2021-03-02.png", "2021-03-03.png"}}) {
    const Pictures pictures(names);
    const VolumeInfo info = read_info(pictures.path());
    CHECK(info.dims[2] == names.size());
    CHECK(!noted(info, "decimal"));
  }
}

TEST_CASE("picture names whose numbers define no order are refused") {
  check_refused(Pictures({"id8_s1.png", "id3_s2.png", "id5_s3.png"}).path(),
                "the numbers in the names give different orders");
  check_refused(Pictures({"s1.png", "s01.png", "s2.png"}).path(),
                "two pictures have the same number");
}

TEST_CASE("hidden files and system files are not read as slices") {
  const Pictures pictures({"s1.png", "s2.png", "s3.png"});
  for (const std::string name : {"._s2.png", ".DS_Store", "Thumbs.db", "desktop.ini"})
    pictures.write(name, "of the system");
  CHECK(slices(pictures.path()) == 3);
  CHECK(slices(pictures.path() / "*") == 3);
}

}  // namespace
