// Encodes or decodes a row of bits: voxel by voxel, or run by run if all neighbours are alike.
#ifndef DISCMC_SLICES_ROW_CODE_HPP
#define DISCMC_SLICES_ROW_CODE_HPP

#include <discmc/base/checks.hpp>
#include <discmc/base/compiler.hpp>
#include <discmc/slices/slice_model.hpp>
#include <discmc/trace/bit_rows.hpp>

namespace discmc::detail::slices {

/// The rows that contain the neighbours of a row's voxels. Owner: CodedSurfaces.
struct RowsBefore {
  const uint32_t* nearest;  ///< its voxels 0, 1 and 2 are neighbours: see slice_model.hpp
  const uint32_t* next;     ///< 3, 4 and 5
  const uint32_t* third;    ///< 6
  const uint32_t* last;     ///< 7
  const uint32_t* first;    ///< 8: this row of the first surface; null for the first surface itself
};

/// Returns the neighbours of the arriving row. first: as in RowsBefore.
inline RowsBefore rows_before(const detail::trace::BitRows& rows, uint32_t height, SliceKind kind,
                              const uint32_t* first = nullptr) {
  const auto row = [&rows](bool is_available, uint32_t back) {
    return is_available ? rows.row(back) : rows.off();
  };
  const uint32_t y = rows.rows();
  const bool is_key = kind == SliceKind::key;
  return {row(y >= 1, 1), row(!is_key || y >= 2, is_key ? 2 : height),
          row(is_key ? y >= 3 : y + 1 < height, is_key ? 3 : height - 1),
          row(y >= 1, is_key ? 1 : height + 1), first};
}
/// Returns the number of rows to keep for these neighbours, including the arriving row.
constexpr uint32_t rows_kept(uint32_t height, bool are_all_key) {
  const uint32_t slice_rows = height + 2;
  return are_all_key || slice_rows < 4 ? 4 : slice_rows;
}

/// The note before a row.
enum class RowNote : uint8_t {
  end,       ///< no row follows: the code ends
  off,       ///< the row is skipped, and off
  repeated,  ///< the row is skipped, and the row before replaces it
  none,      ///< the row follows
};
/// The bits of a note.
constexpr uint32_t note_bits = 3;

/// The position in a row that is written or read. A coder's code_bit(probability, bit) and
/// raw_bits(bits, value) write the value, or return the one that they read.
class RowCode {
 public:
  /// row: in the format of BitRows, of `width` voxels; reading writes to it. Limit: before reading,
  /// the row is off.
  void begin(uint32_t* row, const RowsBefore& before, uint32_t width) {
    row_ = row;
    before_ = before;
    left_ = width;
    word_ = 0;
    bit_ = 2;
    previous_voxel_word_ = 0;
    level_end_ = width;
  }
  bool is_done() const { return left_ == 0; }
  /// Returns the number of voxels that are not coded yet.
  uint32_t left() const { return left_; }
  /// Sets the number of fractions left, for a cut while fractions are coded.
  void set_left(uint32_t left) { left_ = left; }

  /// Codes the next voxel or run. Returns false if no encoder wrote the bits. Limit: not is_done().
  /// Cost: 1 decision; for a run that ends early, about 10.
  template <class Coder>
  bool step(Coder& coder, SliceModel& model) {
    DISCMC_LIMIT(!is_done());
    const uint32_t neighbours = differing_neighbours();
    const uint32_t level = neighbours % context::voxels == 0 ? level_voxels() : 0;
    bool next_differs = true;
    if (level < 2) {
      next_differs = coder.code_bit(model[context::voxel + neighbours], differs());
    } else {
      uint32_t same = same_voxels(level);
      const bool is_whole = coder.code_bit(model[run_context(level)], same == level);
      same = is_whole ? level : coder.raw_bits(bit_width(level - 1), same);
      if (!is_whole && same >= level) return false;
      write_equal(same);
      if (is_whole) return true;
    }
    write_next(next_differs);
    return true;
  }

  /// Completes a row that was read: copies into each word its columns of the adjacent words.
  void complete(uint32_t words) {
    for (uint32_t word = 1; word < words; ++word) {
      row_[word] |= row_[word - 1] >> 30 & 1;
      row_[word - 1] |= (row_[word] >> 1 & 1) << 31;
    }
  }

 private:
  // Whether the next voxel differs from the previous one. Undefined while reading.
  bool differs() const { return ((row_[word_] ^ previous_voxel_word_) >> bit_ & 1) != 0; }

