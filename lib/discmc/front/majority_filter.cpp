#include <discmc/front/majority_filter.hpp>

namespace discmc {
namespace {

// Adds a two-bit number to a five-bit number, in 32 lanes of one bit.
void add(uint32_t (&sum)[5], uint32_t ones, uint32_t twos) {
  uint32_t carry = sum[0] & ones;
  sum[0] ^= ones;
  const uint32_t either = twos ^ carry;
  carry = (twos & carry) | (sum[1] & either);
  sum[1] ^= either;
  for (uint32_t digit = 2; digit < 5; ++digit) {
    const uint32_t next = sum[digit] & carry;
    sum[digit] ^= carry;
    carry = next;
  }
}

}  // namespace

Status MajorityFilter::start(const Limits& limits, Memory memory) {
  rows_ = nullptr;
  if (!limits.is_valid()) return Status::bad_limits;
  Arena arena(memory);
  const uint32_t words = words_of(limits.width);
  uint32_t* const rows = arena.allocate<uint32_t>(words * rows_held(limits));
  uint8_t* const due = arena.allocate<uint8_t>(4 * words);
  if (arena.is_exhausted()) return Status::too_little_memory;
  limits_ = limits;
  rows_ = rows;
  due_ = due;
  push_index_ = 0;
  due_index_ = 0;
  due_y_ = 0;
  is_first_slice_ = true;
  waiting_ = 0;
  return Status::ok;
}

const uint8_t* MajorityFilter::push(const uint8_t* bits) {
  const uint32_t words = words_of(limits_.width);
  uint32_t* const row = rows_ + size_t{push_index_} * words;
  for (uint32_t word = 0; word < words; ++word) row[word] = 0;
  for (uint32_t byte = 0; byte < (limits_.width + 7) / 8; ++byte)
    row[byte / 4] |= uint32_t{bits[byte]} << 8 * (byte % 4);
  // The last voxel continues beyond the side.
  const uint32_t used = limits_.width % 32;
  if (used != 0) {
    const uint32_t mask = (uint32_t{1} << used) - 1;
    const bool is_on = (row[words - 1] >> (used - 1) & 1) != 0;
    row[words - 1] = is_on ? row[words - 1] | ~mask : row[words - 1] & mask;
  }
  push_index_ = push_index_ + 1 == rows_held(limits_) ? 0 : push_index_ + 1;
  ++waiting_;
  return waiting_ > limits_.height + 1 ? next_row(false) : nullptr;
}

const uint8_t* MajorityFilter::drain() {
  if (waiting_ == 0) return nullptr;
  // If a row of the slice below waits, its neighbour above has arrived.
  return next_row(waiting_ <= limits_.height);
}

const uint32_t* MajorityFilter::held(int32_t y, int32_t z) const {
  const auto rows = static_cast<int32_t>(rows_held(limits_));
  int32_t index = static_cast<int32_t>(due_index_) + y + z * static_cast<int32_t>(limits_.height);
  if (index >= rows) index -= rows;
  if (index < 0) index += rows;
  return rows_ + static_cast<size_t>(index) * words_of(limits_.width);
}

// Filters the due row, and makes the next one due.
const uint8_t* MajorityFilter::next_row(bool is_last_slice) {
  const int32_t layers[] = {is_first_slice_ ? 0 : -1, 0, is_last_slice ? 0 : 1};
  const int32_t lines[] = {due_y_ == 0 ? 0 : -1, 0, due_y_ + 1 == limits_.height ? 0 : 1};
  const uint32_t* rows[9];
  uint32_t count = 0;
  for (const int32_t z : layers)
    for (const int32_t y : lines) rows[count++] = held(y, z);
  for (uint32_t word = 0; word < words_of(limits_.width); ++word) {
    const uint32_t bits = majority_at(rows, word);
    for (uint32_t byte = 0; byte < 4; ++byte)
      due_[4 * word + byte] = static_cast<uint8_t>(bits >> 8 * byte);
  }
  --waiting_;
  due_index_ = due_index_ + 1 == rows_held(limits_) ? 0 : due_index_ + 1;
  if (++due_y_ == limits_.height) {
    due_y_ = 0;
    is_first_slice_ = false;
  }
  return due_;
}

uint32_t MajorityFilter::majority_at(const uint32_t* const (&rows)[9], uint32_t word) const {
  const uint32_t words = words_of(limits_.width);
  uint32_t sum[5] = {};
  for (const uint32_t* row : rows) {
    const uint32_t here = row[word];
    const uint32_t before = word > 0 ? row[word - 1] >> 31 : here & 1;
    const uint32_t behind = word + 1 < words ? row[word + 1] & 1 : here >> 31;
    const uint32_t left = here << 1 | before;
    const uint32_t right = here >> 1 | behind << 31;
    add(sum, left ^ here ^ right, (left & here) | (left & right) | (here & right));
  }
  // At least 14 of 27.
  const uint32_t majority = sum[4] | (sum[3] & sum[2] & sum[1]);
  const uint32_t used = limits_.width - 32 * word;
  return used < 32 ? majority & ((uint32_t{1} << used) - 1) : majority;
}

}  // namespace discmc
