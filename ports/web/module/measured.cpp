#include "measured.hpp"

#include <algorithm>
#include <limits>

#include "failure.hpp"
#include "statistics/threshold_rule.hpp"

namespace discmc::web {
namespace {

// The threshold by a rule; not a number where it does not fit the values.
double threshold(host::ThresholdRule rule, bool is_in_hounsfield,
                 const host::VolumeStatistics& statistics) {
  double iso = std::numeric_limits<double>::quiet_NaN();
  succeeds([&] { iso = host::threshold_by(rule, is_in_hounsfield, statistics).iso; });
  return iso;
}

}  // namespace

Measured measured(const MemoryVolume& volume) {
  MemoryReader reader(volume);
  const host::VolumeStatistics statistics = host::volume_statistics(reader, [](std::uint32_t) {});
  const bool is_in_hounsfield = host::is_in_hounsfield(volume.info(), statistics);
  Measured result{};
  result.least = statistics.least;
  result.greatest = statistics.greatest;
  result.numbers = static_cast<double>(statistics.numbers);
  const auto by = [&](host::ThresholdRule rule) {
    return threshold(rule, is_in_hounsfield, statistics);
  };
  result.automatic = by(host::ThresholdRule::automatic);
  result.otsu = by(host::ThresholdRule::otsu);
  result.bone = by(host::ThresholdRule::bone);
  result.skin = by(host::ThresholdRule::skin);
  if (statistics.numbers > 0) {
    result.dark = host::percentile(statistics, 0.5);
    result.bright = host::percentile(statistics, 99.5);
  }
  const double range = statistics.greatest - statistics.least;
  for (const host::ValueCount& each : statistics.counts) {
    const double share = range > 0 ? (each.value - statistics.least) / range : 0;
    const auto bar = static_cast<std::size_t>(share * Measured::bars);
    result.histogram[std::min(bar, Measured::bars - 1)] += static_cast<double>(each.count);
  }
  return result;
}

}  // namespace discmc::web
