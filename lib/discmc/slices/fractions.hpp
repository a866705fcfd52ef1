// The fractions of the arriving row and of the previous row, for encoders and decoders of slices.
#ifndef DISCMC_SLICES_FRACTIONS_HPP
#define DISCMC_SLICES_FRACTIONS_HPP

#include <discmc/limits.hpp>
#include <discmc/slices/coded_surfaces.hpp>
#include <discmc/slices/fraction_model.hpp>
#include <discmc/slices/fraction_queue.hpp>
#include <discmc/slices/row_code.hpp>

namespace discmc::detail::slices {

/// The fractions of a voxel, as in fraction_of(). The higher bits are the fractions along x and y
/// of the voxel in the previous slice.
struct FractionEntry {
  static constexpr uint32_t along_x_and_y = 0x3F, own = 0x1FF, all = 0x7FFF;
  static constexpr uint32_t slice_before_shift = 9;  ///< of these higher bits
};

/// A row of voxels, its fractions and its surroundings. Owner: CodedSurfaces and Fractions.
struct FractionRow {
  const uint32_t* here;            ///< row y
  const uint32_t* row_before;      ///< row y - 1
  const uint32_t* slice_before;    ///< row y of the slice before
  const uint32_t* both_before;     ///< row y - 1 of the slice before
  uint16_t* entries;               ///< one entry per voxel, see FractionEntry
  const uint16_t* entries_before;  ///< entries of row y - 1
  FractionQueue* queue;            ///< for the next slice
  bool* has_fractions;             ///< whether the row has a fraction
  uint32_t width;
  uint16_t words;
  uint8_t crosses;  ///< bit per axis: whether edges along it have fractions

  /// Whether no edge crosses, because the three rows are off. Limit: an encoder's rows, whose first
  /// bit is set if a voxel is on.
  bool is_off() const { return ((here[0] | row_before[0] | slice_before[0]) & 1) == 0; }
  /// Whether find() finds nothing in a word, as in most words.
  DISCMC_ALWAYS_INLINE bool is_level(uint32_t word) const {
    const uint32_t on = here[word];
    const uint32_t along = (on ^ on << 1) | (on ^ row_before[word]) | (on ^ slice_before[word]);
    return (along & trace::own_columns) == 0;
  }
  /// Returns the voxels of a word with an edge that has a fraction.
  uint32_t find(uint32_t word) const { return along_x(word) | along_y(word) | along_z(word); }
  /// Return the columns with such an edge along an axis.
  uint32_t along_x(uint32_t word) const {
    return (here[word] ^ here[word] << 1) & columns_along_x(word) & mask(0);
  }
  uint32_t along_y(uint32_t word) const {
    return (here[word] ^ row_before[word]) & trace::own_columns & mask(1);
  }
  uint32_t along_z(uint32_t word) const {
    return (here[word] ^ slice_before[word]) & trace::own_columns & mask(2);
  }

 private:
  // Returns all bits if the edges along an axis have fractions, otherwise 0.
  uint32_t mask(uint32_t axis) const { return 0 - (crosses >> axis & 1); }
  // Returns the columns of a word whose voxel and previous voxel lie in the volume.
  uint32_t columns_along_x(uint32_t word) const {
    uint32_t columns = word == 0 ? trace::own_columns - 6 : trace::own_columns;
    if (word + 1 == words) columns &= (uint32_t{4} << (width - word * trace::columns_per_word)) - 1;
    return columns;
  }
};

class Fractions {
 public:
  static constexpr uint64_t bytes_for(const Limits& limits, uint32_t surfaces, uint32_t levels) {
    return surfaces * (Arena::bytes_of(2 * entry_groups(limits.width), sizeof(FourEntries)) +
                       FractionModel::bytes_for(levels) + FractionQueue::bytes_for(limits)) +
           Arena::bytes_of(flag_words(limits.height), sizeof(uint32_t));
  }
  /// Allocates bytes_for() in the arena; clear() writes to them.
  void start(Arena& arena, const StreamHeader& header) {
    surface_count_ = header.surface_count;
    width_ = header.width;
    height_ = header.height;
    for (uint32_t surface = 0; surface < surface_count_; ++surface) {
      surfaces_[surface].entries = arena.allocate<FourEntries>(2 * entry_groups(width_));
      surfaces_[surface].model.start(arena, header.levels);
      surfaces_[surface].queue.start(arena, {header.width, header.height, header.border},
                                     header.levels);
    }
    has_samples_ = arena.allocate<uint32_t>(flag_words(height_));
  }
  /// Call it before the first row, and after a loss.
  void clear() {
    for (uint32_t surface = 0; surface < surface_count_; ++surface) {
      surfaces_[surface].queue.clear();
      for (uint32_t row = 0; row < 2; ++row) {
        surfaces_[surface].is_clear[row] = false;
        clear_row(surface, row != 0);
      }
    }
    for (uint32_t i = 0; i < flag_words(height_); ++i) has_samples_[i] = 0;
  }
  /// Begins a key slice.
  void begin_models() {
    for (uint32_t surface = 0; surface < surface_count_; ++surface) {
      surfaces_[surface].model.begin();
      surfaces_[surface].queue.begin();
    }
  }
  FractionModel& model(uint32_t surface) { return surfaces_[surface].model; }

