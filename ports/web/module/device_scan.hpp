// The same scan on a device with this much memory, and the bytes that it sends.
#pragma once

#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

#include "voxel_bits.hpp"

namespace discmc::web {

struct DeviceScan {
  std::vector<std::uint8_t> stream;  ///< complete: a .dmc file
  std::uint64_t regions = 0;         ///< sent as whole regions
  std::uint64_t fragments = 0;       ///< sent as loose fragments, which the receiver joins
  std::uint64_t memory_used = 0;     ///< Units: bytes
};

/// The minimum memory of scan_regions(). Units: bytes.
std::uint64_t min_memory(const StreamHeader& header);

/// As a stream of regions. Limit: memory >= min_memory(header).
DeviceScan scan_regions(const VoxelBits& bits, const StreamHeader& header, std::uint64_t memory);

/// As a stream of slices, with one key slice.
DeviceScan scan_slices(const VoxelBits& bits, const StreamHeader& header);

}  // namespace discmc::web
