#include <discmc/slice.hpp>
#include <discmc/threshold.hpp>

namespace discmc {

void BitRows::start(Arena& arena, const Limits& limits) {
  words_ = limits.row_words();
  ring_rows_ = limits.height + 2;
  width_ = limits.width;
  height_ = limits.height;
  halo_ = limits.halo();
  ring_ = arena.take<uint32_t>(words_ * ring_rows_);
  off_ = arena.take<uint32_t>(words_);
}

void BitRows::clear() {
  for (uint32_t i = 0; i < words_; ++i) off_[i] = 0;
  old_start_ = 0;
  new_start_ = 0;
  rows_ = 0;
  slices_ = 0;
  column_ = 0;
}

// The place of a row that arrives still holds a row of the old slice, in use until the sweep has
// caught up: it is wiped when the first sample comes, not before.
uint32_t* BitRows::arriving() {
  uint32_t* const words = row(new_start_, rows_);
  if (column_ == 0)
    for (uint32_t i = 0; i < words_; ++i) words[i] = 0;
  return words;
}

// Turns voxels on: bit i is that of column() + i.
void BitRows::place(uint32_t* words, uint32_t bits) const {
  const uint32_t bit = column_ + halo_;
  words[bit / 32] |= bits << bit % 32;
  const uint32_t beyond = bits >> 1 >> (31 - bit % 32);
  if (beyond != 0) words[bit / 32 + 1] |= beyond;
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
    if (bits != 0) place(words, bits);
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
  for (; column_ + 8 <= width_; column_ += 8) place(words, *bits++);
  if (column_ < width_) place(words, *bits & ((uint32_t{1} << (width_ - column_)) - 1));
  column_ = width_;
}

void BitRows::repeat() {
  const bool first_of_all = rows_ == 0 && slices_ == 0;
  const uint32_t* before = first_of_all ? off_
                           : rows_ > 0  ? row(new_start_, rows_ - 1)
                                        : row(old_start_, height_ - 1);
  uint32_t* const words = arriving();
  for (uint32_t i = 0; i < words_; ++i) words[i] = before[i];
  column_ = width_;
}

void BitRows::fill_off() {
  arriving();
  column_ = width_;
}

void BitRows::next_row() {
  ++rows_;
  column_ = 0;
}

void BitRows::next_slice() {
  old_start_ = new_start_;
  new_start_ += height_;
  if (new_start_ >= ring_rows_) new_start_ -= ring_rows_;
  rows_ = 0;
  ++slices_;
}

RowQuad BitRows::around(int32_t y) const {
  RowQuad quad;
  const uint32_t old_rows = slices_ > 0 ? height_ : 0;
  for (uint32_t i = 0; i < 2; ++i) {
    // Beyond the height for a row before the first.
    const uint32_t at = static_cast<uint32_t>(y) + i;
    quad.row[i] = at < old_rows ? row(old_start_, at) : off_;
    quad.row[i + 2] = at < rows_ ? row(new_start_, at) : off_;
  }
  return quad;
}

}  // namespace discmc
