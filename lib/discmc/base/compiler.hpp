// Everything that depends on a compiler or a processor. GCC and Clang have an instruction or an
// attribute for each item here; portable code computes the same for other compilers.
//
// DISCMC_FORCE_PORTABLE selects the portable code on every compiler, for tests and to isolate a
// fault. Define it for the library and for every file that includes its headers. The streams are
// identical to the byte.
#ifndef DISCMC_BASE_COMPILER_HPP
#define DISCMC_BASE_COMPILER_HPP

#if !(__cplusplus >= 201703L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201703L))
#error "discmc needs C++17 or later: compile with -std=c++17"
#endif

#include <limits.h>
#include <stddef.h>
#include <stdint.h>

static_assert(INT_MAX >= 0x7FFFFFFF,
              "discmc needs an int of at least 32 bits: its integers are promoted to int");

// ---- available features ----

#if !defined(DISCMC_FORCE_PORTABLE)
#if defined(__GNUC__) || defined(__clang__)
#define DISCMC_HAS_GNU
#if defined(__ARM_FEATURE_SIMD32)
#define DISCMC_HAS_LANE_SELECTION
#endif
#endif
#endif

// ---- for speed and size ----

#if defined(DISCMC_HAS_GNU)
#define DISCMC_PRAGMA(text) _Pragma(#text)
/// Before a function: never inline it; always inline it; inline everything that it calls.
#define DISCMC_NOINLINE [[gnu::noinline]]
#define DISCMC_ALWAYS_INLINE [[gnu::always_inline]] inline
#define DISCMC_FLATTEN [[gnu::flatten]]
/// Before a loop: unroll it this many times.
#define DISCMC_UNROLL(rounds) DISCMC_PRAGMA(GCC unroll rounds)
#else
#define DISCMC_NOINLINE
#define DISCMC_ALWAYS_INLINE inline
#define DISCMC_FLATTEN
#define DISCMC_UNROLL(rounds)
#endif

