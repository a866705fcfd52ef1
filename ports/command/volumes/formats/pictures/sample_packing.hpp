// Converts samples from the forms in pictures: packed bits, halves, interleaved channels, or
// indexes of colours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pictures/srgb.hpp"

namespace discmc::command {

/// Copies one channel of pixels; the samples may overwrite the pixels.
void copy_channel(const unsigned char* stored, std::size_t pixels, std::size_t sample_bytes,
                  std::uint32_t channels, std::uint32_t channel, unsigned char* samples);

/// Unpacks a row of whole numbers, the highest bit first, to bytes, or above 8 bits to words of
/// native byte order. Limit: 1 to 15 bits.
void unpack_bits(const unsigned char* stored, std::size_t count, unsigned bits,
                 unsigned char* samples);

/// Converts halves (IEEE 754, 16 bits) to floats, both in native byte order.
void widen_halves(const unsigned char* stored, std::size_t count, unsigned char* samples);

using Palette = std::vector<Srgb>;

/// Whether all colours are grey. Samples then become grey values instead of indexes.
bool is_grey(const Palette& palette);

/// Replaces indexes of greys by the greys. Limit: is_grey(palette). Indexes beyond the palette
/// stay.
void resolve_greys(const Palette& palette, unsigned char* samples, std::size_t count);

}  // namespace discmc::command
