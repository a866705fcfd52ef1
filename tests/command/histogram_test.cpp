// The number of samples per value, for every type, with few and many values.
#include "statistics/histogram.hpp"

#include <random>

#include "test.hpp"

namespace {

using discmc::command::Histogram;
using discmc::meshing::SampleType;

template <class Sample>
Histogram histogram_of(SampleType type, const std::vector<Sample>& samples) {
  Histogram histogram(type);
  const std::size_t half = samples.size() / 2;
  histogram.add(samples.data(), half);
  histogram.add(samples.data() + half, samples.size() - half);
  return histogram;
}

// The limits of the type and some values between, each a different number of times.
template <class Sample>
std::vector<Sample> few_samples() {
  using Limits = std::numeric_limits<Sample>;
  std::vector<Sample> samples;
  const Sample values[] = {Limits::lowest(), Limits::max(),
                           Sample{0},        Sample{1},
                           Sample{100},      static_cast<Sample>(Limits::lowest() / 2)};
  std::size_t times = 1;
  for (const Sample value : values) samples.insert(samples.end(), times++, value);
  std::shuffle(samples.begin(), samples.end(), std::mt19937(1));
  return samples;
}

}  // namespace

TEST_CASE(
    "a histogram of few distinct samples counts each value separately in ascending order, for "
    "every type") {
  for (const auto& [name, type] : discmc::command::sample_types)
    discmc::meshing::with_sample_type(type, [&, type = type](auto typed) {
      using Sample = decltype(typed);
      const std::vector<Sample> samples = few_samples<Sample>();
      std::map<double, std::uint64_t> expected;
      double sum = 0;
      for (const Sample sample : samples) ++expected[static_cast<double>(sample)];
      for (const auto& [sample, count] : expected) sum += sample * static_cast<double>(count);
      const Histogram histogram = histogram_of(type, samples);
      std::map<double, std::uint64_t> counted;
      double last = -std::numeric_limits<double>::infinity();
      for (const Histogram::Bin& bin : histogram.bins()) {
        CHECK(bin.sample > last);
        last = bin.sample;
        counted[bin.sample] = bin.count;
      }
      CHECK(counted == expected);
      CHECK(histogram.is_exact());
      CHECK(histogram.finite() == samples.size());
      CHECK(histogram.least() == expected.begin()->first);
      CHECK(histogram.greatest() == expected.rbegin()->first);
      if (std::isfinite(sum))
        CHECK(histogram.mean() ==
              doctest::Approx(sum / static_cast<double>(samples.size())).epsilon(1e-12));
    });
}

TEST_CASE("all samples of 16 bits have bins of their own") {
  std::vector<std::int16_t> samples;
  for (int sample = -32768; sample < 32768; ++sample)
    samples.insert(samples.end(), sample % 3 == 0 ? 2U : 1U, static_cast<std::int16_t>(sample));
  const Histogram histogram = histogram_of(SampleType::i16, samples);
  CHECK(histogram.is_exact());
  const auto bins = histogram.bins();
  REQUIRE(bins.size() == 65536);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const int sample = static_cast<int>(i) - 32768;
    if (bins[i].sample != sample || bins[i].count != (sample % 3 == 0 ? 2U : 1U)) FAIL(sample);
  }
}

TEST_CASE("a histogram counts non-finite values separately, and 0 and -0 together") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Histogram histogram =
      histogram_of<float>(SampleType::f32, {0, -0.0F, nan, infinity, 0, -infinity, infinity, nan});
  CHECK(histogram.not_numbers() == 2);
  CHECK(histogram.infinite() == 3);
  CHECK(histogram.finite() == 3);
  REQUIRE(histogram.bins().size() == 1);
  CHECK(histogram.bins()[0].count == 3);
  CHECK(histogram.mean() == 0);
}

TEST_CASE("a histogram with more distinct samples than bins counts neighbouring samples together") {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(40, 300);
  std::vector<float> samples;
  for (int i = 0; i < 400000; ++i) samples.push_back(static_cast<float>(noise(random)));
  const Histogram histogram = histogram_of(SampleType::f32, samples);
  CHECK(!histogram.is_exact());
  std::sort(samples.begin(), samples.end());
  CHECK(histogram.least() == static_cast<double>(samples.front()));
  CHECK(histogram.greatest() == static_cast<double>(samples.back()));
  const auto bins = histogram.bins();
  CHECK(bins.size() <= Histogram::max_bins);
  CHECK(bins.size() > Histogram::max_bins / 8);
  auto sample = samples.begin();
  std::uint64_t counted = 0;
  double worst = 0;
  for (const Histogram::Bin& bin : bins) {
    counted += bin.count;
    for (std::uint64_t i = 0; i < bin.count; ++i, ++sample)
      worst = std::max(worst, std::fabs(static_cast<double>(*sample) - bin.sample) /
                                  std::fabs(static_cast<double>(*sample)));
  }
  CHECK(counted == samples.size());
  CHECK(worst < 0.001);
}

TEST_CASE("an outlier does not coarsen the other bins of a histogram") {
  std::vector<std::int64_t> samples;
  for (int i = 0; i < 60000; ++i) samples.push_back(i);
  samples.push_back(std::numeric_limits<std::int64_t>::max());
  const Histogram histogram = histogram_of(SampleType::i64, samples);
  CHECK(histogram.is_exact());
  CHECK(histogram.bins().size() == 60001);
}
