// The scan of this board, and its memory.
#pragma once

#include <stddef.h>

#include <discmc/limits.hpp>

namespace scan {

using Sample = uint16_t;
constexpr discmc::Limits limits{100, 75};
constexpr uint32_t depth = 90;               // slices, for the header of the stream
constexpr int32_t spacing_nm[] = {0, 0, 0};  // unknown
constexpr int32_t threshold = 40000;
constexpr size_t arena_bytes = 58 * 1024;

}  // namespace scan
