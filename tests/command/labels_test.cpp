// The surfaces of all labels in one pass.
#include "extraction/labels.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "hand_made.hpp"
#include "oracle/region.hpp"
#include "sample_reader.hpp"

namespace {

using discmc::Border;
using discmc::command::extract_labels;
using discmc::command::LabelledSurfaces;
using discmc::command::LabelOptions;
using discmc::command::max_scattered_labels;
using discmc::command::SampleType;
using discmc::command::Selection;
using discmc::reference::Size;
using sample_reader::SampleReader;

constexpr Size size = {19, 7, 23};

// Blobs and single voxels of the labels -2 to 3, each of them away from some of the slices: for
// one, two, three or many.
std::vector<int> labels(std::uint32_t seed) {
  std::mt19937 random(seed);
  const std::uint32_t rows = size.width * size.height;
  std::vector<int> samples(std::size_t{rows} * size.depth);
  std::vector<std::vector<bool>> is_there(6, std::vector<bool>(size.depth));
  for (auto& slices : is_there)
    for (std::size_t z = 0; z < slices.size(); ++z)
      slices[z] = random() % 4 != 0 && (z < 9 || z > 9 + random() % 6);
  int label = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (random() % 4 == 0) label = static_cast<int>(random() % 6) - 2;
    if (is_there[static_cast<std::size_t>(label + 2)][i / rows]) samples[i] = label;
  }
  return samples;
}

discmc::command::Surface surface_of(int label, std::uint32_t seed, Border border,
                                    bool takes_majority, SampleType type) {
  SampleReader reader(size, labels(seed), {1, 2, 3}, type);
  discmc::command::SurfaceBuilder builder;
  discmc::command::ExtractionOptions options;
  options.selection = Selection(label, label);
  options.border = border;
  options.takes_majority = takes_majority;
  extract(reader, options, discmc::make_sink(builder));
  return builder.surface();
}

LabelledSurfaces extracted(const std::vector<float>& samples, Size extents) {
  SampleReader reader(extents, {}, {1, 1, 1}, SampleType::f32);
  struct Floats final : discmc::command::VolumeReader {
    const std::vector<float>& samples;
    discmc::command::VolumeInfo told;
    std::size_t next = 0;
    Floats(const std::vector<float>& given, discmc::command::VolumeInfo info)
        : samples(given), told(std::move(info)) {}
    const discmc::command::VolumeInfo& info() const override { return told; }
    void read_slice(void* slice) override {
      std::memcpy(slice, samples.data() + next, told.slice_bytes());
      next += told.slice_bytes() / sizeof(float);
    }
  } floats(samples, reader.info());
  return extract_labels(floats, {});
}

}  // namespace

TEST_CASE("the surface of every label is that of a scan for it alone") {
  for (const Border border : {Border::closed, Border::open})
    for (const bool takes_majority : {false, true})
      for (std::uint32_t seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        const SampleType type = seed % 2 == 0 ? SampleType::i16 : SampleType::f32;
        SampleReader reader(size, labels(seed), {1, 2, 3}, type);
        const auto all = extract_labels(reader, {border, takes_majority, {}}).all;
        REQUIRE(all.size() == 5);
        for (std::size_t i = 0; i < all.size(); ++i) {
          const int label = std::vector<int>{-2, -1, 1, 2, 3}[i];
          CHECK(all[i].label == label);
          CHECK(all[i].surface.spacing_mm == discmc::command::Point{1, 2, 3});
          const auto alone = surface_of(label, seed, border, takes_majority, type);
          CHECK(discmc::reference::describe_difference(hand_made::regions_of(all[i].surface),
                                                       hand_made::regions_of(alone)) == "");
        }
      }
}

TEST_CASE("voxels are counted, and what is not a number is of no label") {
  const float nan = std::nanf("");
  const LabelledSurfaces labels = extracted({nan, 7, 7, -0.0F, 7, nan, nan, -4}, {2, 2, 2});
  CHECK(labels.not_numbers == 3);
  REQUIRE(labels.all.size() == 2);
  CHECK(labels.all[0].label == -4);
  CHECK(labels.all[0].voxels == 1);
  CHECK(labels.all[1].label == 7);
  CHECK(labels.all[1].voxels == 3);
  CHECK(extracted({0, 0}, {2, 1, 1}).all.empty());
}

TEST_CASE("progress is told after every slice") {
  SampleReader reader(size, labels(0));
  std::vector<std::uint32_t> told;
  extract_labels(reader,
                 {Border::closed, false, [&](std::uint32_t slices) { told.push_back(slices); }});
  REQUIRE(told.size() == size.depth);
  CHECK(told.back() == size.depth);
}

TEST_CASE("values that cannot be labels are refused with their slice") {
  CHECK_THROWS_WITH_AS(extracted({1, 2, 3, 0.5F}, {2, 1, 2}),
                       "the value 0.5 in slice 1: labels are whole numbers below 2^53; give --iso "
                       "or --range",
                       std::invalid_argument);
  CHECK_THROWS_AS(extracted({1e20F}, {1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(extracted({0x1p53F}, {1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(extracted({std::numeric_limits<float>::infinity()}, {1, 1, 1}),
                  std::invalid_argument);
}

TEST_CASE("as many labels as there are are taken where their voxels lie together") {
  std::vector<float> samples;
  for (std::uint32_t i = 0; i < 4 * (max_scattered_labels + 500); ++i)
    samples.push_back(static_cast<float>(1 + i / 4));
  CHECK(extracted(samples, {static_cast<std::uint32_t>(samples.size()), 1, 1}).all.size() ==
        max_scattered_labels + 500);
}

TEST_CASE("more values in a slice than a segmentation has are refused") {
  std::vector<float> samples(max_scattered_labels + 2);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<float>(i);
  CHECK_THROWS_WITH_AS(extracted(samples, {max_scattered_labels + 2, 1, 1}),
                       doctest::Contains("more than 1024 values up to slice 0"),
                       std::invalid_argument);
  samples.pop_back();
  CHECK(extracted(samples, {max_scattered_labels + 1, 1, 1}).all.size() == max_scattered_labels);
}
