// Volumes of labels with integer values.
#include "volumes/filters/filters.hpp"

#include "command.hpp"

namespace {

using namespace volume_files;
using discmc::command::BlockValue;

struct Read {
  VolumeInfo info;
  std::vector<double> labels;
  std::vector<std::string> notes;
};

Read read_labels(const std::string& bytes, const VolumeOptions& options) {
  const Folder folder;
  VolumeOptions of_labels = options;
  of_labels.holds_labels = true;
  of_labels.spacing_mm = {1, 1, 1};
  const auto volume = open_volume(folder.write("v.raw", bytes), of_labels);
  std::vector<double> labels = read_all(*volume);
  return {volume->info(), std::move(labels), volume->notes()};
}

VolumeOptions floats(std::uint32_t width, std::uint32_t depth = 1) {
  return {RawLayout{{width, 1, depth}, SampleType::f32}};
}

}  // namespace

TEST_CASE("values within 0.01 of an integer are rounded to labels and counted") {
  const float nan = std::nanf("");
  const Read read = read_labels(
      bytes_of(std::vector<float>{0, 0.99F, 1, 1.01F, 1.01F, -2.009F, nan, nan, 3}), floats(9));
  CHECK(read.info.type == SampleType::i64);
  CHECK(read.labels == std::vector<double>{0, 1, 1, 1, 1, -2, 0, 0, 3});
  CHECK(read.notes ==
        std::vector<std::string>{
            "4 values are rounded to whole numbers, as labels are; the farthest is 0.99",
            "2 samples are not a number (NaN) and count as off"});
}

TEST_CASE_FIXTURE(
    Folder,
    "labels scaled by a slope tolerate rounding errors, and larger deviations are refused") {
  const auto nifti = [](float intercept, const std::vector<std::int16_t>& samples) {
    return Nifti().dims({3, 4, 1, 1}).type(4).scale(0.1F, intercept).file(bytes_of(samples));
  };
  const auto file = write("v.nii", nifti(0.7F, {0, 1, 2, 3}));
  const VolumeOptions options = with(&VolumeOptions::holds_labels, true);
  const auto volume = open_volume(file, options);
  CHECK_THROWS_WITH_AS(read_all(*volume), doctest::Contains("the value 0.7 in slice 0 is no label"),
                       VolumeError);
  const auto exact = write("v.nii", nifti(0, {0, 30, 60, 70}));
  const auto labels = open_volume(exact, options);
  CHECK(read_all(*labels) == std::vector<double>{0, 3, 6, 7});
  for (const std::string& note : labels->notes()) CHECK_FALSE(contains(note, "rounded"));
}

TEST_CASE("values that are no integers are refused as labels with their slice") {
  const auto refused = [](const std::vector<float>& samples, const std::string& part) {
    const auto depth = static_cast<std::uint32_t>(samples.size());
    CHECK_THROWS_WITH_AS(read_labels(bytes_of(samples), floats(1, depth)),
                         doctest::Contains(part.c_str()), VolumeError);
  };
  refused({1, 2, 0.5F}, "the value 0.5 in slice 2 is no label");
  refused({1.02F}, "give --iso or --range");
  refused({1e20F}, "below 2^53");
  refused({0x1p53F}, "below 2^53");
  refused({std::numeric_limits<float>::infinity()}, "the value inf");
}

TEST_CASE("integer samples are kept as labels unchanged") {
  for (const auto& [called, type] : discmc::command::sample_types) {
    if (discmc::meshing::is_floating(type)) continue;
    const Read read = read_labels(stored(type), {RawLayout{{5, 3, 4}, type}});
    CHECK(read.info.type == type);
    CHECK(read.labels == samples_as(type));
  }
}

TEST_CASE("labels are rounded before --shrink chooses the most frequent label of a block") {
  VolumeOptions options = floats(4);
  options.shrink = 4;
  options.block_value = BlockValue::most_frequent;
  CHECK(read_labels(bytes_of(std::vector<float>{2, 2, 0.999F, 1.001F}), options).labels ==
        std::vector<double>{2});
  CHECK(read_labels(bytes_of(std::vector<float>{2, 1, 0.999F, 1.001F}), options).labels ==
        std::vector<double>{1});
}
