// Parts of volumes, and volumes with fewer voxels: their samples and positions.
#include <discmc/front/downsampler.hpp>
#include <discmc/front/row_cropper.hpp>

#include <string_view>

#include "volume_files.hpp"

namespace {

using namespace volume_files;
using discmc::command::BlockValue;
using discmc::command::Crop;
using discmc::meshing::along_coordinates;
using discmc::meshing::VolumePlacement;
using Place = std::array<double, 3>;

constexpr Dims dims = {5, 3, 4};
const Crop middle = {{{1, 3}, {1, {}}, {0, 2}}};

VolumeOptions options_of(SampleType type, const Dims& extents = dims) {
  return with(&VolumeOptions::layout, RawLayout{extents, type});
}

VolumeOptions with_crop(VolumeOptions options, const Crop& crop) {
  options.crop = crop;
  return options;
}

VolumeOptions with_shrink(VolumeOptions options, std::uint32_t extent,
                          BlockValue value = BlockValue::mean) {
  options.shrink = extent;
  options.block_value = value;
  return options;
}

// The position of the centre of a voxel, or of a point between voxels.
Place place(const VolumeInfo& info, const Place& voxel) {
  const VolumePlacement at = info.placement.value_or(along_coordinates(info.spacing_mm));
  Place result = at.origin_mm;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 3; ++i) result[i] += voxel[axis] * at.axes_mm[axis][i];
  return result;
}

// Checks that voxel v of the part has the position of `first` + `step` v of the whole.
void check_places(const VolumeInfo& part, const VolumeInfo& whole, const Place& first,
                  double step) {
  for (const Place& voxel : {Place{0, 0, 0}, Place{1, 0, 0}, Place{0, 1, 0}, Place{0, 0, 1}}) {
    Place before{};
    for (std::size_t axis = 0; axis < 3; ++axis) before[axis] = first[axis] + step * voxel[axis];
    const Place a = place(part, voxel), b = place(whole, before);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::fabs(a[i] - b[i]) < 1e-9);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    CHECK(part.spacing_mm[axis] == doctest::Approx(step * whole.spacing_mm[axis]));
}

// Volumes with all kinds of placement: none, mirrored, rotated in a patient.
const std::vector<std::string> placements = {
    "", "spacings: 0.5 2 3\n", "space dimension: 3\nspace directions: (0.5,0,0) (0,-2,0) (0,0,3)\n",
    "space: LPS\nspace directions: (0,2,0) (-3,0,0) (0,0.6,0.8)\nspace origin: (10,-20,30.5)\n"};

// The mean of one block of up to 2 x 2 x 2 samples.
template <class Sample>
Sample shrunk_block(const std::vector<Sample>& samples, SampleType type,
                    BlockValue value = BlockValue::mean) {
  const Folder folder;
  const auto count = static_cast<std::uint32_t>(samples.size());
  const auto file = folder.write("v.raw", bytes_of(samples));
  const Dims block = {2, count / 2 > 1 ? 2U : 1U, std::max(count / 4, 1U)};
  const auto reader = open_volume(file, with_shrink(options_of(type, block), 2, value));
  CHECK(reader->info().dims == Dims{1, 1, 1});
  Sample result{};
  reader->read_slice(&result);
  return result;
}

}  // namespace

TEST_CASE_FIXTURE(Folder, "--crop keeps ranges including both ends, for samples of every type") {
  for (const auto& [called, type] : discmc::command::sample_types) {
    const std::string_view name = called;
    INFO(name);
    const auto file = write("v.raw", stored(type));
    const auto reader = open_volume(file, with_crop(options_of(type), middle));
    CHECK(reader->info().dims == Dims{3, 2, 3});
    CHECK(reader->info().whole_dims == dims);
    std::vector<double> expected;
    for (int z = 0; z <= 2; ++z)
      for (int y = 1; y <= 2; ++y)
        for (int x = 1; x <= 3; ++x) expected.push_back(sample_at((z * 3 + y) * 5 + x, type));
    CHECK(read_all(*reader) == expected);
    CHECK_THROWS_AS(reader->read_slice(std::vector<char>(48).data()), VolumeError);
  }
}

