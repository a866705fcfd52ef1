// The coders of a row (row_code.hpp): a writer and a reader of its bits.
#ifndef DISCMC_SLICES_ROW_CODERS_HPP
#define DISCMC_SLICES_ROW_CODERS_HPP

#include <discmc/stream/range_coder.hpp>

namespace discmc::detail::slices {

struct RowWriter {
  RangeEncoder range;

  template <class AnyProbability>
  bool code_bit(AnyProbability& probability, bool bit) {
    range.encode(bit, LearntProbability(probability));
    probability.learn(bit);
    return bit;
  }
  /// Writes this many bits, the highest first. The first bit has the first probability of the tree.
  /// The second bit has the second probability after a 0, the third after a 1. Limit: 1 or 2 bits.
  template <class AnyProbability>
  DISCMC_FLATTEN uint32_t tree(AnyProbability* tree, uint32_t bits, uint32_t value) {
    AnyProbability* node = tree;
    do {
      --bits;
      node = tree + (code_bit(*node, (value >> bits & 1) != 0) ? 2 : 1);
    } while (bits > 0);
    return value;
  }
  /// Writes this many raw bits, the highest first: all values are equally likely.
  uint32_t raw_bits(uint32_t bits, uint32_t value) {
    while (bits > 0) range.encode((value >> --bits & 1) != 0, Probability{128});
    return value;
  }
};

struct RowReader {
  RangeDecoder range;

  template <class AnyProbability>
  bool code_bit(AnyProbability& probability, bool) {
    const bool bit = range.decode(LearntProbability(probability));
    probability.learn(bit);
    return bit;
  }
  template <class AnyProbability>
  uint32_t tree(AnyProbability* tree, uint32_t bits, uint32_t) {
    AnyProbability* node = tree;
    uint32_t value = 0;
    do {
      --bits;
      const bool bit = code_bit(*node, false);
      value = 2 * value + (bit ? 1 : 0);
      node = tree + (bit ? 2 : 1);
    } while (bits > 0);
    return value;
  }
  uint32_t raw_bits(uint32_t bits, uint32_t) {
    uint32_t value = 0;
    for (; bits > 0; --bits) value = value << 1 | (range.decode(Probability{128}) ? 1 : 0);
    return value;
  }
};

}  // namespace discmc::detail::slices

#endif
