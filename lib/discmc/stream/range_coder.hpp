// A binary range coder in 32-bit integers.
// Fixed probabilities are in 256ths: with p of 1 to 255, a bit is 1 with probability p / 256.
// Learnt probabilities are in 65,536ths. G. N. N. Martin, "Range encoding: an algorithm for
// removing redundancy from a digitised message", 1979.
#ifndef DISCMC_STREAM_RANGE_CODER_HPP
#define DISCMC_STREAM_RANGE_CODER_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/compiler.hpp>

namespace discmc {

using Probability = uint8_t;

/// A learnt probability. Units: 65,536ths, between 15 and 65,520.
class LearntProbability {
 public:
  /// Limit: 15 to 65,520.
  explicit constexpr LearntProbability(uint16_t one) : one_(one) {}
  constexpr uint32_t of_one() const { return one_; }
  /// Adapts to a bit: by a 16th of the way to its certainty.
  constexpr void learn(bool bit) {
    constexpr int rate = 4;
    one_ =
        static_cast<uint16_t>(bit ? one_ + ((UINT16_MAX - one_) >> rate) : one_ - (one_ >> rate));
  }

 private:
  uint16_t one_;
};

/// Writes bits into a fixed buffer. A copy is a snapshot: assigning it back undoes all bits since,
/// because written bytes never change. Limit: at most 65,535 bytes. Owner: the caller, of the
/// buffer.
class RangeEncoder {
 public:
  RangeEncoder() = default;
  RangeEncoder(uint8_t* buffer, size_t capacity)
      : first_held_(0xFF),
        capacity_(static_cast<uint16_t>(capacity)),
        buffer_(buffer),
        range_(UINT32_MAX) {}

  void encode(bool bit, Probability one) {
    narrow(bit, (range_ >> 8) * one);
    if (range_ < min_range)
      shift();  // one shift suffices, because a probability is at least a 256th
  }
  void encode(bool bit, LearntProbability one) {
    narrow(bit, (range_ >> 16) * one.of_one());
    while (range_ < min_range) shift();
  }

  /// Encodes a symbol of this frequency. below: the sum of the frequencies of all lower symbols.
  /// Units: 256ths. Limit: frequency 1 to 255.
  void encode_symbol(uint32_t below, uint32_t frequency) {
    const uint32_t unit = range_ >> 8;
    add(unit * below);
    range_ = unit * frequency;
    if (range_ < min_range) shift();
  }
  /// Encodes the lower bits of a value, all values equally likely. Limit: at most 8 bits.
  void encode_raw_bits(uint32_t bits, uint32_t value) {
    range_ >>= bits;
    add(range_ * (value & ((uint32_t{1} << bits) - 1)));
    if (range_ < min_range) shift();
  }

  /// Whether no bit was encoded: every bit narrows the range.
  bool is_empty() const { return range_ == UINT32_MAX; }

  /// Continues in another buffer, which contains the same bytes.
  void move_to(uint8_t* buffer) { buffer_ = buffer; }

  /// Whether this many more bytes fit, with the held-back bytes.
  bool has_room(size_t bytes) const { return size_t{count_} + held_ + bytes <= capacity_; }
  /// The number of bytes that no carry can change.
  size_t final_bytes() const { return count_; }
  /// Continues in another buffer after the final bytes. Returns their number.
  size_t continue_in(uint8_t* buffer, size_t capacity) {
    const size_t final_count = count_;
    count_ = 0;
    buffer_ = buffer;
    capacity_ = static_cast<uint16_t>(capacity);
    return final_count;
  }

  /// The number of bytes after finish(). More than the capacity means that bits were lost.
  size_t size() const { return size_t{count_} + held_ + (needs_closing_byte() ? 1 : 0); }
  bool fits() const { return size() <= capacity_; }

  /// Ends the code with as few bytes as identify it; later bytes read as zero. Returns the length.
  /// Limit: fits().
  size_t finish() {
    if (needs_closing_byte()) {
      add(0x00FFFFFF);
      shift();
    } else {
      add(0 - low_);
    }
    low_ = 0;
    shift();
    return count_;
  }

 private:
  static constexpr uint32_t min_range = uint32_t{1} << 24;

  // Whether the range contains no multiple of 2^32, which would need no further byte. It always
  // contains a multiple of 2^24.
  bool needs_closing_byte() const { return 0 - low_ >= range_; }

