#include "sample_packing.hpp"

#include <algorithm>
#include <cstring>

#include "volumes/byte_source.hpp"

namespace discmc::command {

void copy_channel(const unsigned char* stored, std::size_t pixels, std::size_t sample_bytes,
                  std::uint32_t channels, std::uint32_t channel, unsigned char* samples) {
  stored += channel * sample_bytes;
  for (std::size_t i = 0; i < pixels; ++i)
    std::memmove(samples + i * sample_bytes, stored + i * channels * sample_bytes, sample_bytes);
}

void unpack_bits(const unsigned char* stored, std::size_t count, unsigned bits,
                 unsigned char* samples) {
  std::uint32_t buffer = 0;
  unsigned buffered = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (; buffered < bits; buffered += 8) buffer = buffer << 8 | *stored++;
    buffered -= bits;
    const std::uint32_t value = buffer >> buffered & ((1U << bits) - 1);
    if (bits <= 8) {
      samples[i] = static_cast<unsigned char>(value);
    } else {
      const auto word = static_cast<std::uint16_t>(value);
      std::memcpy(samples + 2 * i, &word, 2);
    }
  }
}

void widen_halves(const unsigned char* stored, std::size_t count, unsigned char* samples) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t half = 0;
    std::memcpy(&half, stored + 2 * i, sizeof half);
    const float value = float_of_half(half);
    std::memcpy(samples + 4 * i, &value, sizeof value);
  }
}

bool is_grey(const Palette& palette) {
  return !palette.empty() && std::all_of(palette.begin(), palette.end(), [](const Srgb& colour) {
    return colour[0] == colour[1] && colour[1] == colour[2];
  });
}

void resolve_greys(const Palette& palette, unsigned char* samples, std::size_t count) {
  std::for_each(samples, samples + count, [&palette](unsigned char& sample) {
    if (sample < palette.size()) sample = palette[sample][0];
  });
}

}  // namespace discmc::command
