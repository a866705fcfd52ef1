// What `info` prints about a volume.
#pragma once

#include <ostream>

#include "statistics/volume_statistics.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// The header, without the notes: a key and its values per line, for people and programs.
void print_volume_info(const VolumeInfo& info, std::ostream& out);

/// The values, in the same way: range, mean, percentiles, a histogram, and options for extract. The
/// histogram has a line for every value if they are few, otherwise for intervals. The first and the
/// last interval also hold outliers.
void print_volume_statistics(const VolumeInfo& info, const VolumeStatistics& statistics,
                             std::ostream& out);

}  // namespace discmc::command