TEST_CASE_FIXTURE(Folder, "an omitted end of a --crop range is the end of the volume") {
  const auto file = write("v.raw", u8);
  const auto whole = read_samples(file, options_of(SampleType::u8));
  const auto all = open_volume(file, with_crop(options_of(SampleType::u8), Crop{}));
  CHECK(all->info().dims == dims);
  CHECK_FALSE(all->info().placement);
  CHECK(read_all(*all) == whole);
  const Crop last_two = {{{}, {}, {2, {}}}};
  const auto rest = read_samples(file, with_crop(options_of(SampleType::u8), last_two));
  CHECK(rest == std::vector<double>(whole.begin() + 30, whole.end()));
}

TEST_CASE_FIXTURE(Folder, "a --crop outside the volume is refused with the extents of the volume") {
  const auto file = write("v.raw", u8);
  const auto refused = [&](const Crop& crop) {
    return refusal(file, with_crop(options_of(SampleType::u8), crop));
  };
  check_refusal(refused({{{1, 5}, {}, {}}}), "1..5 along x, but the volume has 5 x 3 x 4; give");
  check_refusal(refused({{{}, {3, {}}, {}}}), "3.. along y, but the volume has 5 x 3 x 4; give");
  check_refusal(refused({{{}, {}, {0, 4294967295}}}), "0..4294967295 along z");
  check_refusal(refused({{{}, {}, {0, 4}}}), "a part of 0..3");
}

TEST_CASE_FIXTURE(Folder, "with --crop, slices behind the part are not read") {
  const std::string cut = nrrd(nrrd_u8) + "\n" + u8.substr(0, 46);
  const auto file = write("v.nrrd", cut);
  CHECK(read_samples(file, with_crop({}, {{{}, {}, {1, 2}}})).size() == 30);
  check_refused(file, with_crop({}, {{{}, {}, {1, 3}}}), "14 bytes of it are missing");
}

TEST_CASE_FIXTURE(Folder, "voxels keep their position in space with --crop and --shrink") {
  for (const std::string& lines : placements) {
    INFO(lines);
    const auto file = write("v.nrrd", nrrd(nrrd_u8 + lines) + "\n" + u8);
    const VolumeInfo whole = read_info(file);
    check_places(read_info(file, with_crop({}, middle)), whole, {1, 1, 0}, 1);
    check_places(read_info(file, with_crop({}, Crop{})), whole, {0, 0, 0}, 1);
    check_places(read_info(file, with_shrink({}, 2)), whole, {0.5, 0.5, 0.5}, 2);
    check_places(read_info(file, with_shrink({}, 3)), whole, {1, 1, 1}, 3);
    const VolumeInfo both = read_info(file, with_shrink(with_crop({}, middle), 3));
    check_places(both, whole, {2, 2, 1}, 3);
    CHECK(both.whole_dims == dims);
    CHECK((both.placement ? both.placement->space : Space::scanner) ==
          (whole.placement ? whole.placement->space : Space::scanner));
  }
}

TEST_CASE_FIXTURE(Folder, "--spacing applies to the voxels before --shrink") {
  VolumeOptions options = with_shrink(with_crop(options_of(SampleType::u8), middle), 2);
  options.spacing_mm = {0.5, 2, 3};
  const auto file = write("v.raw", u8);
  VolumeInfo whole;
  whole.spacing_mm = {0.5, 2, 3};
  check_places(read_info(file, options), whole, {1.5, 1.5, 0.5}, 2);
}

