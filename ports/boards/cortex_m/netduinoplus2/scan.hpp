// The scan of this board, and its memory.
#pragma once

#include <stddef.h>

#include <discmc/limits.hpp>

namespace scan {

using Sample = int16_t;
constexpr discmc::Limits limits{256, 256};
constexpr uint32_t depth = 108;  // slices, for the header of the stream
constexpr int32_t spacing_nm[] = {957000, -957000, 1500000};  // the y axis is mirrored
constexpr int32_t threshold = 300;
constexpr size_t arena_bytes = 123 * 1024;

}  // namespace scan
