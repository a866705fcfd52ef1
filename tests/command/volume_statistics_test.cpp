// Percentiles, Otsu's threshold, and named thresholds.
#include "statistics/volume_statistics.hpp"

#include <stdexcept>

#include "sample_reader.hpp"
#include "statistics/threshold_rule.hpp"
#include "test.hpp"
#include "text/number_text.hpp"

namespace {

using namespace discmc::command;
using sample_reader::SampleReader;

VolumeStatistics statistics_of(const std::vector<int>& samples, SampleType type) {
  SampleReader reader({1, 1, static_cast<std::uint32_t>(samples.size())}, samples, {1, 1, 1}, type);
  return volume_statistics(reader, [](std::uint32_t) {});
}

VolumeStatistics statistics_of(const std::vector<ValueCount>& counts) {
  VolumeStatistics statistics;
  statistics.counts = counts;
  for (const ValueCount& each : counts) statistics.numbers += each.count;
  statistics.least = counts.front().value;
  statistics.greatest = counts.back().value;
  return statistics;
}

// By definition, the sum of squared distances from the means of both parts is minimal.
double cost(const std::vector<ValueCount>& counts, double threshold) {
  double cost = 0;
  for (const bool above : {false, true}) {
    double count = 0, sum = 0;
    for (const ValueCount& each : counts)
      if ((each.value >= threshold) == above) {
        count += static_cast<double>(each.count);
        sum += each.value * static_cast<double>(each.count);
      }
    for (const ValueCount& each : counts)
      if ((each.value >= threshold) == above)
        cost += static_cast<double>(each.count) * (each.value - sum / count) *
                (each.value - sum / count);
  }
  return cost;
}

std::string complaint(ThresholdRule rule, const VolumeStatistics& statistics) {
  try {
    threshold_by(rule, is_in_hounsfield({}, statistics), statistics);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a percentile is the smallest sample that the given share of samples does not exceed") {
  std::vector<int> samples;
  for (int i = 200; i > 0; --i) samples.push_back(i);
  const VolumeStatistics statistics = statistics_of(samples, SampleType::u8);
  CHECK(statistics.numbers == 200);
  CHECK(statistics.mean == 100.5);
  for (const int percent : {1, 5, 25, 50, 75, 95, 99, 100})
    CHECK(percentile(statistics, percent) == 2 * percent);
  CHECK(percentile(statistics, 0.25) == 1);
  CHECK(percentile(statistics, 0.75) == 2);
}

TEST_CASE("statistics of a volume apply the file's slope and intercept") {
  class Scaled final : public VolumeReader {
   public:
    Scaled() {
      info_.dims = {2, 1, 1};
      info_.slope = 0.5;
      info_.intercept = -1000;
    }
    const VolumeInfo& info() const override { return info_; }
    void read_slice(void* samples) override {
      static_cast<std::uint8_t*>(samples)[0] = 10;
      static_cast<std::uint8_t*>(samples)[1] = 20;
    }

   private:
    VolumeInfo info_;
  } reader;
  const VolumeStatistics statistics = volume_statistics(reader, [](std::uint32_t) {});
  CHECK(statistics.least == -995);
  CHECK(statistics.greatest == -990);
  CHECK(statistics.mean == -992.5);
  CHECK(percentile(statistics, 100) == -990);
}

TEST_CASE("Otsu's threshold has the largest variance between classes") {
  const std::vector<std::vector<ValueCount>> examples = {
      {{0, 10}, {1, 20}, {2, 5}, {7, 3}, {8, 9}, {9, 4}},
      {{-1024, 5000}, {-900, 100}, {0, 900}, {40, 2000}, {300, 80}, {1200, 150}},
      {{0.25, 1}, {0.5, 1}, {0.625, 1}},
      {{1e308, 3}, {1.2e308, 4}, {1.6e308, 1}},
  };
  for (const auto& counts : examples) {
    const double unit = counts.back().value;  // so that no square overflows
    std::vector<ValueCount> shares;
    for (const ValueCount& each : counts) shares.push_back({each.value / unit, each.count});
    const auto threshold = otsu_threshold(statistics_of(counts));
    REQUIRE(threshold);
    const double found = cost(shares, *threshold / unit);
    for (std::size_t i = 1; i < shares.size(); ++i)
      CHECK(found <= cost(shares, shares[i].value) * (1 + 1e-12));
  }
}

TEST_CASE("among equivalent thresholds, the one with the fewest digits is chosen") {
  const auto between = [](double low, double high) {
    return *otsu_threshold(statistics_of({{low, 1}, {high, 1}}));
  };
  CHECK(between(10, 200) == 100);
  CHECK(between(99, 100) == 100);
  CHECK(between(412, 413) == 413);
  CHECK(between(412.7, 412.9) == 412.8);
  CHECK(between(-1, 1) == 0);
  CHECK(between(0, 0.1) == 0.05);
  CHECK(!otsu_threshold(statistics_of({{7, 3}})));
}

TEST_CASE("padding outside the scanned circle of CT does not move Otsu's threshold") {
  const std::vector<ValueCount> scanned = {{-1010, 30}, {-1000, 60}, {-990, 30}, {0, 20},
                                           {40, 90},    {60, 40},    {900, 10}};
  const auto with = [&](double padding, std::uint64_t count) {
    std::vector<ValueCount> counts = scanned;
    counts.insert(counts.begin(), {padding, count});
    return statistics_of(counts);
  };
  const double expected = *otsu_threshold(statistics_of(scanned));
  CHECK(!padding_value(statistics_of(scanned)));
  for (const double padding : {-1024.0, -1100.0, -2000.0, -3024.0}) {
    CAPTURE(padding);
    CHECK(padding_value(with(padding, 400)) == padding);
    CHECK(otsu_threshold(with(padding, 400)) == expected);
  }
  // With few samples, and air beside it, the value is air and no padding.
  CHECK(!padding_value(with(-1024, 40)));
  // The surroundings of a body are its background.
  CHECK(
      !padding_value(statistics_of({{-1024, 5000}, {-900, 100}, {0, 900}, {40, 2000}, {300, 80}})));
  // A value of 0 is often background. Scanners other than CT have no such values.
  CHECK(!padding_value(statistics_of({{0, 400}, {300, 100}, {900, 10}})));
  CHECK(!padding_value(statistics_of({{-9999, 400}, {300, 100}, {900, 10}})));
  CHECK(!padding_value(statistics_of({{-2000, 400}, {-1, 100}, {1, 10}})));
  VolumeStatistics statistics = statistics_of({{0, 400}, {300, 100}, {900, 10}});
  statistics.declared_padding = 0;
  CHECK(padding_value(statistics) == 0);
  CHECK(*otsu_threshold(statistics) > 300);
  statistics.declared_padding = 5;
  CHECK(!padding_value(statistics));
}

TEST_CASE(
    "Hounsfield units are detected from the file or from values that range from air to bone") {
  const VolumeStatistics ct = statistics_of({{-1000, 5}, {40, 5}, {900, 1}});
  const VolumeStatistics mri = statistics_of({{0, 5}, {40, 5}, {900, 1}});
  VolumeInfo declared;
  declared.is_in_hounsfield = true;
  CHECK(is_in_hounsfield({}, ct));
  CHECK(!is_in_hounsfield({}, mri));
  CHECK(is_in_hounsfield(declared, mri));
  CHECK(threshold_by(ThresholdRule::automatic, true, ct).iso == 300);
  CHECK(threshold_by(ThresholdRule::automatic, true, ct).rule == ThresholdRule::bone);
  CHECK(threshold_by(ThresholdRule::skin, true, ct).iso == -300);
  const RuledThreshold otsu = threshold_by(ThresholdRule::automatic, false, mri);
  CHECK(otsu.rule == ThresholdRule::otsu);
  CHECK(otsu.iso == *otsu_threshold(mri));
}

TEST_CASE("a named threshold unsuitable for the volume is refused with the range of values") {
  const VolumeStatistics mri = statistics_of({{0, 5}, {900, 1}});
  CHECK(complaint(ThresholdRule::bone, mri) ==
        "--iso bone needs Hounsfield units, and the values are 0 to 900; give a number or --iso "
        "otsu");
  CHECK(complaint(ThresholdRule::otsu, statistics_of({{7, 3}})) ==
        "all values are 7, so no threshold divides them; give --iso 7 to select them all");
  CHECK(complaint(ThresholdRule::automatic, {}) ==
        "no value is finite, so there is no threshold; check the file");
}

TEST_CASE("a value is printed without digits that result from rounding") {
  CHECK(value_text(300) == "300");
  CHECK(value_text(-1024.5) == "-1024.5");
  CHECK(value_text(static_cast<double>(0.1F)) == "0.1");
  CHECK(value_text(0.1 * 3) == "0.3");
  CHECK(value_text(16777216) == "16777216");
  CHECK(value_text(-1e9) == "-1000000000");
  CHECK(value_text(4294967295.0) == "4294967295");
  CHECK(value_text(1e300) == "1e+300");
  CHECK(value_text(0) == "0");
}
