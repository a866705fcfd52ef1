// What is particular to compilers: GCC and Clang have an instruction for each of these, others
// compute the same.
#ifndef DISCMC_COMPILER_HPP
#define DISCMC_COMPILER_HPP

#include <stdint.h>

namespace discmc {

/// Whether the lowest byte of a word comes first in memory. False where the compiler does not say.
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
constexpr bool is_little_endian = true;
#else
constexpr bool is_little_endian = false;
#endif

/// The word at `memory`, whatever the type of what lies there. Limit: memory is aligned to four
/// bytes and is_little_endian.
inline uint32_t aligned_word(const void* memory) {
#if defined(__GNUC__)
  uint32_t word;
  __builtin_memcpy(&word, __builtin_assume_aligned(memory, sizeof word), sizeof word);
  return word;
#else
  const uint8_t* const bytes = static_cast<const uint8_t*>(memory);
  return bytes[0] | uint32_t{bytes[1]} << 8 | uint32_t{bytes[2]} << 16 | uint32_t{bytes[3]} << 24;
#endif
}

/// Zeros below the lowest bit that is set. Limit: bits != 0.
inline uint32_t trailing_zeros(uint32_t bits) {
#if defined(__GNUC__)
  return static_cast<uint32_t>(__builtin_ctz(bits));
#else
  uint32_t zeros = 0;
  for (; (bits & 1) == 0; bits >>= 1) ++zeros;
  return zeros;
#endif
}

/// Bits up to the highest one that is set, 0 to 64.
inline uint32_t bit_width(uint64_t bits) {
#if defined(__GNUC__)
  return bits == 0 ? 0 : 64 - static_cast<uint32_t>(__builtin_clzll(bits));
#else
  uint32_t width = 0;
  for (; bits != 0; bits >>= 1) ++width;
  return width;
#endif
}

}  // namespace discmc

#endif
