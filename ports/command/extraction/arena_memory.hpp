// How an extractor uses the memory that it is given.
#pragma once

#include <cstdint>
#include <string>

#include <discmc/extractor.hpp>

namespace discmc::command {

/// Whether 16-bit indices count all slots that this memory holds with 32-bit indices, which is true
/// up to half a MiB. The scan then equals a scan on a device.
template <class Normals = detail::trace::BitIntake>
bool fits_narrow_indices(const Limits& limits, std::uint64_t memory) {
  return detail::sizing::default_capacities<std::uint16_t, Normals>(limits, memory).slots >=
         detail::sizing::default_capacities<std::uint32_t, Normals>(limits, memory).slots;
}

/// Returns the message for memory that is too small for an extractor. Units: bytes.
inline std::string too_little_memory(std::uint64_t bytes, const Limits& limits,
                                     std::uint64_t min_bytes) {
  return "--memory " + std::to_string(bytes) + " is too little for slices of " +
         std::to_string(limits.width) + "x" + std::to_string(limits.height) + "; give at least " +
         std::to_string(min_bytes) + " bytes";
}

}  // namespace discmc::command
