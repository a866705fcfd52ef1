// The least and the greatest sample of a volume.
#ifndef DISCMC_MESH_SAMPLES_SAMPLE_BOUNDS_HPP
#define DISCMC_MESH_SAMPLES_SAMPLE_BOUNDS_HPP

#include <cstddef>
#include <limits>

#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// The bounds of the finite samples so far, and whether there were infinite samples. Units: as
/// stored.
struct SampleBounds {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double least = infinity;
  double greatest = -infinity;
  bool has_infinity = false;
  bool has_minus_infinity = false;
  bool has_between = false;  ///< whether finite samples lie between the bounds

  /// Whether there was no finite sample.
  bool is_empty() const { return least > greatest; }

  /// samples: of this type, aligned.
  void include(SampleType type, const void* samples, std::size_t count);
};

/// Reads the volume to its end.
SampleBounds sample_bounds(SliceReader& volume);

}  // namespace discmc::meshing

#endif