TEST_CASE_FIXTURE(Folder,
                  "--shrink gives the mean of each block, also of blocks that the border cuts") {
  std::minstd_rand random(1);
  for (const auto& [called, type] : discmc::command::sample_types)
    for (const std::uint32_t extent : {2U, 3U, 16U}) {
      const std::string_view name = called;
      INFO(name, " by ", extent);
      const Dims size = {7, 9, 5};
      std::vector<int> samples(7 * 9 * 5);
      for (int& sample : samples) sample = static_cast<int>(random() % 100);
      std::string bytes;
      discmc::meshing::with_sample_type(type, [&](auto typed) {
        bytes = bytes_of(std::vector<decltype(typed)>(samples.begin(), samples.end()));
      });
      const auto file = write("v.raw", bytes);
      const auto reader = open_volume(file, with_shrink(options_of(type, size), extent));
      Dims blocks{};
      for (std::size_t i = 0; i < 3; ++i) blocks[i] = (size[i] + extent - 1) / extent;
      REQUIRE(reader->info().dims == blocks);
      CHECK(reader->info().type == type);

      std::map<std::array<std::uint32_t, 3>, std::pair<int, int>>
          sums;  // numbered in the order z, y, x
      for (std::uint32_t i = 0; i < samples.size(); ++i) {
        const std::uint32_t x = i % 7, y = i / 7 % 9, z = i / 63;
        auto& [sum, count] = sums[{z / extent, y / extent, x / extent}];
        sum += samples[i];
        ++count;
      }
      std::vector<double> expected;
      for (const auto& [block, of] : sums) {
        const auto& [sum, count] = of;
        expected.push_back(discmc::meshing::is_floating(type)
                               ? static_cast<double>(sum) / count
                               : static_cast<double>((2 * sum + count) / (2 * count)));
      }
      const auto found = read_all(*reader);
      REQUIRE(found.size() == expected.size());
      for (std::size_t i = 0; i < found.size(); ++i)
        CHECK(found[i] == doctest::Approx(expected[i]).epsilon(1e-7));
    }
}

// The same volume as shrunk on a device.
TEST_CASE_FIXTURE(Folder,
                  "RowCropper and Downsampler give the same voxels as --crop and --shrink") {
  using namespace discmc;
  const auto file = write("v.raw", stored(SampleType::i16));
  const auto whole = read_samples(file, options_of(SampleType::i16));
  const std::vector<std::int16_t> samples(whole.begin(), whole.end());
  const Limits limits{dims[0], dims[1]};

  RowCropper cropper;
  REQUIRE(cropper.start(limits, {1, 3}, {1}, {0, 3}) == Status::ok);
  std::vector<double> part;
  for (auto row = samples.begin(); row != samples.end(); row += dims[0])
    if (cropper.next()) part.insert(part.end(), row + cropper.first(), row + cropper.first() + 3);
  CHECK(part == read_samples(file, with_crop(options_of(SampleType::i16), middle)));

  for (const std::uint32_t extent : {2U, 3U}) {
    std::vector<std::uint8_t> memory(Downsampler<std::int16_t>::bytes_for(limits, extent));
    Downsampler<std::int16_t> means;
    REQUIRE(means.start(limits, extent, {memory.data(), memory.size()}) == Status::ok);
    const std::uint32_t width = means.limits().width;
    std::vector<double> blocks;
    for (std::size_t at = 0; at < samples.size(); at += dims[0])
      if (const std::int16_t* row = means.push(&samples[at]))
        blocks.insert(blocks.end(), row, row + width);
    while (const std::int16_t* row = means.drain()) blocks.insert(blocks.end(), row, row + width);
    CHECK(blocks == read_samples(file, with_shrink(options_of(SampleType::i16), extent)));
  }
}

