// Samples as pictures store them: packed in bits, as halves, beside those of other channels, or as
// numbers of colours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pictures/srgb.hpp"

namespace discmc::command {

/// Takes one of the channels of pixels; samples may be where the pixels are stored.
void take_channel(const unsigned char* stored, std::size_t pixels, std::size_t sample_bytes,
                  std::uint32_t channels, std::uint32_t channel, unsigned char* samples);

/// Unpacks a row of whole numbers, the highest bit first, to bytes, or to words of native byte
/// order above 8 bits. Limit: 1 to 15 bits.
void unpack_bits(const unsigned char* stored, std::size_t count, unsigned bits,
                 unsigned char* samples);

/// Makes floats of halves (IEEE 754, 16 bits), both in native byte order.
void widen_halves(const unsigned char* stored, std::size_t count, unsigned char* samples);

using Palette = std::vector<Srgb>;

/// Whether its colours are grey values: samples then become those, not their numbers.
bool is_grey(const Palette& palette);

/// Replaces numbers of greys by the greys. Limit: is_grey(palette). Numbers beyond it stay.
void resolve_greys(const Palette& palette, unsigned char* samples, std::size_t count);

}  // namespace discmc::command
