// The vector registers of a host, of 16 bytes: SSE2 on x86, NEON on AArch64. Firmware is compiled
// freestanding and has none. AVX2 was measured, and makes no extraction faster.
#ifndef DISCMC_HOST_VECTOR_HPP
#define DISCMC_HOST_VECTOR_HPP

#include <discmc/compiler.hpp>

#if defined(DISCMC_HAS_SSE2)
#include <emmintrin.h>
#elif defined(DISCMC_HAS_NEON)
#include <arm_neon.h>
#endif

namespace discmc::trace {

// Whether there are vectors is has_vectors; what they do is
//
//   load(samples)          a vector of samples from any address
//   fill(sample)           the sample in every lane
//   above(samples, bound)  0 in the lanes of samples that are not greater than the bound
//   narrow(low, high)      a byte for each 16-bit lane of low, then of high: 0 where the lane is 0
//   nonzero(bytes)         bit i: whether byte i of the vectors is not 0
#if defined(DISCMC_HAS_SSE2)

constexpr bool has_vectors = true;
using Vector = __m128i;

inline Vector load(const void* samples) {
  return _mm_loadu_si128(static_cast<const Vector*>(samples));
}

template <class Sample>
Vector fill(Sample sample) {
  if constexpr (sizeof(Sample) == 1) return _mm_set1_epi8(static_cast<char>(sample));
  return _mm_set1_epi16(static_cast<int16_t>(sample));
}

// There is no comparison of unsigned lanes, but a difference that stops at 0.
template <class Sample>
Vector above(Vector samples, Vector bound) {
  if constexpr (Sample(-1) < 0) return _mm_cmpgt_epi16(samples, bound);
  if constexpr (sizeof(Sample) == 1) return _mm_subs_epu8(samples, bound);
  return _mm_subs_epu16(samples, bound);
}

inline Vector narrow(Vector low, Vector high) {
  return _mm_packs_epi16(low, high);
}

inline uint32_t nonzero(const Vector (&bytes)[2]) {
  const auto mask = [](Vector half) {
    const Vector top_bits = _mm_adds_epu8(half, _mm_set1_epi8(0x7F));
    return static_cast<uint32_t>(_mm_movemask_epi8(top_bits));
  };
  return mask(bytes[0]) | mask(bytes[1]) << 16;
}

#elif defined(DISCMC_HAS_NEON)

constexpr bool has_vectors = true;
using Vector = uint8x16_t;

inline Vector load(const void* samples) {
  return vld1q_u8(static_cast<const uint8_t*>(samples));
}

inline Vector fill(uint8_t sample) {
  return vdupq_n_u8(sample);
}
inline Vector fill(uint16_t sample) {
  return vreinterpretq_u8_u16(vdupq_n_u16(sample));
}
inline Vector fill(int16_t sample) {
  return vreinterpretq_u8_s16(vdupq_n_s16(sample));
}

template <class Sample>
Vector above(Vector samples, Vector bound) {
  if constexpr (Sample(-1) < 0)
    return vreinterpretq_u8_u16(
        vcgtq_s16(vreinterpretq_s16_u8(samples), vreinterpretq_s16_u8(bound)));
  if constexpr (sizeof(Sample) == 1) return vcgtq_u8(samples, bound);
  return vreinterpretq_u8_u16(
      vcgtq_u16(vreinterpretq_u16_u8(samples), vreinterpretq_u16_u8(bound)));
}

// All bits of a lane are equal: its lower byte will do.
inline Vector narrow(Vector low, Vector high) {
  return vuzp1q_u8(low, high);
}

// Every byte keeps the bit of its place among eight; sums of neighbours, three times over, bring
// the eight together.
inline uint32_t nonzero(const Vector (&bytes)[2]) {
  const Vector places = vreinterpretq_u8_u64(vdupq_n_u64(0x8040201008040201));
  Vector sums = vpaddq_u8(vandq_u8(bytes[0], places), vandq_u8(bytes[1], places));
  sums = vpaddq_u8(sums, sums);
  sums = vpaddq_u8(sums, sums);
  return vgetq_lane_u32(vreinterpretq_u32_u8(sums), 0);
}

#else

constexpr bool has_vectors = false;

// Names alone: where there are no vectors nothing calls these.
struct Vector {
  uint8_t bytes[16];
};
Vector load(const void* samples);
template <class Sample>
Vector fill(Sample sample);
template <class Sample>
Vector above(Vector samples, Vector bound);
Vector narrow(Vector low, Vector high);
uint32_t nonzero(const Vector (&bytes)[2]);

#endif

}  // namespace discmc::trace

#endif
