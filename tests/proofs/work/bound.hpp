// The bound on the work of a call, as published in lib/DESIGN.md ("Work").
#pragma once

#include <cstdint>
#include <discmc/trace/bit_rows.hpp>

namespace discmc::work {

/// The quantities on which the basic blocks of a call depend.
struct Asked {
  uint64_t voxels = 0;
  uint64_t rows = 0;       ///< swept rows of voxels
  uint64_t vertices = 0;   ///< in these rows
  uint64_t delivered = 0;  ///< events, plus one for every 680 links of a run
  bool is_short = false;   ///< of slots
};

/// Portable code has more blocks.
#if defined(DISCMC_FORCE_PORTABLE)
constexpr bool is_portable = true;
#else
constexpr bool is_portable = false;
#endif

/// Units: basic blocks of code compiled by GCC or Clang with -O1.
struct Cost {
  static constexpr uint64_t call = 160;
  static constexpr uint64_t voxel = 4;
  static constexpr uint64_t row = 140;
  static constexpr uint64_t word = 40;
  static constexpr uint64_t vertex = 400;
  static constexpr uint64_t short_vertex = 700;  ///< more, to measure fragments
  static constexpr uint64_t delivered = 80;
  static constexpr uint64_t hole_run = 20;   ///< of a run of a hole that may wait
  static constexpr uint64_t hole_look = 12;  ///< for a hole that waits and a run of a ring
};

/// holes: all that the scan delivers, because a ring may be compared with each. hole_runs: of all
/// holes.
inline uint64_t bound(uint32_t width, const Asked& asked, uint64_t holes, uint64_t hole_runs) {
  const uint64_t vertex = Cost::vertex + (asked.is_short ? Cost::short_vertex : 0);
  const uint64_t blocks = Cost::call + asked.voxels * Cost::voxel +
                          asked.rows * (Cost::row + detail::trace::row_words(width) * Cost::word) +
                          asked.vertices * vertex +
                          asked.delivered * (Cost::delivered + holes * Cost::hole_look) +
                          hole_runs * Cost::hole_run;
  return is_portable ? blocks + blocks / 20 : blocks;
}

/// The bound per coded row. The work per packet is its checksum and the change to the next packet.
struct SliceCost {
  static constexpr uint64_t row = 2000;  ///< the first row of a key slice, which resets the model
  static constexpr uint64_t voxel = 60;
  // Additional blocks with fractions.
  static constexpr uint64_t fraction_row = 1500;
  static constexpr uint64_t fraction_voxel = 300;  ///< of its three edges
};

inline uint64_t slice_row_bound(uint32_t width, uint32_t surfaces, bool has_fractions) {
  const uint64_t row = SliceCost::row + (has_fractions ? SliceCost::fraction_row : 0);
  const uint64_t voxel = SliceCost::voxel + (has_fractions ? SliceCost::fraction_voxel : 0);
  return surfaces * (row + width * voxel) * (is_portable ? 2 : 1);
}

}  // namespace discmc::work
