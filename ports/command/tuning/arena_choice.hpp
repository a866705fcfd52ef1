// Which sizes of the arena are worth a look, and from which on nothing is sent loose.
#ifndef DISCMC_COMMAND_TUNING_ARENA_CHOICE_HPP
#define DISCMC_COMMAND_TUNING_ARENA_CHOICE_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "trial.hpp"

namespace discmc::command {

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

#endif
