// The least and the greatest sample of a volume.
#ifndef DISCMC_COMMAND_STATISTICS_SAMPLE_BOUNDS_HPP
#define DISCMC_COMMAND_STATISTICS_SAMPLE_BOUNDS_HPP

#include <cstddef>
#include <limits>

#include "volumes/volume.hpp"

namespace discmc::host {

/// Of the finite samples that have come. Units: as stored.
struct SampleBounds {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();

  /// Whether no finite sample has come.
  bool is_empty() const { return least > greatest; }

  /// samples: of the type, aligned.
  void include(SampleType type, const void* samples, std::size_t count);
};

/// Reads the volume to its end.
SampleBounds sample_bounds(VolumeReader& volume);

}  // namespace discmc::host

#endif