  DISCMC_ALWAYS_INLINE void narrow(bool bit, uint32_t bound) {
    if (bit) {
      range_ = bound;
    } else {
      add(bound);
      range_ -= bound;
    }
  }

  void add(uint32_t value) {
    low_ += value;
    carry_ = static_cast<uint8_t>(carry_ + (low_ < value ? 1 : 0));
  }

  // Holds the top byte and any bytes 255 after it, because a carry may still pass through them.
  // They are written when no carry can come, or when it has come.
  DISCMC_NOINLINE void shift() {
    if (carry_ != 0 || low_ < 0xFF000000U) {
      for (; held_ > 0; --held_) {
        if (count_ < capacity_) buffer_[count_] = static_cast<uint8_t>(first_held_ + carry_);
        ++count_;
        first_held_ = 0xFF;
      }
      first_held_ = static_cast<uint8_t>(low_ >> 24);
      carry_ = 0;
    }
    ++held_;
    low_ <<= 8;
    range_ <<= 8;
  }

  // The order of members avoids padding, whose random content would be in a checkpoint.
  uint8_t carry_ = 0;
  uint8_t first_held_ = 0;
  uint16_t held_ = 0;
  uint16_t count_ = 0;
  uint16_t capacity_ = 0;
  uint8_t* buffer_ = nullptr;
  uint32_t low_ = 0;
  uint32_t range_ = 0;
};

/// Reads the output of a RangeEncoder. Any bytes are safe: after the end it reads zeros. Owner: the
/// caller, of the buffer.
class RangeDecoder {
 public:
  RangeDecoder() = default;
  RangeDecoder(const uint8_t* buffer, size_t count) : buffer_(buffer), count_(count) {
    for (int i = 0; i < 4; ++i) code_ = code_ << 8 | next();
  }

  bool decode(Probability one) { return decode_below((range_ >> 8) * one); }
  bool decode(LearntProbability one) { return decode_below((range_ >> 16) * one.of_one()); }

  /// Decodes a symbol. below: the sum of the frequencies below each symbol, 0 for the first; a 0
  /// follows the last. The rest of the range, which no encoder uses, belongs to the last symbol.
  uint32_t decode_symbol(const uint8_t* below) {
    const uint32_t unit = range_ >> 8;
    uint32_t symbol = 0;
    while (below[symbol + 1] != 0 && code_ >= unit * below[symbol + 1]) ++symbol;
    code_ -= unit * below[symbol];
    range_ = unit * static_cast<uint8_t>(below[symbol + 1] - below[symbol]);
    refill();
    return symbol;
  }
  /// Decodes this many bits, all values equally likely. Limit: at most 8 bits.
  uint32_t decode_raw_bits(uint32_t bits) {
    range_ >>= bits;
    uint32_t value = 0;
    while (bits-- > 0) {
      const uint32_t half = range_ << bits;
      const bool bit = code_ >= half;
      if (bit) code_ -= half;
      value = 2 * value + (bit ? 1 : 0);
    }
    refill();
    return value;
  }

  /// Whether more bits were read than the bytes can contain: no encoder wrote them.
  bool is_exhausted() const { return position_ > count_ + 4; }

  /// The number of unread bytes.
  size_t left() const { return position_ < count_ ? count_ - position_ : 0; }
  const uint8_t* rest() const { return buffer_ + (count_ - left()); }
  /// Continues in another buffer, which begins with the rest.
  void continue_in(const uint8_t* buffer, size_t count) {
    buffer_ = buffer;
    count_ = count;
    position_ = 0;
  }

 private:
  static constexpr uint32_t min_range = uint32_t{1} << 24;

  bool decode_below(uint32_t bound) {
    const bool bit = code_ < bound;
    if (bit) {
      range_ = bound;
    } else {
      code_ -= bound;
      range_ -= bound;
    }
    refill();
    return bit;
  }

  void refill() {
    while (range_ < min_range) {
      code_ = code_ << 8 | next();
      range_ <<= 8;
    }
  }

  uint32_t next() {
    const uint32_t byte = position_ < count_ ? buffer_[position_] : 0;
    ++position_;
    return byte;
  }

  const uint8_t* buffer_ = nullptr;
  size_t count_ = 0;
  size_t position_ = 0;
  uint32_t range_ = UINT32_MAX;
  uint32_t code_ = 0;
};

}  // namespace discmc

#endif
