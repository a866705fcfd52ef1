// The coders of a packet's symbols (record_model.hpp): a writer and a reader.
#ifndef DISCMC_STREAM_SYMBOL_CODERS_HPP
#define DISCMC_STREAM_SYMBOL_CODERS_HPP

#include <discmc/stream/range_coder.hpp>
#include <discmc/stream/record_model.hpp>

namespace discmc::detail::stream {

struct SymbolWriter {
  static constexpr bool writes = true;
  RangeEncoder range;

  uint32_t symbol(uint32_t row, uint32_t symbol) {
    encode(row + symbol);
    return symbol;
  }
  uint32_t even(uint32_t bits, uint32_t value) {
    range.encode_even(bits, value);
    return value;
  }

 private:
  void encode(uint32_t place) {
    range.encode_share(shares[place], static_cast<uint8_t>(shares[place + 1] - shares[place]));
  }
};

struct SymbolReader {
  static constexpr bool writes = false;
  RangeDecoder range;

  uint32_t symbol(uint32_t row, uint32_t) { return range.decode_share(shares + row); }
  uint32_t even(uint32_t bits, uint32_t) { return range.decode_even(bits); }
};

}  // namespace discmc::detail::stream

#endif
