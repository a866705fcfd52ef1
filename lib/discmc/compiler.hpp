// What is particular to compilers: GCC and Clang have an instruction for each of these, others
// compute the same.
#ifndef DISCMC_COMPILER_HPP
#define DISCMC_COMPILER_HPP

#include <stdint.h>

namespace discmc {

/// Whether the processor is a host's, with memory for larger tables and code: one of 64 bits.
/// Boards are compiled hosted or freestanding, so that does not tell.
constexpr bool is_host = UINTPTR_MAX > UINT32_MAX;

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

namespace derive {

// Multiplied by a de Bruijn sequence, each power of two has other bits at the top (C. Leiserson,
// H. Prokop, K. Randall, Using de Bruijn Sequences to Index a 1 in a Computer Word, 1998).
constexpr uint32_t de_bruijn = 0x077CB531;

struct BitPlaces {
  uint8_t of[32];
};
constexpr BitPlaces bit_places() {
  BitPlaces places{};
  for (uint8_t bit = 0; bit < 32; ++bit) places.of[(uint32_t{1} << bit) * de_bruijn >> 27] = bit;
  return places;
}

}  // namespace derive

inline constexpr derive::BitPlaces bit_places = derive::bit_places();

/// trailing_zeros() for processors that have no instruction for it.
constexpr uint32_t trailing_zeros_by_table(uint32_t bits) {
  return bit_places.of[(bits & (0 - bits)) * derive::de_bruijn >> 27];
}

/// Zeros below the lowest bit that is set. Limit: bits != 0.
inline uint32_t trailing_zeros(uint32_t bits) {
#if !defined(__GNUC__) || (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) || \
    (defined(__riscv) && !defined(__riscv_zbb))
  return trailing_zeros_by_table(bits);
#else
  return static_cast<uint32_t>(__builtin_ctz(bits));
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
