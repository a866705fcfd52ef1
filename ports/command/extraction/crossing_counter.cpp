#include "crossing_counter.hpp"

#include <algorithm>
#include <bitset>
#include <utility>

#include "selection.hpp"

namespace discmc::command {
namespace {

std::uint64_t ones(std::uint64_t word) {
  return std::bitset<64>(word).count();
}

// Up to eight bytes, the first one lowest.
std::uint64_t word_of(const std::uint8_t* bytes, std::size_t count) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < count; ++i) word |= std::uint64_t{bytes[i]} << 8 * i;
  return word;
}

std::uint64_t differences(const std::uint8_t* a, const std::uint8_t* b, std::size_t bytes) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < bytes; i += 8) {
    const std::size_t taken = std::min<std::size_t>(8, bytes - i);
    count += ones(word_of(a + i, taken) ^ word_of(b + i, taken));
  }
  return count;
}

}  // namespace

CrossingCounter::CrossingCounter(const Limits& limits)
    : width_(limits.width),
      height_(limits.height),
      is_closed_(limits.border == Border::closed),
      is_context_(limits.slab.continues_below),
      continues_above_(limits.slab.continues_above),
      off_(bit_row_bytes(width_), 0),
      rows_(off_.size() * height_, 0),
      has_below_(is_closed_ && !is_context_) {}

std::uint64_t CrossingCounter::changes_along(const std::uint8_t* row) const {
  std::uint64_t count = 0;
  std::uint64_t last = 0;  // of the word before
  for (std::size_t i = 0; i < off_.size(); i += 8) {
    const std::uint64_t word = word_of(row + i, std::min<std::size_t>(8, off_.size() - i));
    count += ones(word ^ (word << 1 | last));
    last = word >> 63;
  }
  count += last;
  if (is_closed_) return count;
  const std::uint32_t end = width_ - 1;
  return count - (row[0] & 1U) - (row[end / 8] >> end % 8 & 1U);
}

void CrossingCounter::add_row(const std::uint8_t* bits) {
  const std::size_t bytes = off_.size();
  std::uint8_t* const below = rows_.data() + y_ * bytes;
  count_ += changes_along(bits);
  if (y_ > 0) count_ += differences(bits, below - bytes, bytes);
  if (y_ == 0 && is_closed_) count_ += differences(bits, off_.data(), bytes);
  if (has_below_) count_ += differences(bits, below, bytes);
  std::copy(bits, bits + bytes, below);
  if (++y_ < height_) return;
  if (is_closed_) count_ += differences(bits, off_.data(), bytes);
  end_slice();
}

void CrossingCounter::end_slice() {
  if (is_context_) count_ = 0;
  count_before_slice_ = std::exchange(count_at_slice_, count_);
  is_context_ = false;
  has_below_ = true;
  y_ = 0;
}

std::uint64_t CrossingCounter::count() const {
  if (continues_above_) return count_before_slice_;
  if (!is_closed_) return count_;
  std::uint64_t count = count_;
  for (std::size_t y = 0; y < height_; ++y)
    count += differences(rows_.data() + y * off_.size(), off_.data(), off_.size());
  return count;
}

}  // namespace discmc::command
