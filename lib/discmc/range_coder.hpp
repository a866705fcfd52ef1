// A binary range coder in 32-bit integers.
//
// Probabilities are fixed eighths of a byte: p of 1 to 255 says that a bit is 1 with p / 256.
// G. N. N. Martin, "Range encoding: an algorithm for removing redundancy from a digitised message",
// 1979.
#ifndef DISCMC_RANGE_CODER_HPP
#define DISCMC_RANGE_CODER_HPP

#include <stddef.h>
#include <stdint.h>

namespace discmc {

using Probability = uint8_t;

/// Writes bits into a fixed buffer. A copy is a snapshot: to go back to it undoes all bits since,
/// as bytes once written are never changed. Owner: the buffer is the caller's.
class RangeEncoder {
 public:
  RangeEncoder() = default;
  RangeEncoder(uint8_t* buffer, size_t capacity)
      : range_(UINT32_MAX), buffer_(buffer), capacity_(capacity) {}

  void encode(bool bit, Probability one) {
    const uint32_t bound = (range_ >> 8) * one;
    if (bit) {
      range_ = bound;
    } else {
      const uint32_t before = low_;
      low_ += bound;
      carry_ = carry_ || low_ < before;
      range_ -= bound;
    }
    while (range_ < min_range) {
      shift();
      range_ <<= 8;
    }
  }

  /// The bytes that finish() would come to. More than the capacity means that bits were lost.
  size_t size() const { return count_ + pending_ + (has_cache_ ? 1 : 0) + closing_bytes(); }
  bool fits() const { return size() <= capacity_; }

  /// Ends the code with as few bytes as identify it; bytes beyond read as zero. Returns the length.
  /// Limit: fits().
  size_t finish() {
    const size_t closing = closing_bytes();
    const uint32_t value = rounded_up(low_, closing);
    carry_ = carry_ || value < low_;
    low_ = value;
    for (size_t i = 0; i <= closing; ++i) shift();
    return count_;
  }

 private:
  static constexpr uint32_t min_range = uint32_t{1} << 24;

  // The first value at or above `low` of which only the upper `bytes` bytes are not zero.
  static uint32_t rounded_up(uint32_t low, size_t bytes) {
    const uint32_t mask = bytes < 4 ? UINT32_MAX >> 8 * bytes : 0;
    return (low + mask) & ~mask;
  }

  size_t closing_bytes() const {
    size_t bytes = 0;
    while (rounded_up(low_, bytes) - low_ >= range_) ++bytes;
    return bytes;
  }

  void put(uint32_t byte) {
    if (count_ < capacity_) buffer_[count_] = static_cast<uint8_t>(byte);
    ++count_;
  }

  // The top byte leaves, unless a carry may still come through it.
  void shift() {
    if (carry_ || low_ < 0xFF000000U) {
      const uint32_t carry = carry_ ? 1 : 0;
      if (has_cache_) put(cache_ + carry);
      for (; pending_ > 0; --pending_) put(0xFF + carry);
      cache_ = static_cast<uint8_t>(low_ >> 24);
      has_cache_ = true;
      carry_ = false;
    } else {
      ++pending_;
    }
    low_ <<= 8;
  }

  bool has_cache_ = false;
  bool carry_ = false;
  uint8_t cache_ = 0;
  uint32_t low_ = 0;
  uint32_t range_ = 0;
  uint32_t pending_ = 0;
  uint8_t* buffer_ = nullptr;
  size_t capacity_ = 0;
  size_t count_ = 0;
};

/// Reads what a RangeEncoder wrote. Any bytes are safe: beyond the end zeros are read.
/// Owner: the buffer is the caller's.
class RangeDecoder {
 public:
  RangeDecoder() = default;
  RangeDecoder(const uint8_t* buffer, size_t count) : buffer_(buffer), count_(count) {
    for (int i = 0; i < 4; ++i) code_ = code_ << 8 | next();
  }

  bool decode(Probability one) {
    const uint32_t bound = (range_ >> 8) * one;
    const bool bit = code_ < bound;
    if (bit) {
      range_ = bound;
    } else {
      code_ -= bound;
      range_ -= bound;
    }
    while (range_ < min_range) {
      code_ = code_ << 8 | next();
      range_ <<= 8;
    }
    return bit;
  }

  /// Whether more bits were read than the bytes can have held: they were not written by an encoder.
  bool is_exhausted() const { return position_ > count_ + 4; }

 private:
  static constexpr uint32_t min_range = uint32_t{1} << 24;

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
