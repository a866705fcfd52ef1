// Computes the fractions of a volume from its samples, by definition.
#pragma once

#include <cstdlib>
#include <vector>

#include "gradient.hpp"

namespace discmc::reference {

/// Returns the distance that represents all distances of an octave. Units: halves, as the argument.
inline uint64_t middle_of_octave(uint64_t distance) {
  const uint64_t whole = distance / 2;
  uint64_t octave = 0;
  while (octave < 15 && whole >> octave != 0) ++octave;
  return octave == 0 ? 1 : uint64_t{3} << (octave - 1);
}

/// Returns the level at which the surface crosses the edge between two samples, in eighths from the
/// lower one; 0 if it does not cross. The isovalue is threshold - 1/2.
inline uint32_t fraction_between(int64_t lower, int64_t upper, int64_t threshold, uint32_t levels,
                                 bool is_lower_rounded) {
  const bool is_upper_on = upper >= threshold;
  if ((lower >= threshold) == is_upper_on) return 0;
  const auto distance = [threshold](int64_t sample) {
    return static_cast<uint64_t>(std::llabs(2 * sample - (2 * threshold - 1)));
  };
  const uint64_t lower_distance =
      is_lower_rounded ? middle_of_octave(distance(lower)) : distance(lower);
  const uint64_t upper_distance = distance(upper);
  const uint64_t off_distance = is_upper_on ? lower_distance : upper_distance;
  const auto level =
      static_cast<uint32_t>(levels * off_distance / (lower_distance + upper_distance));
  const uint32_t eighths = (2 * level + 1) * 4 / levels;
  return is_upper_on ? eighths : 8 - eighths;
}

/// Returns the entries of a row.
template <class Sample>
std::vector<uint16_t> fractions_of_row(const SampleVolume<Sample>& volume, int32_t threshold,
                                       uint32_t levels, uint32_t y, uint32_t z) {
  std::vector<uint16_t> entries(volume.size.width);
  const Sample* const row = volume.row(y, z);
  for (uint32_t x = 0; x < volume.size.width; ++x) {
    const auto fraction_from = [&](Sample lower, bool is_rounded) {
      return fraction_between(lower, row[x], threshold, levels, is_rounded);
    };
    const uint32_t along_x = x > 0 ? fraction_from(row[x - 1], false) : 0;
    const uint32_t along_y = y > 0 ? fraction_from(volume.row(y - 1, z)[x], false) : 0;
    const uint32_t along_z = z > 0 ? fraction_from(volume.row(y, z - 1)[x], true) : 0;
    entries[x] = static_cast<uint16_t>(along_x | along_y << 3 | along_z << 6);
  }
  return entries;
}

/// Returns a volume of samples with these bits at threshold 100.
inline SampleVolume<uint8_t> samples_with(const BitVolume& bits) {
  SampleVolume<uint8_t> volume{{bits.width, bits.height, bits.depth}, {}};
  uint32_t noise = 1;
  for (const uint8_t on : bits.on) {
    noise = noise * 1664525 + 1013904223;
    volume.samples.push_back(
        static_cast<uint8_t>(on != 0 ? 100 + (noise >> 24) % 156 : (noise >> 24) % 100));
  }
  return volume;
}

}  // namespace discmc::reference
