#include "volume_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "histogram.hpp"

namespace discmc::command {
namespace {

double rounded(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return std::strtod(text, nullptr);
}

// Returns the number with the fewest digits above `low` and up to `high`, near their middle if
// possible.
double short_number_between(double low, double high) {
  const double middle = low / 2 + high / 2;
  for (int digits = 1; digits <= 17; ++digits)
    for (const double value : {rounded(middle, digits), rounded(high, digits)})
      if (low < value && value <= high) return value;
  return high;
}

}  // namespace

VolumeStatistics volume_statistics(VolumeReader& volume,
                                   const std::function<void(std::uint32_t)>& progress) {
  const VolumeInfo& info = volume.info();
  Histogram histogram(info.type);
  std::vector<std::uint8_t> slice(info.slice_bytes());
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    histogram.add(slice.data(), std::size_t{info.dims[0]} * info.dims[1]);
    progress(z + 1);
  }
  const auto value = [&info](double sample) { return info.slope * sample + info.intercept; };
  VolumeStatistics statistics;
  statistics.numbers = histogram.finite();
  statistics.not_numbers = histogram.not_numbers();
  statistics.infinite = histogram.infinite();
  statistics.least = value(histogram.least());
  statistics.greatest = value(histogram.greatest());
  statistics.mean = value(histogram.mean());
  for (const Histogram::Bin& bin : histogram.bins())
    statistics.counts.push_back({value(bin.sample), bin.count, bin.whole});
  statistics.declared_padding = info.padding;
  statistics.are_whole = !is_floating(info.type) && info.slope == 1 && info.intercept == 0;
  statistics.min_whole = histogram.min_whole();
  statistics.max_whole = histogram.max_whole();
  statistics.is_exact = histogram.is_exact();
  return statistics;
}

double percentile(const VolumeStatistics& statistics, double percent) {
  const double target_count = percent * static_cast<double>(statistics.numbers) / 100;
  std::uint64_t count_below = 0;
  for (const ValueCount& each : statistics.counts) {
    count_below += each.count;
    if (static_cast<double>(count_below) >= target_count) return each.value;
  }
  return statistics.greatest;
}

std::optional<double> padding_value(const VolumeStatistics& statistics) {
  const std::vector<ValueCount>& counts = statistics.counts;
  const auto padding = std::find_if(counts.begin(), counts.end(), [&](const ValueCount& each) {
    return each.value == statistics.declared_padding;
  });
  if (padding != counts.end()) return padding->value;
  // Units: Hounsfield. Values that may be air or padding, and the least that CT writes.
  constexpr double max_air = -500, min_air = -1024, min_value = -4096, max_padding = -1000;
  constexpr double min_bone = 300, gap = 200, share = 0.05;
  if (counts.size() < 3 || counts[0].value > max_padding || counts[0].value < min_value ||
      counts.back().value < min_bone)
    return std::nullopt;
  if (counts[0].value < min_air && counts[1].value - counts[0].value >= gap) return counts[0].value;
  double air = 0;
  std::uint64_t max_count = 0;
  for (std::size_t i = 1; i < counts.size() && counts[i].value <= max_air; ++i) {
    air += static_cast<double>(counts[i].count);
    max_count = std::max(max_count, counts[i].count);
  }
  const bool is_padding =
      counts[0].count > max_count && air >= share * static_cast<double>(statistics.numbers);
  return is_padding ? std::optional(counts[0].value) : std::nullopt;
}

std::optional<double> otsu_threshold(const VolumeStatistics& statistics) {
  std::vector<ValueCount> counts = statistics.counts;
  auto whole = static_cast<double>(statistics.numbers);
  if (const auto padding = padding_value(statistics)) {
    const auto found = std::find_if(counts.begin(), counts.end(),
                                    [&](const ValueCount& each) { return each.value == *padding; });
    whole -= static_cast<double>(found->count);
    counts.erase(found);
  }
  // Scales by the largest magnitude, so that no square overflows.
  const double unit = std::max(std::fabs(statistics.least), std::fabs(statistics.greatest));
  double whole_sum = 0;
  for (const ValueCount& each : counts)
    whole_sum += each.value / unit * static_cast<double>(each.count);

  double max_variance = 0;
  std::size_t best = 0;
  double below = 0;
  double sum_below = 0;
  for (std::size_t i = 1; i < counts.size(); ++i) {
    below += static_cast<double>(counts[i - 1].count);
    sum_below += counts[i - 1].value / unit * static_cast<double>(counts[i - 1].count);
    const double difference = sum_below / below - (whole_sum - sum_below) / (whole - below);
    const double variance = below * (whole - below) * difference * difference;
    if (variance <= max_variance) continue;
    max_variance = variance;
    best = i;
  }
  if (best == 0) return std::nullopt;
  return short_number_between(counts[best - 1].value, counts[best].value);
}

}  // namespace discmc::command
