// Statistics of a volume's values.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "meshing.hpp"
#include "samples/label_value.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Equal or nearly equal values, as Histogram counts them.
struct ValueCount {
  double value;
  std::uint64_t count;
  LabelValue whole{};  ///< the value, exactly, if VolumeStatistics::are_whole
};

/// Units: the unit that the file declares. Infinite values are only counted in `infinite`.
struct VolumeStatistics {
  std::uint64_t numbers = 0;  ///< finite ones
  std::uint64_t not_numbers = 0;
  std::uint64_t infinite = 0;
  double least = 0;
  double greatest = 0;
  double mean = 0;
  bool are_whole = false;               ///< whether stored values are whole numbers
  LabelValue min_whole{}, max_whole{};  ///< `least` and `greatest`, exactly, if are_whole
  std::vector<ValueCount> counts;       ///< in the order of values
  /// The value that the file declares for places that were not scanned.
  std::optional<double> declared_padding;
  /// Whether each of `counts` is of one value. Percentiles and Otsu's threshold are then exact,
  /// too.
  bool is_exact = true;
};

/// Reads the volume to its end. progress: called with the number of slices done.
VolumeStatistics volume_statistics(VolumeReader& volume,
                                   const std::function<void(std::uint32_t)>& progress);

/// Returns the least value that at least `percent` percent of the numbers do not exceed. Limit:
/// there are numbers; 0 < percent <= 100.
double percentile(const VolumeStatistics& statistics, double percent);

/// Returns the value of places that were not scanned, outside the circle that CT reconstructs. This
/// is the declared value, if it occurs. Otherwise the least value, at most -1000, is padding if all
/// others are far above or most values of air equal it.
std::optional<double> padding_value(const VolumeStatistics& statistics);

/// Returns Otsu's threshold, computed without padding_value(). It divides the values into the two
/// groups whose means, weighed by their sizes, differ most. The returned threshold lies between the
/// groups and has few digits. Returns nothing if there are fewer than two values.
std::optional<double> otsu_threshold(const VolumeStatistics& statistics);

}  // namespace discmc::command
