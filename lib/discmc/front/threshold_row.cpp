#include <discmc/front/threshold_row.hpp>
#include <discmc/trace/threshold.hpp>

#include <stddef.h>

namespace discmc {
namespace {

constexpr uint32_t word_bits = 32;

// Writes the bits of up to 32 samples, and advances the pointer.
uint8_t* write_word(uint32_t word, uint32_t count, uint8_t* bits) {
  for (uint32_t bit = 0; bit < count; bit += 8) *bits++ = static_cast<uint8_t>(word >> bit);
  return bits;
}

// Returns the bits of up to 32 samples.
template <class Sample>
uint32_t word_of(const detail::trace::Threshold<Sample>& on, const Sample* samples, uint32_t count,
                 uint32_t stride) {
  uint32_t word = 0, compared = 0;
  if (stride == 1 && on.reads_words(samples)) {
    compared = count / on.lanes * on.lanes;
    word = on.words_reached(samples, compared);
  }
  for (; compared < count; ++compared)
    word |= static_cast<uint32_t>(on.reached(samples[size_t{compared} * stride])) << compared;
  return word;
}

}  // namespace

template <class Sample>
void threshold_row(const Sample* samples, uint32_t count, int32_t threshold, uint8_t* bits,
                   uint32_t stride) {
  const detail::trace::Threshold<Sample> on(threshold);
  const bool reads_words = stride == 1 && on.reads_words(samples);
  // If the last samples were on, the next ones are unlikely to be all off.
  bool may_be_off = true;
  while (count > 0) {
    uint32_t off = may_be_off && reads_words ? on.leading_off(samples, count) / word_bits : 0;
    uint32_t written = off * word_bits;
    for (; off > 0; --off) bits = write_word(0, word_bits, bits);
    if (written == 0) {
      written = count < word_bits ? count : word_bits;
      const uint32_t word = word_of(on, samples, written, stride);
      may_be_off = word == 0;
      bits = write_word(word, written, bits);
    }
    count -= written;
    if (count > 0) samples += size_t{written} * stride;
  }
}

template <class Sample>
void threshold_row_less(const Sample* samples, const int16_t* offsets, uint32_t count,
                        int32_t threshold, uint8_t* bits) {
  while (count > 0) {
    const uint32_t written = count < word_bits ? count : word_bits;
    uint32_t word = 0;
    for (uint32_t i = 0; i < written; ++i)
      word |= static_cast<uint32_t>(*samples++ - *offsets++ >= threshold) << i;
    bits = write_word(word, written, bits);
    count -= written;
  }
}

template void threshold_row(const uint8_t*, uint32_t, int32_t, uint8_t*, uint32_t);
template void threshold_row(const uint16_t*, uint32_t, int32_t, uint8_t*, uint32_t);
template void threshold_row(const int16_t*, uint32_t, int32_t, uint8_t*, uint32_t);
template void threshold_row_less(const uint8_t*, const int16_t*, uint32_t, int32_t, uint8_t*);
template void threshold_row_less(const uint16_t*, const int16_t*, uint32_t, int32_t, uint8_t*);
template void threshold_row_less(const int16_t*, const int16_t*, uint32_t, int32_t, uint8_t*);

}  // namespace discmc
