// Times contenders in turns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contenders.hpp"

namespace discmc::bench {

struct Result {
  std::string contender;
  std::string unit;
  uint64_t made;       ///< how many of the unit
  double nanoseconds;  ///< of processor time, the median
};

/// What came of one volume.
struct Measurement {
  std::string volume;
  uint64_t voxels;
  uint64_t active_cells;
  bool is_generated;
  std::vector<Result> results;  ///< in the order of the contenders
};

/// Runs each once to warm up and then all in turns, so that a slow spell of the machine hits them
/// alike. There are at least 5 rounds, and up to 25 until a second has passed.
std::vector<Result> measure(const std::vector<Contender>& contenders);

}  // namespace discmc::bench