  /// Begins the arriving row, with the fractions of the previous slice.
  void begin_row(const detail::trace::BitRows& rows, uint32_t surface) {
    clear_row(surface, is_odd_);
    if (surfaces_[surface].queue.has_next()) dequeue_row(rows, surface);
  }
  /// Whether the arriving row has a fraction.
  bool has_fractions(uint32_t surface) const {
    return surfaces_[surface].has_fractions[is_odd_ ? 1 : 0];
  }
  /// Returns the arriving row and its surroundings. has_slice_before: whether its edges along z may
  /// cross.
  FractionRow around(const detail::trace::BitRows& rows, uint32_t surface, bool has_slice_before) {
    const uint32_t y = rows.rows();
    FractionRow row;
    row.here = rows.row(0);
    row.row_before = y > 0 ? rows.row(1) : rows.off();
    row.slice_before = has_slice_before ? rows.row(height_) : rows.off();
    row.both_before = has_slice_before && y > 0 ? rows.row(height_ + 1) : rows.off();
    row.entries = row_of(surface, is_odd_) + 1;
    row.entries_before = row_of(surface, !is_odd_) + 1;
    row.queue = &surfaces_[surface].queue;
    row.width = width_;
    row.words = static_cast<uint16_t>(rows.words());
    uint32_t crosses = 1;
    if (y > 0 && has_samples(y - 1)) crosses |= 2;
    if (has_slice_before && has_samples(y)) crosses |= 4;
    row.crosses = static_cast<uint8_t>(crosses);
    row.has_fractions = &surfaces_[surface].has_fractions[is_odd_ ? 1 : 0];
    return row;
  }
  /// Returns the entries of the arriving row.
  const uint16_t* entries(uint32_t surface) { return row_of(surface, is_odd_) + 1; }

  /// Completes the arriving row of all surfaces. has_samples: whether it was not skipped.
  DISCMC_ALWAYS_INLINE void next_row(uint32_t y, bool has_samples) {
    const uint32_t bit = uint32_t{1} << y % 32;
    had_samples_in_row_before_ = this->has_samples(y);
    has_samples_[y / 32] = (has_samples_[y / 32] & ~bit) | (has_samples ? bit : 0);
    is_odd_ = !is_odd_;
    if (y + 1 < height_) return;
    for (uint32_t surface = 0; surface < surface_count_; ++surface) {
      surfaces_[surface].queue.next_slice();
      clear_row(surface, !is_odd_);  // the first row of a slice has no row before it
    }
  }

 private:
  // Two words, cleared at once.
  struct alignas(Arena::alignment) FourEntries {
    uint16_t entry[4];
  };
  struct SurfaceFractions {
    FourEntries* entries = nullptr;
    FractionModel model;
    FractionQueue queue;
    bool has_fractions[2] = {};  // whether each row has a fraction
    bool is_clear[2] = {};       // whether all entries of each row are 0
  };

  // Returns the groups of four in a row, with one more entry on either side.
  static constexpr uint32_t entry_groups(uint32_t width) { return (width + 5) / 4; }
  static constexpr uint32_t flag_words(uint32_t height) { return (height + 31) / 32; }
  void clear_row(uint32_t surface, bool is_odd) {
    const uint32_t row = is_odd ? 1 : 0;
    bool& has_fractions = surfaces_[surface].has_fractions[row];
    bool& is_clear = surfaces_[surface].is_clear[row];
    if (is_clear && !has_fractions) return;
    has_fractions = false;
    is_clear = true;
    FourEntries* entry = surfaces_[surface].entries + row * entry_groups(width_);
    const FourEntries* const end = entry + entry_groups(width_);
    do *entry++ = {};
    while (entry != end);
  }
  // Removes this row's fractions of the previous slice from the queue.
  DISCMC_ALWAYS_INLINE void dequeue_row(const detail::trace::BitRows& rows, uint32_t surface) {
    const uint32_t y = rows.rows();
    FractionRow row;
    row.here = rows.row(height_);
    row.row_before = y > 0 ? rows.row(height_ + 1) : rows.off();
    row.slice_before = row.here;
    row.width = width_;
    row.words = static_cast<uint16_t>(rows.words());
    row.crosses = !has_samples(y) ? 0 : y > 0 && had_samples_in_row_before_ ? 3 : 1;
    uint16_t* const row_entries = row_of(surface, is_odd_) + 1;
    SurfaceFractions& own = surfaces_[surface];
    for (uint32_t word = 0; word < row.words; ++word) {
      if (row.is_level(word)) continue;
      const uint32_t along_x = row.along_x(word), along_y = row.along_y(word);
      for (uint32_t edges = along_x | along_y; edges != 0; edges &= edges - 1) {
        const uint32_t bit = trailing_zeros(edges);
        uint32_t fractions = 0;
        if ((along_x >> bit & 1) != 0) fractions = own.queue.pop();
        if ((along_y >> bit & 1) != 0) fractions |= own.queue.pop() << 3;
        row_entries[word * detail::trace::columns_per_word + bit - 2] =
            static_cast<uint16_t>(fractions << FractionEntry::slice_before_shift);
        own.is_clear[is_odd_ ? 1 : 0] = false;
      }
    }
  }
  uint16_t* row_of(uint32_t surface, bool is_odd) {
    return surfaces_[surface].entries[is_odd ? entry_groups(width_) : 0].entry;
  }
  bool has_samples(uint32_t y) const { return (has_samples_[y / 32] >> y % 32 & 1) != 0; }

  SurfaceFractions surfaces_[StreamHeader::max_surfaces];
  uint32_t surface_count_ = 0;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t* has_samples_ = nullptr;  // a bit per row: whether the last row with this y has samples
  bool had_samples_in_row_before_ = false;  // in the previous slice
  bool is_odd_ = false;
};

}  // namespace discmc::detail::slices

#endif
