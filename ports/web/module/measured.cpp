#include "measured.hpp"

#include <algorithm>
#include <limits>

#include "failure.hpp"
#include "statistics/threshold_rule.hpp"

namespace discmc::web {
namespace {

// The threshold by a rule; NaN if the values do not suit it.
double threshold(command::ThresholdRule rule, bool is_in_hounsfield,
                 const command::VolumeStatistics& statistics) {
  double iso = std::numeric_limits<double>::quiet_NaN();
  succeeds([&] { iso = command::threshold_by(rule, is_in_hounsfield, statistics).iso; });
  return iso;
}

}  // namespace

Measured measured(const MemoryVolume& volume) {
  MemoryReader reader(volume);
  const command::VolumeStatistics statistics =
      command::volume_statistics(reader, [](std::uint32_t) {});
  const bool is_in_hounsfield = command::is_in_hounsfield(volume.info(), statistics);
  Measured result{};
  result.least = statistics.least;
  result.greatest = statistics.greatest;
  result.numbers = static_cast<double>(statistics.numbers);
  const auto threshold_by = [&](command::ThresholdRule rule) {
    return threshold(rule, is_in_hounsfield, statistics);
  };
  result.automatic = threshold_by(command::ThresholdRule::automatic);
  result.otsu = threshold_by(command::ThresholdRule::otsu);
  result.bone = threshold_by(command::ThresholdRule::bone);
  result.skin = threshold_by(command::ThresholdRule::skin);
  if (statistics.numbers > 0) {
    result.dark = command::percentile(statistics, 0.5);
    result.bright = command::percentile(statistics, 99.5);
  }
  const double range = statistics.greatest - statistics.least;
  for (const command::ValueCount& each : statistics.counts) {
    const double share = range > 0 ? (each.value - statistics.least) / range : 0;
    const auto bar = static_cast<std::size_t>(share * Measured::bars);
    result.histogram[std::min(bar, Measured::bars - 1)] += static_cast<double>(each.count);
  }
  return result;
}

}  // namespace discmc::web
