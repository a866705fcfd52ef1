// Code for the firmware, in C++ and in C: constants and static memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <discmc/capacities.hpp>
#include <discmc/limits.hpp>

namespace discmc::command {

struct FirmwareChoice {
  Limits limits;
  std::int32_t threshold = 0;
  std::vector<std::string> comments{};     ///< one per line
  std::uint64_t arena_bytes = 0;           ///< arena of regions; 0: slices
  std::optional<Capacities> capacities{};  ///< replaces arena_bytes
  std::uint32_t key_slices = 0;            ///< interval of key slices
};

/// Returns whole lines, which compile with only the headers of the library.
std::string cpp_code(const FirmwareChoice& choice);
std::string c_code(const FirmwareChoice& choice);

}  // namespace discmc::command
