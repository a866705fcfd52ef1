// Balls whose samples fall evenly from the centre outwards.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gradient.hpp"

namespace discmc::reference {

/// Units: samples per voxel for the slope; samples.
struct Ramp {
  double slope;
  int threshold, most;  ///< at the ball's surface; maximum of the type; the minimum is 0
};

/// Returns a volume of `extent` voxels along each axis with the ball in its middle. Units: voxels.
inline SampleVolume<int> ramp_ball(uint32_t extent, double radius, const Ramp& ramp) {
  SampleVolume<int> volume{{extent, extent, extent}, {}};
  const double centre = (extent - 1) / 2.0;
  for (uint32_t z = 0; z < extent; ++z)
    for (uint32_t y = 0; y < extent; ++y)
      for (uint32_t x = 0; x < extent; ++x) {
        const double distance = std::hypot(x - centre, y - centre, z - centre);
        const double sample = ramp.threshold + ramp.slope * (radius - distance);
        volume.samples.push_back(
            static_cast<int>(std::lround(std::clamp(sample, 0.0, double{ramp.most * 1.0}))));
      }
  return volume;
}

}  // namespace discmc::reference
