// The voxels that a selection includes, for every sample type.
#include "extraction/selection.hpp"

#include "test.hpp"

namespace {

using namespace discmc::meshing;

constexpr double infinity = std::numeric_limits<double>::infinity();

SampleGrid scaled(double slope, double intercept) {
  SampleGrid info;
  info.slope = slope;
  info.intercept = intercept;
  return info;
}

template <class Sample>
SampleRange<Sample> range(const Selection& selection, const SampleGrid& info = {}) {
  return discmc::meshing::selected_samples<Sample>(info, selection);
}

template <class Sample>
bool is_empty(const SampleRange<Sample>& range) {
  return range.low > range.high;
}

// The bits of a slice of one row.
template <class Sample>
std::vector<int> selected(SampleType type, const std::vector<Sample>& samples,
                          const Selection& selection) {
  SampleGrid info;
  info.type = type;
  info.dims = {static_cast<std::uint32_t>(samples.size()), 1, 1};
  std::vector<std::uint8_t> bits(bit_row_bytes(info.dims[0]), 0xFF);
  SliceSelector(info, selection).select(samples.data(), bits.data(), bits.size());
  std::vector<int> on;
  for (std::size_t i = 0; i < 8 * bits.size(); ++i) on.push_back(bits[i / 8] >> i % 8 & 1);
  for (std::size_t i = samples.size(); i < on.size(); ++i) CHECK(on[i] == 0);
  on.resize(samples.size());
  return on;
}

}  // namespace

TEST_CASE_TEMPLATE("a range selects exactly the integer samples within its ends", Sample,
                   std::uint8_t, std::int8_t) {
  for (const double slope : {1.0, 0.1, 0.3, 1.0 / 3, 2.5})
    for (const double intercept : {0.0, 0.1, -1024.0})
      for (int low = -140; low <= 270; low += 7)
        for (const int length : {-1, 0, 1, 50}) {
          const SampleGrid info = scaled(slope, intercept);
          const auto value = [&](int stored) { return slope * stored + intercept; };
          const auto found = range<Sample>({value(low), value(low + length)}, info);
          for (int stored = std::numeric_limits<Sample>::min();
               stored <= std::numeric_limits<Sample>::max(); ++stored)
            REQUIRE(found.holds(static_cast<Sample>(stored)) ==
                    (low <= stored && stored <= low + length));
        }
}

TEST_CASE("a threshold between integers selects samples from the next larger integer on") {
  CHECK(range<std::int16_t>({499.5}).low == 500);
  CHECK(range<std::int16_t>({-2.5, 3.5}).low == -2);
  CHECK(range<std::int16_t>({-2.5, 3.5}).high == 3);
}

TEST_CASE("thresholds outside the range of the sample type select all voxels or none") {
  CHECK(range<std::uint8_t>({-1}).low == 0);
  CHECK(range<std::uint8_t>({-infinity}).low == 0);
  CHECK(is_empty(range<std::uint8_t>({255.5})));
  CHECK(is_empty(range<std::uint8_t>({infinity})));
  CHECK(is_empty(range<std::int8_t>({-infinity, -128.5})));
  CHECK(is_empty(range<std::uint8_t>({std::nan("")})));
  CHECK(range<std::int64_t>({-1e300}).low == INT64_MIN);
  CHECK(is_empty(range<std::uint64_t>({1e300})));
}

TEST_CASE("thresholds for 64-bit integers keep all their digits") {
  constexpr std::int64_t large = std::int64_t{1} << 53;
  CHECK(range<std::int64_t>({static_cast<double>(large)}).low == large);
  CHECK(range<std::uint64_t>({1e18}).low == 1000000000000000000U);
  CHECK(range<std::int64_t>({-1e18}).low == -1000000000000000000);
}

TEST_CASE("a floating-point sample equal to the threshold rounded to the sample type is on") {
  CHECK(range<float>({0.35}).low == 0.35F);  // which is below 0.35 of 64 bits
  CHECK(range<double>({0.35}).low == 0.35);
  CHECK(range<float>({0.1, 0.35}).high == 0.35F);
  CHECK(range<float>({0.35}, scaled(2, 0.15)).low == 0.1F);
}

TEST_CASE("selected bits are in the order of the samples, and unused bits are off") {
  const std::vector<std::int32_t> samples = {-5,    70000, 3, 4,     70001,
                                             69999, 70000, 0, 80000, -70000};
  CHECK(selected(SampleType::i32, samples, {70000}) ==
        std::vector<int>{0, 1, 0, 0, 1, 0, 1, 0, 1, 0});
  CHECK(selected(SampleType::i32, samples, {3, 70000}) ==
        std::vector<int>{0, 1, 1, 1, 0, 1, 1, 0, 0, 0});
}

TEST_CASE("a selection counts NaN samples and leaves their voxels off") {
  const float nan = std::nanf("");
  const std::vector<float> samples = {nan, 1, -1, nan, std::numeric_limits<float>::infinity()};
  CHECK(selected(SampleType::f32, samples, {0}) == std::vector<int>{0, 1, 0, 0, 1});
  CHECK(selected(SampleType::f32, samples, {-infinity, 0}) == std::vector<int>{0, 0, 1, 0, 0});
  SampleGrid info;
  info.type = SampleType::f32;
  info.dims = {5, 1, 1};
  std::uint8_t bits = 0;
  CHECK(SliceSelector(info, {0}).select(samples.data(), &bits, 1) == 2);
}
