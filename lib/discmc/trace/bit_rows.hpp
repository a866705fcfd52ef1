// Rows of bits, one per voxel, of the three slices that a sweep reads.
//
// The voxels of a row have columns 1 to width. Columns 0 and width + 1 are the halo, which is off.
// A word holds 30 columns, and a copy of the column on either side. The neighbours of each column
// are therefore in the same word:
//
//     bit      31   30 ......... 1   0
//     word k   30k + 30   30k + 29 ... 30k   30k - 1
//
// The first word has no column before it. Its bit 0 is set if a voxel of the row is on.
//
// A ring buffer of 2 * height + 3 rows suffices. During the sweep of row y, the oldest row in use
// is row y - 1 of the slice below. The newest is row y + 1 of the slice above.
#ifndef DISCMC_TRACE_BIT_ROWS_HPP
#define DISCMC_TRACE_BIT_ROWS_HPP

#include <discmc/base/arena.hpp>
#include <discmc/limits.hpp>

namespace discmc::detail::trace {

constexpr uint32_t columns_per_word = 30;

/// Returns the word of a column: column / 30, without a division. Limit: column < 74,898.
constexpr uint32_t word_of(uint32_t column) {
  return column * 34953 >> 20;
}
/// Returns the words of a row of bits, for columns 0 to width.
constexpr uint32_t row_words(uint32_t width) {
  return word_of(width) + 1;
}
/// Returns the number of rows in the ring that a sweep needs.
constexpr uint32_t swept_rows(uint32_t height) {
  return 2 * height + 3;
}
/// Returns the bytes of a ring buffer of this many rows, and of a row that is off.
constexpr uint64_t bit_row_bytes(uint32_t width, uint32_t rows) {
  return uint64_t{rows + 1} * row_words(width) * sizeof(uint32_t) + red_zone_bytes;
}

/// The bits of a word's own columns.
constexpr uint32_t own_columns = 0x7FFFFFFE;

/// Returns the own columns whose voxel and next voxel lie in the volume.
constexpr uint32_t inner_columns(uint32_t word, uint32_t width) {
  const uint32_t columns = word == 0 ? own_columns - 2 : own_columns;
  const uint32_t left = width - word * columns_per_word;
  return left < columns_per_word ? columns & ((uint32_t{2} << left) - 1) : columns;
}

/// The nine rows around a row of voxels: [z - 1, z, z + 1][y - 1, y, y + 1].
struct RowBlock {
  const uint32_t* row[3][3];
};

/// The four rows of cells between these rows, as bits 2 * layer + row. Each constant is one side.
struct CellRowBits {
  static constexpr uint32_t front = 5, back = 10, below = 3, above = 12;
};

/// The rows of the arriving slice and of the two slices before it.
class BitRows {
 public:
  /// Keeps this many rows, including the arriving one. Allocates bit_row_bytes() in the arena;
  /// clear() writes there.
  void start(Arena& arena, const Limits& limits, uint32_t rows);
  void clear();

  /// Appends samples to the arriving row: on if sample >= threshold. `stride` counts samples from
  /// one to the next. Limit: count <= width - column(). Cost: one or two instructions per sample
  /// far below the threshold, 5 to 15 for others and for samples that are not consecutive.
  template <class Sample>
  void append(const Sample* samples, uint32_t count, uint32_t stride, int32_t threshold);
  /// Fills the whole row from bits, eight voxels per byte, the first in bit 0.
  /// Limit: column() == 0.
  void append_bits(const uint8_t* bits);
  /// Writes the arriving row in the form of append_bits(). Limit: the row is complete.
  void write_bits(uint8_t* bits) const;
  /// Fills the rest of the row with off voxels.
  void fill_off();
  /// Fills the whole row with the previous row, or with off for the first row. Limit: column() ==
  /// 0.
  void repeat();

  uint32_t column() const { return column_; }
  bool is_row_complete() const { return column_ == width_; }
  /// Ends the arriving row and begins the next one of the slice.
  void next_row();

  /// Returns the words of the arriving row, all off before its first column.
  uint32_t* arriving();
  /// Returns the row that arrived `back` rows ago. Limit: the row exists and is kept.
  const uint32_t* row(uint32_t back) const { return row_before(back); }
  /// Returns a row that is off.
  const uint32_t* off() const { return row_off(); }

  uint32_t words() const { return words_; }
  /// Return the number of complete rows of the arriving slice (0 to height), and of complete
  /// slices.
  uint32_t rows() const { return rows_; }
  uint32_t slices() const { return slices_; }
  /// Ends the arriving slice, which becomes the middle slice while the next arrives.
  void next_slice();

  /// Finds the rows around row y (-1 to height - 1) of the slice before the arriving one. Rows
  /// outside the volume, and rows that have not arrived, are off.
  void find_around(int32_t y, RowBlock& block) const;
  /// Whether no edge of that row crosses, because the row, the one behind and the one above are
  /// off.
  bool is_off_around(int32_t y) const;

 private:
  static constexpr uint32_t on_mark = 1;

  uint32_t* row_before(uint32_t back) const;
  uint32_t* row_off() const { return &ring_[size_t{words_} * ring_rows_]; }
  void turn_on(uint32_t* words, uint32_t bits) const;
  void set_words(const uint8_t* bits);

  uint32_t* ring_ = nullptr;  // followed by a row that is off
  uint32_t words_ = 0;
  uint32_t ring_rows_ = 0;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t row_index_ = 0;  // of the arriving row in the ring
  uint32_t column_ = 0;
  uint32_t rows_ = 0;
  uint32_t slices_ = 0;
};

}  // namespace discmc::detail::trace

#endif
