// What to put into the firmware: constants and static memory, in C++ and in C.
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
  std::vector<std::string> comments{};     ///< a line each
  std::uint64_t arena_bytes = 0;           ///< of regions; 0: slices
  std::optional<Capacities> capacities{};  ///< in place of arena_bytes
  std::uint32_t key_slices = 0;            ///< the interval, of slices
};

/// Whole lines, which compile with the headers of the library and nothing else.
std::string cpp_code(const FirmwareChoice& choice);
std::string c_code(const FirmwareChoice& choice);

}  // namespace discmc::command
