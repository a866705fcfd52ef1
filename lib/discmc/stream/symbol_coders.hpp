// The coders of a packet's symbols (record_model.hpp): a writer and a reader.
#ifndef DISCMC_STREAM_SYMBOL_CODERS_HPP
#define DISCMC_STREAM_SYMBOL_CODERS_HPP

#include <discmc/stream/range_coder.hpp>
#include <discmc/stream/record_model.hpp>

namespace discmc::detail::stream {

struct SymbolWriter {
  static constexpr bool writes = true;
  RangeEncoder range;

  uint32_t symbol(uint32_t context, uint32_t symbol) {
    encode(context + symbol);
    return symbol;
  }
  uint32_t raw_bits(uint32_t bits, uint32_t value) {
    range.encode_raw_bits(bits, value);
    return value;
  }

 private:
  void encode(uint32_t index) {
    const uint8_t* const below = cumulative_frequencies + index;
    range.encode_symbol(below[0], static_cast<uint8_t>(below[1] - below[0]));
  }
};

struct SymbolReader {
  static constexpr bool writes = false;
  RangeDecoder range;

  uint32_t symbol(uint32_t context, uint32_t) {
    return range.decode_symbol(cumulative_frequencies + context);
  }
  uint32_t raw_bits(uint32_t bits, uint32_t) { return range.decode_raw_bits(bits); }
};

}  // namespace discmc::detail::stream

#endif
