// The surfaces of all labels in one pass.
#include "extraction/labels.hpp"

#include <random>

#include "hand_made.hpp"
#include "sample_reader.hpp"
#include "test.hpp"

namespace {

using discmc::Border;
using namespace discmc::meshing;
using discmc::reference::Size;
using sample_reader::SampleReader;

constexpr Size size = {19, 7, 23};

// Bodies and single voxels of the labels -2 to 3. Each label is absent from one, two, three or many
// slices in sequence.
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

discmc::meshing::Surface surface_of(int label, std::uint32_t seed, Border border,
                                    bool filters_by_majority, SampleType type) {
  SampleReader reader(size, labels(seed), {1, 2, 3}, type);
  discmc::meshing::SurfaceBuilder builder;
  discmc::command::ExtractionOptions options;
  const double value = label;
  options.selection = {value, value};
  options.border = border;
  options.filters_by_majority = filters_by_majority;
  extract(reader, options, discmc::make_sink(builder));
  return builder.surface();
}

std::vector<LabelledSurface> extracted(const std::vector<int>& samples, Size extents,
                                       const LabelOptions& options = {}) {
  SampleReader reader(extents, samples, {1, 1, 1}, SampleType::i32);
  return extract_labels(reader, options);
}

}  // namespace

TEST_CASE("the surface of every label equals the surface extracted for that label alone") {
  for (const Border border : {Border::closed, Border::open})
    for (const bool filters_by_majority : {false, true})
      for (std::uint32_t seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        const SampleType type = seed % 2 == 0 ? SampleType::i16 : SampleType::i64;
        SampleReader reader(size, labels(seed), {1, 2, 3}, type);
        const auto all = extract_labels(reader, {border, filters_by_majority, {}, {}});
        REQUIRE(all.size() == 5);
        for (std::size_t i = 0; i < all.size(); ++i) {
          const int label = std::vector<int>{-2, -1, 1, 2, 3}[i];
          CHECK(all[i].label == LabelValue(label));
          CHECK(all[i].surface.spacing_mm == discmc::meshing::Point{1, 2, 3});
          const auto alone = surface_of(label, seed, border, filters_by_majority, type);
          CHECK(discmc::reference::describe_difference(hand_made::regions_of(all[i].surface),
                                                       hand_made::regions_of(alone)) == "");
        }
      }
}

TEST_CASE("label extraction counts voxels per label and treats 0 as background") {
  const auto labels = extracted({0, 7, 7, 0, 7, 0, 0, -4}, {2, 2, 2});
  REQUIRE(labels.size() == 2);
  CHECK(labels[0].label == LabelValue(-4));
  CHECK(labels[0].voxels == 1);
  CHECK(labels[1].label == LabelValue(7));
  CHECK(labels[1].voxels == 3);
  CHECK(extracted({0, 0}, {2, 1, 1}).empty());
}

TEST_CASE(
    "a few chosen labels are extracted from a volume with more scattered labels than the limit") {
  std::vector<int> samples;
  for (int i = 0; i < 4 * static_cast<int>(max_scattered_labels); ++i) samples.push_back(i);
  LabelOptions options;
  options.chosen = {7, 9, -1, 0};
  const auto chosen =
      extracted(samples, {static_cast<std::uint32_t>(samples.size()), 1, 1}, options);
  REQUIRE(chosen.size() == 2);
  CHECK(chosen[0].label == LabelValue(7));
  CHECK(chosen[1].label == LabelValue(9));
  options.chosen.emplace();
  CHECK(extracted({1, 2}, {2, 1, 1}, options).empty());
}

TEST_CASE("label extraction reports progress after every slice") {
  SampleReader reader(size, labels(0));
  std::vector<std::uint32_t> progress;
  extract_labels(reader, {Border::closed, false, {}, [&](std::uint32_t slices) {
                            progress.push_back(slices);
                          }});
  REQUIRE(progress.size() == size.depth);
  CHECK(progress.back() == size.depth);
}

TEST_CASE("label extraction accepts any number of contiguous labels") {
  std::vector<int> samples;
  for (std::uint32_t i = 0; i < 4 * (max_scattered_labels + 500); ++i)
    samples.push_back(static_cast<int>(1 + i / 4));
  CHECK(extracted(samples, {static_cast<std::uint32_t>(samples.size()), 1, 1}).size() ==
        max_scattered_labels + 500);
}

TEST_CASE("a slice with more distinct values than any segmentation has is refused") {
  std::vector<int> samples(max_scattered_labels + 2);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<int>(i);
  CHECK_THROWS_WITH_AS(extracted(samples, {max_scattered_labels + 2, 1, 1}),
                       doctest::Contains("more than 1024 values up to slice 0"),
                       std::invalid_argument);
  samples.pop_back();
  CHECK(extracted(samples, {max_scattered_labels + 1, 1, 1}).size() == max_scattered_labels);
}
