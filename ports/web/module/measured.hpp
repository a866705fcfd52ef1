// The values of a volume, and suggested thresholds.
#pragma once

#include <array>
#include <cstdint>

#include "memory_volume.hpp"

namespace discmc::web {

/// Units: of the file. NaN if there is none.
struct Measured {
  static constexpr std::size_t bars = 256;

  double least, greatest;              ///< of the finite values
  double dark, bright;                 ///< nearly all values lie between them
  double automatic, otsu, bone, skin;  ///< thresholds by the command's rules, if suitable
  double numbers;                      ///< finite values
  std::array<double, bars> histogram;  ///< values in equal steps from least to greatest
};

/// Time: a pass over the volume.
Measured measured(const MemoryVolume& volume);

}  // namespace discmc::web
