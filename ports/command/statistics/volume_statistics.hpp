// The values of a volume: what is there, and how often.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "meshing.hpp"
#include "samples/label_value.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Values that are alike, or all but alike, as Histogram counts them.
struct ValueCount {
  double value;
  std::uint64_t count;
  LabelValue whole{};  ///< the value, exactly, where VolumeStatistics::are_whole
};

/// Units: those that the file declares. Infinite values count as infinite, and nowhere else.
struct VolumeStatistics {
  std::uint64_t numbers = 0;  ///< finite ones
  std::uint64_t not_numbers = 0;
  std::uint64_t infinite = 0;
  double least = 0;
  double greatest = 0;
  double mean = 0;
  bool are_whole = false;               ///< the values, as they are stored: up to 64 bits
  LabelValue min_whole{}, max_whole{};  ///< then `least` and `greatest`, exactly
  std::vector<ValueCount> counts;       ///< in the order of values
  /// The value that the file has where nothing was scanned, if it states one.
  std::optional<double> declared_padding;
  /// Whether each of `counts` is of one value. Then percentiles and Otsu's threshold are exact,
  /// too.
  bool is_exact = true;
};

/// Reads the volume to its end. progress: called with the number of slices done.
VolumeStatistics volume_statistics(VolumeReader& volume,
                                   const std::function<void(std::uint32_t)>& progress);

/// The least value that at least `percent` percent of the numbers do not exceed.
/// Limit: there are numbers; 0 < percent <= 100.
double percentile(const VolumeStatistics& statistics, double percent);

/// The value where nothing was scanned, outside the circle that CT reconstructs. It is the value
/// that the file declares, if it occurs. Otherwise it is the least value, from -1000 down, if all
/// others are far above, or if most values that may be air have it.
std::optional<double> padding_value(const VolumeStatistics& statistics);

/// Otsu's threshold, without padding_value(): divides the values into the two groups whose means
/// differ most, weighed by their sizes. A threshold between the two groups with few digits is
/// returned; nothing if there are no two values.
std::optional<double> otsu_threshold(const VolumeStatistics& statistics);

}  // namespace discmc::command
