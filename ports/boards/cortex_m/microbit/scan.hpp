// The scan of this board, and its memory.
#pragma once

#include <stddef.h>

#include <discmc/limits.hpp>

namespace scan {

using Sample = uint8_t;
constexpr discmc::Limits limits{96, 96};
constexpr uint32_t depth = 216;              // slices, for the header of the stream
constexpr int32_t spacing_nm[] = {0, 0, 0};  // unknown
constexpr int32_t threshold = 128;
constexpr size_t arena_bytes = 13 * 1024;

}  // namespace scan
