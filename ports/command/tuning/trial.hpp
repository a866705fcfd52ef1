// A scan as a device would make it, and what came of it.
#ifndef DISCMC_COMMAND_TUNING_TRIAL_HPP
#define DISCMC_COMMAND_TUNING_TRIAL_HPP

#include <cstdint>
#include <vector>

#include <discmc/extractor.hpp>
#include <discmc/slice_encoder.hpp>

#include "device_work.hpp"
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

}  // namespace discmc::command

#endif