namespace discmc {

// ---- the processor ----

/// Whether the processor is a host with memory for larger tables and code: a 64-bit processor.
/// Boards are compiled hosted or freestanding, so __STDC_HOSTED__ does not distinguish them.
#if defined(DISCMC_FORCE_PORTABLE)
constexpr bool is_host = false;
#else
constexpr bool is_host = UINTPTR_MAX > UINT32_MAX;
#endif

/// Whether the lowest byte of a word comes first in memory. False if the compiler does not define
/// it.
#if defined(DISCMC_HAS_GNU) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
constexpr bool is_little_endian = true;
#else
constexpr bool is_little_endian = false;
#endif

// ---- memory ----

/// Copies bytes of any type. Limit: the count is a small constant.
DISCMC_ALWAYS_INLINE void copy_bytes(void* to, const void* from, size_t count) {
#if defined(DISCMC_HAS_GNU)
  __builtin_memcpy(to, from, count);
#else
  for (size_t i = 0; i < count; ++i)
    static_cast<uint8_t*>(to)[i] = static_cast<const uint8_t*>(from)[i];
#endif
}

/// Reads the word at `memory`, whatever its type. Limit: memory is aligned to four bytes, and
/// is_little_endian.
inline uint32_t aligned_word(const void* memory) {
#if defined(DISCMC_HAS_GNU)
  uint32_t word;
  __builtin_memcpy(&word, __builtin_assume_aligned(memory, sizeof word), sizeof word);
  return word;
#else
  const uint8_t* const bytes = static_cast<const uint8_t*>(memory);
  return bytes[0] | uint32_t{bytes[1]} << 8 | uint32_t{bytes[2]} << 16 | uint32_t{bytes[3]} << 24;
#endif
}

// ---- memory that is shared ----

/// load_acquire() reads, and store_release() writes, a word that an interrupt or another thread
/// shares. A reader of a released value also sees every earlier write. Without GCC or Clang: on one
/// processor only.
#if defined(DISCMC_HAS_GNU) && !(defined(__clang__) && defined(__ARM_ARCH_6M__))
inline uint32_t load_acquire(const uint32_t& word) {
  return __atomic_load_n(&word, __ATOMIC_ACQUIRE);
}
inline void store_release(uint32_t& word, uint32_t value) {
  __atomic_store_n(&word, value, __ATOMIC_RELEASE);
}
#else
// Clang for a Cortex-M0 would call library functions for these, which other compilers lack.
inline void keep_order() {
#if defined(DISCMC_HAS_GNU)
  __asm__ volatile("dmb" ::: "memory");
#else
  void (*volatile unknown)() = [] {};  // for the compiler, it may read and write all memory
  unknown();
#endif
}
inline uint32_t load_acquire(const uint32_t& word) {
  const uint32_t value = static_cast<const volatile uint32_t&>(word);
  keep_order();
  return value;
}
inline void store_release(uint32_t& word, uint32_t value) {
  keep_order();
  static_cast<volatile uint32_t&>(word) = value;
}
#endif

// ---- bits ----

namespace detail::derive {

// Multiplied by a de Bruijn sequence, each power of two has other bits at the top (C. Leiserson,
// H. Prokop, K. Randall, Using de Bruijn Sequences to Index a 1 in a Computer Word, 1998).
constexpr uint32_t de_bruijn = 0x077CB531;

struct BitPlaces {
  uint8_t by_top_bits[32];
};
constexpr BitPlaces bit_places() {
  BitPlaces places{};
  for (uint8_t bit = 0; bit < 32; ++bit)
    places.by_top_bits[(uint32_t{1} << bit) * de_bruijn >> 27] = bit;
  return places;
}

}  // namespace detail::derive

inline constexpr detail::derive::BitPlaces bit_places = detail::derive::bit_places();

/// trailing_zeros() for processors that have no instruction for it.
constexpr uint32_t trailing_zeros_by_table(uint32_t bits) {
  return bit_places.by_top_bits[(bits & (0 - bits)) * detail::derive::de_bruijn >> 27];
}

/// The number of zeros below the lowest 1. Limit: bits != 0.
inline uint32_t trailing_zeros(uint32_t bits) {
#if !defined(DISCMC_HAS_GNU) || (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) || \
    (defined(__riscv) && !defined(__riscv_zbb))
  return trailing_zeros_by_table(bits);
#else
  return static_cast<uint32_t>(__builtin_ctz(bits));
#endif
}

/// The number of bits up to the highest 1, 1 to 32. Limit: bits != 0.
DISCMC_ALWAYS_INLINE uint32_t bit_width_of_nonzero(uint32_t bits) {
#if !defined(DISCMC_HAS_GNU) || (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) || \
    (defined(__riscv) && !defined(__riscv_zbb))
  for (uint32_t shift = 1; shift < 32; shift *= 2) bits |= bits >> shift;
  return 1 + trailing_zeros_by_table(bits - bits / 2);
#else
  return 32 - static_cast<uint32_t>(__builtin_clz(bits));
#endif
}
/// The number of bits up to the highest 1, 0 to 32.
inline uint32_t bit_width(uint32_t bits) {
  return bits == 0 ? 0 : bit_width_of_nonzero(bits);
}

/// The number of bits up to the highest 1, 0 to 64.
inline uint32_t bit_width(uint64_t bits) {
#if defined(DISCMC_HAS_GNU)
  return bits == 0 ? 0 : 64 - static_cast<uint32_t>(__builtin_clzll(bits));
#else
  uint32_t width = 0;
  for (; bits != 0; bits >>= 1) ++width;
  return width;
#endif
}

// ---- division ----

/// Whether the processor has a division instruction. Without one, the compiler's library divides in
/// 270 bytes of code, so an extractor without normals does not divide.
#if defined(__ARM_ARCH_6M__) || (defined(__riscv) && !defined(__riscv_div))
constexpr bool has_division = false;
#else
constexpr bool has_division = true;
#endif

// ---- lanes of a word ----

/// Whether select_lanes() is two instructions.
#if defined(DISCMC_HAS_LANE_SELECTION)
constexpr bool has_lane_selection = true;
#else
constexpr bool has_lane_selection = false;
#endif

/// A lane is an unsigned number of lane_bits bits. Selects for each lane of the word: the lane of
/// `yes` if the lane of `a` is at least that of `b`, otherwise of `no`. Limit: lane_bits is 8 or
/// 16.
template <uint32_t lane_bits>
uint32_t select_lanes(uint32_t a, uint32_t b, uint32_t yes, uint32_t no) {
#if defined(DISCMC_HAS_LANE_SELECTION)
  // The subtraction sets a flag per lane, which selects the bytes.
  uint32_t lanes;
  __asm__("usub%c5 %0, %1, %2\n\tsel %0, %3, %4"
          : "=&r"(lanes)
          : "r"(a), "r"(b), "r"(yes), "r"(no), "i"(lane_bits)
          : "cc");
  return lanes;
#else
  uint32_t lanes = 0;
  for (uint32_t lane = (uint32_t{1} << lane_bits) - 1; lane != 0; lane <<= lane_bits)
    lanes |= ((a & lane) >= (b & lane) ? yes : no) & lane;
  return lanes;
#endif
}

}  // namespace discmc

#endif
