// A scan as a device would make it, and what came of it.
#pragma once

#include <cstdint>
#include <discmc/extractor.hpp>
#include <discmc/slice_encoder.hpp>
#include <functional>
#include <optional>
#include <vector>

#include "cycle_costs.hpp"
#include "volume_bits.hpp"

namespace discmc::command {

struct Trial {
  std::uint64_t memory = 0;  ///< that the arena or the slice encoder had; Units: bytes
  Peaks peaks{};
  std::uint64_t loose_pieces = 0;
  std::vector<DeviceWork> slices;  ///< with what was done by the end of each, in all
  DeviceWork work;                 ///< of the whole scan

  std::uint64_t stream_bytes() const { return work.bytes; }
};

/// Regions, in an arena of this size. Limit: at least Extractor16::minimum_bytes(), and what is
/// beyond 32,759 slots is not used.
Trial try_regions(const VolumeBits& volume, std::uint64_t arena_bytes);

/// The same with explicit capacities. Limit: valid for the index, which is 16 or 32 bits wide.
template <class Index>
Trial try_regions(const VolumeBits& volume, const Capacities& capacities);

/// Slices, in the memory that their encoder takes.
Trial try_slices(const VolumeBits& volume, std::uint32_t key_slice_interval);

/// The most that 16-bit indices make use of. Units: bytes.
std::uint64_t max_arena_bytes(const Limits& limits);

/// The least arena with which nothing is sent loose, up to a step of 256 bytes. Nothing if 16-bit
/// indices cannot count the slots of any. plenty: the scan with memory for everything. done: is
/// called after each of some scans.
std::optional<Trial> min_without_loose_pieces(const VolumeBits& volume, const Trial& plenty,
                                              const std::function<void()>& done);

/// From the minimum on, each a quarter to half larger than the one before, and in whole KiB where
/// that does not matter: below `end`. Units: bytes.
std::vector<std::uint64_t> arena_sizes(const Limits& limits, std::uint64_t end);

}  // namespace discmc::command
