// A bump arena over the caller's memory.
#ifndef DISCMC_BASE_ARENA_HPP
#define DISCMC_BASE_ARENA_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/checks.hpp>
#include <discmc/memory.hpp>

namespace discmc {

/// Allocates consecutive arrays of trivial types from one piece of memory and frees none of them.
/// Every array is aligned to four bytes, which suffices for all objects of the library. The arena
/// always subtracts three bytes for alignment. So the capacity is the same at every address.
class Arena {
 public:
  static constexpr size_t alignment = 4;

  /// The bytes that an array of `count` items of `item_bytes` occupies.
  static constexpr uint64_t bytes_of(uint32_t count, uint32_t item_bytes) {
    return aligned(uint64_t{count} * item_bytes) + red_zone_bytes;
  }
  static constexpr uint64_t aligned(uint64_t bytes) {
    return (bytes + alignment - 1) / alignment * alignment;
  }

  explicit Arena(Memory memory)
      : next_(static_cast<uint8_t*>(memory.data)),
        left_(memory.bytes),
        is_exhausted_(memory.data == nullptr || memory.bytes < alignment - 1) {
    if (is_exhausted_) return;
    next_ += (alignment - reinterpret_cast<uintptr_t>(next_) % alignment) % alignment;
    left_ -= alignment - 1;
  }

  /// Returns the next array, uninitialized, or null if the array does not fit. After a null, every
  /// call returns null.
  template <class T>
  T* allocate(uint32_t count) {
    constexpr size_t max_bytes = SIZE_MAX - alignment - red_zone_bytes;
    constexpr size_t max_count = max_bytes / sizeof(T);
    return static_cast<T*>(allocate_bytes(count <= max_count ? count * sizeof(T) : max_bytes));
  }

  /// Returns the number of bytes left for further arrays.
  size_t left() const { return left_; }
  /// Whether an array did not fit.
  bool is_exhausted() const { return is_exhausted_; }

 private:
  void* allocate_bytes(size_t bytes) {
    bytes = (bytes + alignment - 1) / alignment * alignment;
    const size_t with_zone = bytes + red_zone_bytes;
    if (with_zone > left_) is_exhausted_ = true;
    if (is_exhausted_) return nullptr;
    uint8_t* const allocation = next_;
    left_ -= with_zone;
    next_ += with_zone;
    unpoison(allocation, bytes);
    poison(allocation + bytes, red_zone_bytes);
    return allocation;
  }

  uint8_t* next_;
  size_t left_;
  bool is_exhausted_;
};

}  // namespace discmc

#endif
