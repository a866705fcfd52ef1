// What the simulator's firmware scans: little, for a UART in QEMU moves some 30 kB a second.
// Its memory runs short, so that loose fragments come too.
#pragma once

#include <stddef.h>

#include <discmc/limits.hpp>

namespace scan {

using Sample = uint8_t;
constexpr discmc::Limits limits{32, 32};
constexpr uint32_t depth = 12;               // slices, for the header of the stream
constexpr int32_t spacing_nm[] = {0, 0, 0};  // not known
constexpr int32_t threshold = 128;
constexpr size_t arena_bytes = 3 * 1024;

}  // namespace scan
