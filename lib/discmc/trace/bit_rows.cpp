#include <discmc/threshold.hpp>
#include <discmc/trace/bit_rows.hpp>

namespace discmc::trace {

namespace {

// column / 30, without a division: right for columns below 74,898.
constexpr uint32_t word_of(uint32_t column) {
  return column * 34953 >> 20;
}

static_assert(word_of(29) == 0 && word_of(30) == 1 && word_of(Limits::max_extent) == 1092 &&
                  word_of(30 * 1092) == 1092 && word_of(30 * 1092 - 1) == 1091,
              "a multiplication stands for the division");

}  // namespace

void BitRows::start(Arena& arena, const Limits& limits) {
  words_ = row_words(limits.width);
  ring_rows_ = bit_rows(limits.height) - 1;
  width_ = limits.width;
  height_ = limits.height;
  ring_ = arena.take<uint32_t>(words_ * ring_rows_);
  off_ = arena.take<uint32_t>(words_);
}

void BitRows::clear() {
  for (uint32_t i = 0; i < words_; ++i) off_[i] = 0;
  place_ = 0;
  column_ = 0;
  rows_ = 0;
  slices_ = 0;
}

// The row that arrived `back` rows ago; the one that arrives for 0.
uint32_t* BitRows::row_before(uint32_t back) const {
  const uint32_t place = place_ >= back ? place_ - back : place_ + ring_rows_ - back;
  return ring_ + size_t{place} * words_;
}

// The place of a row that arrives still holds the oldest row, in use until the sweep has caught
// up: it is wiped when the first sample comes, not before.
uint32_t* BitRows::arriving() {
  uint32_t* const words = row_before(0);
  if (column_ == 0)
    for (uint32_t i = 0; i < words_; ++i) words[i] = 0;
  return words;
}

// Turns voxels on: bit i is that of column_ + i.
void BitRows::place(uint32_t* words, uint32_t bits, uint32_t count) const {
  const uint32_t column = column_ + 1;
  const uint32_t word = word_of(column);
  const uint32_t bit = column - word * columns_per_word + 1;
  words[word] |= bits << bit & own_columns;
  const uint32_t room = columns_per_word + 1 - bit;
  if (count <= room) return;
  bits >>= room;
  words[word + 1] |= bits << 1 & own_columns;
  if (count > room + columns_per_word) words[word + 2] |= bits >> columns_per_word << 1;
}

template <class Sample>
void BitRows::append(const Sample* samples, uint32_t count, uint32_t stride, int32_t threshold) {
  if (count == 0) return;
  const Threshold<Sample> on(threshold);
  uint32_t* const words = arriving();
  while (count > 0) {
    uint32_t taken = 0;
    uint32_t bits = 0;
    if (stride == 1 && count >= on.lanes && on.reads_words(samples)) {
      taken = on.leading_off(samples, count);
      if (taken == 0) {
        taken = (count < 32 ? count : 32) / on.lanes * on.lanes;
        bits = on.words_reached(samples, taken);
      }
    } else {
      const uint32_t most = stride == 1 ? on.samples_to_word(samples) : 32;
      for (; taken < most && taken < count; ++taken)
        bits |= static_cast<uint32_t>(on.reached(samples[size_t{taken} * stride])) << taken;
    }
    if (bits != 0) place(words, bits, taken);
    column_ += taken;
    count -= taken;
    if (count > 0) samples += size_t{taken} * stride;
  }
}

template void BitRows::append(const uint8_t*, uint32_t, uint32_t, int32_t);
template void BitRows::append(const uint16_t*, uint32_t, uint32_t, int32_t);
template void BitRows::append(const int16_t*, uint32_t, uint32_t, int32_t);

void BitRows::append_bits(const uint8_t* bits) {
  uint32_t* const words = arriving();
  for (; column_ < width_; column_ += 8) {
    const uint32_t left = width_ - column_;
    const uint32_t count = left < 8 ? left : 8;
    place(words, *bits++ & ((uint32_t{1} << count) - 1), count);
    if (count < 8) break;
  }
  column_ = width_;
}

void BitRows::repeat() {
  const bool first_of_all = rows_ == 0 && slices_ == 0;
  const uint32_t* const before = first_of_all ? off_ : row_before(1);
  uint32_t* const words = arriving();
  for (uint32_t i = 0; i < words_; ++i) words[i] = before[i];
  column_ = width_;
}

void BitRows::fill_off() {
  arriving();
  column_ = width_;
}

void BitRows::next_row() {
  constexpr uint32_t lowest = 1, first = 2, last = uint32_t{1} << columns_per_word,
                     highest = uint32_t{1} << 31;
  uint32_t* const words = row_before(0);
  for (uint32_t i = 0; i + 1 < words_; ++i) {
    if ((words[i + 1] & first) != 0) words[i] |= highest;
    if ((words[i] & last) != 0) words[i + 1] |= lowest;
  }
  if (++place_ == ring_rows_) place_ = 0;
  ++rows_;
  column_ = 0;
}

void BitRows::next_slice() {
  rows_ = 0;
  ++slices_;
}

RowBlock BitRows::around(int32_t y) const {
  RowBlock block;
  for (uint32_t k = 0; k < 3; ++k) {
    const uint32_t slice = slices_ + k;  // two more than its number
    const bool is_there = slice >= 2;
    const uint32_t rows = k == 2 ? rows_ : height_;
    for (uint32_t j = 0; j < 3; ++j) {
      // Beyond the height for a row before the first.
      const uint32_t at = static_cast<uint32_t>(y) + j - 1;
      const bool is_row = is_there && at < rows;
      block.row[k][j] = is_row ? row_before((2 - k) * height_ + rows_ - at) : off_;
    }
  }
  return block;
}

}  // namespace discmc::trace