TEST_CASE("--shrink computes exact means of integers and rounds halves up") {
  constexpr auto most = std::numeric_limits<std::uint64_t>::max();
  constexpr auto least = std::numeric_limits<std::int64_t>::min();
  using U64 = std::vector<std::uint64_t>;
  using I64 = std::vector<std::int64_t>;
  CHECK(shrunk_block(U64(8, most), SampleType::u64) == most);
  CHECK(shrunk_block(U64{most, most - 1}, SampleType::u64) == most);
  CHECK(shrunk_block(U64{most, most, most, most - 3}, SampleType::u64) == most - 1);
  CHECK(shrunk_block(U64{0, most}, SampleType::u64) == std::uint64_t{1} << 63);
  CHECK(shrunk_block(U64{9007199254740993, 9007199254740993}, SampleType::u64) == 9007199254740993);
  CHECK(shrunk_block(I64(8, least), SampleType::i64) == least);
  CHECK(shrunk_block(I64{least, -(least + 1)}, SampleType::i64) == 0);
  CHECK(shrunk_block(I64{least, least, least, least + 5}, SampleType::i64) == least + 1);
  CHECK(shrunk_block(std::vector<std::int16_t>{-3, -4}, SampleType::i16) == -3);
  CHECK(shrunk_block(std::vector<std::int16_t>{3, 4}, SampleType::i16) == 4);
  CHECK(shrunk_block(std::vector<std::int16_t>{-3, -3, -3, -4}, SampleType::i16) == -3);
  CHECK(shrunk_block(std::vector<std::int8_t>{-128, -128, -128, 127}, SampleType::i8) == -64);
  CHECK(shrunk_block(std::vector<std::uint8_t>{255, 255, 255, 254}, SampleType::u8) == 255);
}

TEST_CASE("a shrunk block is NaN only if all samples of the block are NaN") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr double nan_f64 = std::numeric_limits<double>::quiet_NaN();
  using F32 = std::vector<float>;
  for (const BlockValue value : {BlockValue::mean, BlockValue::most_frequent}) {
    CHECK(std::isnan(shrunk_block(F32(8, nan), SampleType::f32, value)));
    CHECK(shrunk_block(F32{nan, 2, nan, nan}, SampleType::f32, value) == 2);
    CHECK(shrunk_block(std::vector<double>{nan_f64, 2, nan_f64, nan_f64}, SampleType::f64, value) ==
          2);
  }
  CHECK(shrunk_block(F32{1, 2, nan, 6}, SampleType::f32) == 3);
  CHECK(shrunk_block(F32{3e38F, 3e38F}, SampleType::f32) == 3e38F);
}

TEST_CASE(
    "a shrunk block of labels is the most frequent label, or the first of equally frequent "
    "labels") {
  using U16 = std::vector<std::uint16_t>;
  const auto label = [](const U16& labels) {
    return shrunk_block(labels, SampleType::u16, BlockValue::most_frequent);
  };
  CHECK(label({1, 7, 7, 7, 9, 1, 1, 7}) == 7);
  CHECK(label({9, 0, 9, 0, 9, 0, 9, 0}) == 9);
  CHECK(label({0, 9, 9, 0, 9, 0, 9, 0}) == 0);
  CHECK(label({3, 1, 2, 5, 4, 6, 5, 8}) == 5);
  CHECK(label({40000, 40000, 40000, 40000, 40000, 40000, 40000, 40000}) == 40000);
}

TEST_CASE_FIXTURE(Folder, "a shrunk block has a label of its own voxels, even at the border") {
  // Blocks of 2 x 2 x 2, each with its number as a label, and one voxel of another label.
  const Dims size = {5, 3, 3};
  std::vector<std::uint8_t> labels;
  for (std::uint32_t i = 0; i < 45; ++i) {
    const std::uint32_t x = i % 5, y = i / 5 % 3, z = i / 15;
    labels.push_back(static_cast<std::uint8_t>(x / 2 + 3 * (y / 2) + 6 * (z / 2)));
  }
  labels[0] = 200;
  const auto file = write("v.raw", bytes_of(labels));
  const auto reader = open_volume(
      file, with_shrink(options_of(SampleType::u8, size), 2, BlockValue::most_frequent));
  std::vector<double> expected;
  for (int block = 0; block < 12; ++block) expected.push_back(block);
  CHECK(read_all(*reader) == expected);
}

TEST_CASE_FIXTURE(Folder,
                  "--shrink is refused if the shrunk voxels are too large for a placement") {
  const auto file = write("v.nrrd", nrrd(nrrd_u8 + "spacings: 1 1 1e6\n") + "\n" + u8);
  check_refused(file, with_shrink({}, 2), "1e6 mm apart; give the distances");
  CHECK(read_info(file, with_crop({}, middle)).dims == Dims{3, 2, 3});
}
