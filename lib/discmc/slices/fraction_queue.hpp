// A queue of the previous slice's fractions, used as contexts: along x and y, in the order of the
// stream.
#ifndef DISCMC_SLICES_FRACTION_QUEUE_HPP
#define DISCMC_SLICES_FRACTION_QUEUE_HPP

#include <discmc/base/arena.hpp>
#include <discmc/base/checks.hpp>
#include <discmc/limits.hpp>

namespace discmc::detail::slices {

/// A ring of fractions, 2 bits each. It holds the rest of the previous slice, followed by this
/// slice. A fraction without room is omitted, with the rest of its slice.
class FractionQueue {
 public:
  /// A surface crosses a slice in curves, so the number of edges grows with the slice's extents.
  static constexpr uint32_t capacity(const Limits& limits) {
    return 8 * (limits.width + limits.height);
  }
  static constexpr uint64_t bytes_for(const Limits& limits) {
    return Arena::bytes_of(capacity(limits) / per_byte, sizeof(uint8_t));
  }
  /// Allocates bytes_for() in the arena, and writes nothing.
  void start(Arena& arena, const Limits& limits, uint32_t levels) {
    capacity_ = capacity(limits);
    lowest_bit_ = levels == 4 ? 1 : 0;
    fractions_ = arena.allocate<uint8_t>(capacity_ / per_byte);
  }
  /// Call it before the first row.
  void clear() {
    for (uint32_t i = 0; i < capacity_ / per_byte; ++i) fractions_[i] = 0;
    last_ = 0;
    begin();
  }
  /// Begins a key slice, which ignores the previous slice.
  void begin() {
    first_ = last_;
    count_before_ = count_ = 0;
    is_full_ = false;
  }
  /// Ends a slice. Limit: all fractions of the previous slice were removed.
  void next_slice() {
    DISCMC_LIMIT(count_before_ == 0);
    count_before_ = count_;
    count_ = 0;
    is_full_ = false;
  }

  bool has_next() const { return count_before_ > 0; }
  /// Removes the next fraction of the previous slice, or returns 0 if it was omitted.
  uint32_t pop() {
    if (count_before_ == 0) return 0;
    --count_before_;
    const uint32_t fraction = fractions_[first_ / per_byte] >> first_ % per_byte * 2 & 3;
    first_ = after(first_);
    return 2 * fraction + lowest_bit_;
  }
  /// Appends a fraction of this slice.
  DISCMC_ALWAYS_INLINE void push(uint32_t fraction) {
    if (count_before_ + count_ == capacity_) is_full_ = true;
    if (is_full_) return;
    ++count_;
    const uint32_t shift = last_ % per_byte * 2;
    uint8_t& byte = fractions_[last_ / per_byte];
    byte = static_cast<uint8_t>((byte & ~(3U << shift)) | fraction / 2 << shift);
    last_ = after(last_);
  }

 private:
  static constexpr uint32_t per_byte = 4;
  uint32_t after(uint32_t index) const { return index + 1 < capacity_ ? index + 1 : 0; }

  uint8_t* fractions_ = nullptr;
  uint32_t capacity_ = 0;
  uint32_t first_ = 0;         // next to remove
  uint32_t last_ = 0;          // next to append
  uint32_t count_before_ = 0;  // number left of the previous slice
  uint32_t count_ = 0;         // number of this slice
  bool is_full_ = false;
  uint8_t lowest_bit_ = 0;  // of each fraction
};

}  // namespace discmc::detail::slices

#endif
