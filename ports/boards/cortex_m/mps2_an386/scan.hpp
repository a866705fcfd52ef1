// The scan of this board, and its memory.
#pragma once

#include <stddef.h>

#include <discmc/limits.hpp>

namespace scan {

using Sample = int16_t;
constexpr discmc::Limits limits{128, 128};
constexpr uint32_t depth = 64;               // slices, for the header of the stream
constexpr int32_t spacing_nm[] = {0, 0, 0};  // unknown
constexpr int32_t threshold = -300;
constexpr size_t arena_bytes = 120 * 1024;

}  // namespace scan
