// Scans a volume as a device would, and measures the scan.
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
  std::uint64_t memory = 0;  ///< of the arena or the slice encoder; Units: bytes
  Peaks peaks{};
  std::uint64_t loose_pieces = 0;
  std::vector<DeviceWork> slices;  ///< total work after each slice
  DeviceWork work;                 ///< of the whole scan

  std::uint64_t stream_bytes() const { return work.bytes; }
};

/// Tries regions with an arena of this size. Limit: at least Extractor16::minimum_bytes(). Memory
/// beyond 32,759 slots is not used.
Trial try_regions(const VolumeBits& volume, std::uint64_t arena_bytes);

/// Likewise tries explicit capacities. Limit: valid for the index, which has 16 or 32 bits.
template <class Index>
Trial try_regions(const VolumeBits& volume, const Capacities& capacities);

/// Tries slices, with the memory that their encoder needs.
Trial try_slices(const VolumeBits& volume, std::uint32_t key_slice_interval);

/// Returns the largest arena that 16-bit indices can use. Units: bytes.
std::uint64_t max_arena_bytes(const Limits& limits);

/// Finds the smallest arena that sends nothing loose, in steps of 256 bytes. Returns nothing if no
/// arena with 16-bit indices suffices. plenty: the scan with memory for everything. done: called
/// after each of several scans.
std::optional<Trial> min_without_loose_pieces(const VolumeBits& volume, const Trial& plenty,
                                              const std::function<void()>& done);

/// Returns sizes from the minimum to below `end`, each a quarter to half larger than the one
/// before. Larger sizes are whole KiB. Units: bytes.
std::vector<std::uint64_t> arena_sizes(const Limits& limits, std::uint64_t end);

}  // namespace discmc::command