  // Returns one bit per neighbour that differs from the previous voxel.
  uint32_t differing_neighbours() const {
    const uint32_t nearest = before_.nearest[word_] >> (bit_ - 1) & 7;
    const uint32_t next = before_.next[word_] >> (bit_ - 1) & 7;
    const uint32_t third = before_.third[word_] >> bit_ & 1;
    const uint32_t last = before_.last[word_] >> bit_ & 1;
    const uint32_t differing =
        (nearest | next << 3 | third << 6 | last << 7) ^ (previous_voxel_word_ & 0xFF);
    if (before_.first == nullptr) return differing;
    return differing | ((before_.first[word_] ^ previous_voxel_word_) >> bit_ & 1) << 8;
  }

  // Returns the number of voxels from here on whose neighbours, except in the first surface, all
  // equal the previous voxel. Limit: the next voxel is one of them.
  uint32_t level_voxels() {
    DISCMC_LIMIT(differing_neighbours() % context::voxels == 0);
    // If a run has ended early, the rest of its level is not computed again.
    if (left_ <= level_end_) level_end_ = left_ - computed_level_voxels();
    return left_ - level_end_;
  }
  uint32_t computed_level_voxels() const {
    return voxels_before(left_, [this](uint32_t word) {
      const uint32_t beside = (before_.nearest[word] ^ previous_voxel_word_) |
                              (before_.next[word] ^ previous_voxel_word_);
      const uint32_t below = (before_.third[word] ^ previous_voxel_word_) |
                             (before_.last[word] ^ previous_voxel_word_);
      // Only the neighbour at x + 1 is new; the previous voxel shares the others.
      return beside >> 1 | below;
    });
  }
  // Returns the number of voxels from here on that equal the previous one, at most `limit`.
  uint32_t same_voxels(uint32_t limit) const {
    return voxels_before(limit,
                         [this](uint32_t word) { return row_[word] ^ previous_voxel_word_; });
  }
  // Returns the number of voxels from here on before the first whose bit is set, at most `limit`.
  template <class Bits>
  uint32_t voxels_before(uint32_t limit, Bits bits) const {
    uint32_t passed = 0;
    for (uint32_t word = word_, bit = bit_; passed < limit; ++word, bit = 1) {
      const uint32_t rest = (bits(word) & detail::trace::own_columns) >> bit;
      if (rest != 0) {
        passed += trailing_zeros(rest);
        break;
      }
      passed += detail::trace::columns_per_word + 1 - bit;
    }
    return passed < limit ? passed : limit;
  }

  uint32_t run_context(uint32_t level) const {
    const uint32_t width = bit_width(level);
    const uint32_t length = width < context::run_lengths ? width : context::run_lengths;
    return context::run + 2 * (length - 1) + (level == left_ ? 1 : 0);
  }

  // Writes this many voxels that equal the previous one.
  DISCMC_ALWAYS_INLINE void write_equal(uint32_t voxels) {
    DISCMC_LIMIT(voxels <= left_);
    left_ -= voxels;
    while (voxels > 0) {
      const uint32_t room = detail::trace::columns_per_word + 1 - bit_;
      const uint32_t here = voxels < room ? voxels : room;
      const uint32_t next = bit_ + here;
      row_[word_] |= previous_voxel_word_ & ((uint32_t{1} << next) - (uint32_t{1} << bit_));
      go_to(next);
      voxels -= here;
    }
  }
  // Writes the next voxel, which differs or not.
  DISCMC_ALWAYS_INLINE void write_next(bool differs) {
    if (differs) previous_voxel_word_ = ~previous_voxel_word_;
    --left_;
    row_[word_] |= previous_voxel_word_ & uint32_t{1} << bit_;
    go_to(bit_ + 1);
  }
  // Limit: next is in the word, or the bit behind its own columns.
  DISCMC_ALWAYS_INLINE void go_to(uint32_t next) {
    DISCMC_LIMIT(next <= detail::trace::columns_per_word + 1);
    bit_ = next <= detail::trace::columns_per_word ? next : 1;
    if (bit_ != next) ++word_;
  }

  uint32_t* row_ = nullptr;
  RowsBefore before_{};
  uint32_t left_ = 0;
  uint32_t word_ = 0;
  uint32_t bit_ = 0;                  // of the next voxel
  uint32_t previous_voxel_word_ = 0;  // a word of voxels that equal the previous one
  uint32_t level_end_ = 0;            // voxels left after the last computed level
};

}  // namespace discmc::detail::slices

#endif
