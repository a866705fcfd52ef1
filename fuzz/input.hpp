// The bytes of a fuzzer's input, read as numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// Numbers from the input; zeros after its end.
class Input {
 public:
  Input(const uint8_t* data, size_t size) : data_(data), size_(size) {}

  bool is_empty() const { return at_ == size_; }
  uint32_t byte() { return is_empty() ? 0 : data_[at_++]; }
  uint32_t word() {
    const uint32_t low = byte();
    return low | byte() << 8;
  }
  uint32_t below(uint32_t limit) { return byte() % limit; }
  /// Returns a number up to `most`; small ones are as frequent as large ones.
  uint32_t number(uint32_t most) {
    const uint32_t bits = byte() % 32;
    const uint32_t low = word();
    const uint32_t value = low | word() << 16;
    const uint32_t cut = value & ((uint32_t{1} << bits) - 1);
    return cut <= most ? cut : most;
  }
  /// Returns up to `most` of the remaining bytes, in a heap block of exactly their size.
  std::vector<uint8_t> bytes(size_t most) {
    const size_t left = size_ - at_;
    const uint8_t* const begin = data_ + at_;
    const size_t count = most < left ? most : left;
    at_ += count;
    return {begin, begin + count};
  }

 private:
  const uint8_t* data_;
  size_t size_;
  size_t at_ = 0;
};
