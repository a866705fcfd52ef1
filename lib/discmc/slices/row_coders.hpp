// The coders of a row (row_code.hpp): one writes its bits, the other reads them.
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
  /// Writes this many even bits, the highest first.
  uint32_t number(uint32_t bits, uint32_t value) {
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
  uint32_t number(uint32_t bits, uint32_t) {
    uint32_t value = 0;
    for (; bits > 0; --bits) value = value << 1 | (range.decode(Probability{128}) ? 1 : 0);
    return value;
  }
};

}  // namespace discmc::detail::slices

#endif
