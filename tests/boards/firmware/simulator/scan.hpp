// The scan of the simulator's firmware. It is small, because a UART in QEMU transfers about 30 kB
// per second. Its memory is too little, so loose fragments are sent.
#pragma once

#include <stddef.h>

#include <discmc/limits.hpp>

namespace scan {

using Sample = uint8_t;
constexpr discmc::Limits limits{32, 32};
constexpr uint32_t depth = 12;               // slices, for the header of the stream
constexpr int32_t spacing_nm[] = {0, 0, 0};  // unknown
constexpr int32_t threshold = 128;
constexpr size_t arena_bytes = 3 * 1024;

}  // namespace scan
