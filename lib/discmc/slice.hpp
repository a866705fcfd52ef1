// Rows of bits: samples are compared with the threshold as they arrive, one bit a voxel is kept.
//
// A ring of height + 2 rows holds all that a sweep needs: row j of the old slice is done when row
// j + 1 of the new one is there. Voxel i of a row is bit i + halo, counted from bit 0 of the first
// word, so that the halo of a closed border is a zero bit like any other.
#ifndef DISCMC_SLICE_HPP
#define DISCMC_SLICE_HPP

#include <discmc/limits.hpp>

namespace discmc {

/// The four bit rows around a row of cells.
struct RowQuad {
  const uint32_t* row[4];  ///< (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1)
};

/// The active cells among the 32 that start in word `word` of the rows: neither all on nor all off.
/// Bit i stands for the cell of bits i and i + 1. Limit: bits beyond the rows count as off.
inline uint32_t active_cells(const RowQuad& rows, uint32_t word, uint32_t words) {
  uint32_t any = 0;
  uint32_t all = ~uint32_t{0};
  for (const uint32_t* row : rows.row) {
    const uint32_t left = row[word];
    const uint32_t right = left >> 1 | (word + 1 < words ? row[word + 1] << 31 : 0);
    any |= left | right;
    all &= left & right;
  }
  return any & ~all;
}

/// The first word from `word` on whose cells may be active, or `words`: where the rows are off no
/// cell is.
inline uint32_t skip_off(const RowQuad& rows, uint32_t word, uint32_t words) {
  const uint32_t* const a = rows.row[0];
  const uint32_t* const b = rows.row[1];
  const uint32_t* const c = rows.row[2];
  const uint32_t* const d = rows.row[3];
  const uint32_t begin = word;
  while (word < words && (a[word] | b[word] | c[word] | d[word]) == 0) ++word;
  // The last cell of a word that is off reaches into the next.
  return word > begin && word < words ? word - 1 : word;
}

/// The configuration of the cell of bits 32 * word + bit and the one after. Limit: both are bits of
/// the rows.
inline Configuration configuration_at(const RowQuad& rows, uint32_t word, uint32_t bit) {
  uint32_t configuration = 0;
  for (uint32_t i = 0; i < 4; ++i) {
    const uint32_t* const row = rows.row[i];
    uint32_t pair = row[word] >> bit;
    if (bit == 31) pair |= row[word + 1] << 1;
    configuration |= (pair & 3) << 2 * i;
  }
  return static_cast<Configuration>(configuration);
}

/// The bit rows of the slice that arrives and of the one before it.
class BitRows {
 public:
  /// Takes row_words() * (height + 3) words from the arena, and writes nothing there; clear() does.
  void start(Arena& arena, const Limits& limits);
  void clear();

  /// Appends samples to the row that arrives: on where sample >= threshold. `stride` counts samples
  /// from one to the next. Limit: count <= width - column(). Cost: about an instruction a sample
  /// far below the threshold, a few for others, and about ten where they are not consecutive.
  template <class Sample>
  void append(const Sample* samples, uint32_t count, uint32_t stride, int32_t threshold);
  /// Fills the whole row from bits, eight voxels a byte, the first in bit 0. Limit: column() == 0.
  void append_bits(const uint8_t* bits);
  /// Fills the rest of the row with off voxels.
  void fill_off();
  /// Fills the whole row with the row before it (off for the first of all). Limit: column() == 0.
  void repeat();

  uint32_t column() const { return column_; }
  bool row_is_complete() const { return column_ == width_; }
  /// Begins the next row of the slice.
  void next_row();

  uint32_t words() const { return words_; }
  /// Rows of the arriving slice that are complete (0 to height), and slices that are.
  uint32_t rows() const { return rows_; }
  uint32_t slices() const { return slices_; }
  /// Makes the slice just completed the old one.
  void next_slice();

  /// The rows around the row of cells that starts at row y (which may be -1). Rows outside the
  /// slice are off, and so is the old slice before the first and the new one after the last.
  RowQuad around(int32_t y) const;

 private:
  uint32_t* row(uint32_t start, uint32_t y) const {
    const uint32_t place = start + y;
    return ring_ + size_t{place < ring_rows_ ? place : place - ring_rows_} * words_;
  }
  uint32_t* arriving();
  void place(uint32_t* words, uint32_t bits) const;

  uint32_t* ring_ = nullptr;
  uint32_t* off_ = nullptr;
  uint32_t words_ = 0;
  uint32_t ring_rows_ = 0;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t halo_ = 0;
  uint32_t old_start_ = 0;
  uint32_t new_start_ = 0;
  uint32_t column_ = 0;
  uint32_t rows_ = 0;
  uint32_t slices_ = 0;
};

}  // namespace discmc

#endif
