// Measures the times of contenders alternately.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contenders.hpp"

namespace discmc::bench {

struct Result {
  std::string contender;
  std::string unit;
  uint64_t made;       ///< size of the result, in the contender's unit
  double nanoseconds;  ///< median of the processor time
};

/// The results for one volume.
struct Measurement {
  std::string volume;
  uint64_t voxels;
  uint64_t active_cells;
  bool is_generated;
  std::vector<Result> results;  ///< in the order of the contenders
};

/// Runs each contender once to warm up, then all alternately, so that slow periods of the machine
/// affect all. Runs at least 5 rounds, and up to 25 until a second has passed.
std::vector<Result> measure(const std::vector<Contender>& contenders);

}  // namespace discmc::bench
