#include <discmc/trace/bit_rows.hpp>
#include <discmc/trace/threshold.hpp>

namespace discmc::detail::trace {

namespace {

static_assert(word_of(29) == 0 && word_of(30) == 1 && word_of(Limits::max_extent) == 1092 &&
                  word_of(30 * 1092) == 1092 && word_of(30 * 1092 - 1) == 1091,
              "a multiplication replaces the division");

static_assert(bit_row_bytes(Limits::max_extent, swept_rows(Limits::max_extent)) <= UINT32_MAX,
              "32 bits count the words of a ring");

// The number of bits that can be placed at once, in two words at most.
constexpr uint32_t max_placed = 28;

// Returns eight bytes, the first in the lowest bits. Limit: is_little_endian.
uint64_t eight_bytes(const uint8_t* bytes) {
  uint64_t word;
  copy_bytes(&word, bytes, sizeof word);
  return word;
}

}  // namespace

void BitRows::start(Arena& arena, const Limits& limits, uint32_t rows) {
  words_ = row_words(limits.width);
  ring_rows_ = rows;
  width_ = limits.width;
  height_ = limits.height;
  ring_ = arena.allocate<uint32_t>(words_ * (rows + 1));
}

void BitRows::clear() {
  uint32_t* const off = row_off();
  for (uint32_t i = 0; i < words_; ++i) off[i] = 0;
  row_index_ = 0;
  column_ = 0;
  rows_ = 0;
  slices_ = 0;
}

// Returns the row that arrived `back` rows ago; the arriving row for 0.
uint32_t* BitRows::row_before(uint32_t back) const {
  const uint32_t index = row_index_ >= back ? row_index_ - back : row_index_ + ring_rows_ - back;
  return ring_ + size_t{index} * words_;
}

// Until the sweep no longer needs the oldest row, its bits are at the index of the arriving row.
// Therefore the first sample clears these bits, not an earlier call.
uint32_t* BitRows::arriving() {
  uint32_t* const words = row_before(0);
  const uint32_t* const end = words + words_;
  if (column_ == 0)
    for (uint32_t* word = words; word != end; ++word) *word = 0;
  return words;
}

// Turns on voxels of the row; bit i belongs to column_ + i. A word begins with a copy of the
// previous word's last column, so two words overlap in two columns. Limit: bits < 2^28.
void BitRows::turn_on(uint32_t* words, uint32_t bits) const {
  words[0] |= on_mark;
  const uint32_t word = word_of(column_);
  const uint32_t bit = column_ - word * columns_per_word + 2;  // 2 to 31
  words[word] |= bits << bit;
  const uint32_t beyond = bits << 1 >> (31 - bit);
  if (beyond != 0 && word + 1 < words_) words[word + 1] |= beyond;
}

template <class Sample>
void BitRows::append(const Sample* samples, uint32_t count, uint32_t stride, int32_t threshold) {
  if (count == 0) return;
  uint32_t* const words = arriving();
  const Threshold<Sample> compared(threshold);
  // A whole group that is off is unlikely after samples that were on.
  bool may_be_off = true;
  while (count > 0) {
    uint32_t placed = 0;
    uint32_t bits = 0;
    if (stride == 1 && count >= compared.lanes && compared.reads_words(samples)) {
      if (may_be_off) placed = compared.leading_off(samples, count);
      if (placed == 0) {
        placed = (count < max_placed ? count : max_placed) / compared.lanes * compared.lanes;
        bits = compared.words_reached(samples, placed);
        may_be_off = bits == 0;
      }
    } else {
      const uint32_t before_word = stride == 1 ? compared.samples_to_word(samples) : max_placed;
      for (; placed < before_word && placed < count; ++placed)
        bits |= static_cast<uint32_t>(compared.reached(samples[size_t{placed} * stride])) << placed;
    }
    if (bits != 0) turn_on(words, bits);
    column_ += placed;
    count -= placed;
    if (count > 0) samples += size_t{placed} * stride;
  }
}

template void BitRows::append(const uint8_t*, uint32_t, uint32_t, int32_t);
template void BitRows::append(const uint16_t*, uint32_t, uint32_t, int32_t);
template void BitRows::append(const int16_t*, uint32_t, uint32_t, int32_t);

void BitRows::append_bits(const uint8_t* bits) {
  if (is_host && is_little_endian && width_ > 56) return set_words(bits);
  uint32_t* const words = arriving();
  for (; column_ < width_; column_ += 8) {
    const uint32_t left = width_ - column_;
    const uint32_t count = left < 8 ? left : 8;
    const uint32_t on = *bits++ & ((uint32_t{1} << count) - 1);
    if (on != 0) turn_on(words, on);
  }
  column_ = width_;
}

// Sets a whole word at once from the eight bytes around its bits. Limit: width > 56, and
// is_little_endian.
void BitRows::set_words(const uint8_t* bits) {
  uint32_t* const words = row_before(0);
  const uint32_t last_byte = (width_ + 7) / 8 - 8;
  words[0] = static_cast<uint32_t>(eight_bytes(bits) << 2);
  uint32_t on = words[0];
  for (uint32_t word = 1; word < words_; ++word) {
    const uint32_t bit = word * columns_per_word - 2;
    const uint32_t byte = bit / 8 < last_byte ? bit / 8 : last_byte;
    words[word] = static_cast<uint32_t>(eight_bytes(bits + byte) >> (bit - 8 * byte));
    if (word + 1 == words_) words[word] &= (uint32_t{1} << (width_ - bit)) - 1;
    on |= words[word];
  }
  if (on != 0) words[0] |= on_mark;
  column_ = width_;
}

void BitRows::write_bits(uint8_t* bits) const {
  const uint32_t* const words = row_before(0);
  for (uint32_t column = 0; column < width_; column += 8) {
    const uint32_t word = word_of(column);
    const uint32_t bit = column - word * columns_per_word + 2;  // as in turn_on()
    const uint32_t next = word + 1 < words_ ? words[word + 1] >> 2 : 0;
    *bits++ = static_cast<uint8_t>(words[word] >> bit | next << (32 - bit));
  }
}

void BitRows::repeat() {
  const bool is_first = rows_ == 0 && slices_ == 0;
  const uint32_t* const before = is_first ? row_off() : row_before(1);
  uint32_t* const words = arriving();
  for (uint32_t i = 0; i < words_; ++i) words[i] = before[i];
  column_ = width_;
}

void BitRows::fill_off() {
  arriving();
  column_ = width_;
}

void BitRows::next_row() {
  if (++row_index_ == ring_rows_) row_index_ = 0;
  ++rows_;
  column_ = 0;
}

void BitRows::next_slice() {
  rows_ = 0;
  ++slices_;
}

bool BitRows::is_off_around(int32_t y) const {
  const uint32_t row = static_cast<uint32_t>(y);
  const uint32_t available_rows = slices_ == 0 ? 0 : height_;
  const uint32_t back = rows_ + height_ - row;  // number of rows since it arrived
  uint32_t on = 0;
  if (row < available_rows) on |= *row_before(back);
  if (row + 1 < available_rows)
    on |= *row_before(back - 1);  // beyond the height for a row before the first
  if (row < rows_) on |= *row_before(back - height_);
  return (on & on_mark) == 0;
}

void BitRows::find_around(int32_t y, RowBlock& block) const {
  // Rows arrive slice by slice. Row y - 1 of the arriving slice arrived this many rows ago; the
  // same row of the slice before arrived `height_` rows earlier.
  uint32_t back = rows_ + 1 - static_cast<uint32_t>(y);
  const uint32_t* const off = row_off();
  for (uint32_t k = 3; k-- > 0; back += height_) {
    const uint32_t available_rows = slices_ + k < 2 ? 0 : k == 2 ? rows_ : height_;
    const uint32_t* next = row_before(back);
    const uint32_t** const row = block.row[k];
    const uint32_t first = static_cast<uint32_t>(y) - 1;
    const uint32_t* const last = next + words_ + words_;
    if (first < available_rows && first + 2 < available_rows && last < off) {
      row[0] = next;
      row[1] = next + words_;
      row[2] = last;
      continue;
    }
    for (uint32_t j = 0; j < 3; ++j) {
      // Exceeds the height for a row before the first.
      row[j] = first + j < available_rows ? next : off;
      next += words_;
      if (next == off) next = ring_;
    }
  }
}

}  // namespace discmc::detail::trace
