// The fractions of both ends of a stream of slices: of the arriving row and of the row before it.
#ifndef DISCMC_SLICES_FRACTIONS_HPP
#define DISCMC_SLICES_FRACTIONS_HPP

#include <discmc/limits.hpp>
#include <discmc/slices/fraction_model.hpp>
#include <discmc/slices/row_code.hpp>
#include <discmc/slices/surfaces.hpp>

namespace discmc::detail::slices {

/// A row of voxels, its fractions and what surrounds it. Owner: Surfaces and Fractions.
struct FractionRow {
  const uint32_t* here;
  const uint32_t* behind;        ///< row y - 1
  const uint32_t* below;         ///< row y of the slice before
  const uint32_t* below_behind;  ///< row y - 1 of the slice before
  uint16_t* now;                 ///< an entry per voxel: fraction_of() in fraction.hpp
  const uint16_t* before;        ///< of row y - 1
  uint32_t width;
  bool crosses[3];  ///< whether the edges along x, y and z have fractions

  /// The voxels of a word whose edge to the voxel before along the axis has a fraction.
  uint32_t crossing(uint32_t word, uint32_t axis) const {
    if (!crosses[axis]) return 0;
    const uint32_t on = here[word];
    const uint32_t others = axis == 0 ? on << 1 : axis == 1 ? behind[word] : below[word];
    const uint32_t left = width - word * detail::trace::columns_per_word;
    uint32_t columns = detail::trace::own_columns;
    if (left < detail::trace::columns_per_word) columns &= (uint32_t{4} << left) - 1;
    if (axis == 0 && word == 0) columns &= ~uint32_t{6};  // the first voxel has none before it
    return (on ^ others) & columns;
  }
};

class Fractions {
 public:
  static constexpr uint64_t bytes_for(const Limits& limits, uint32_t surfaces, uint32_t levels) {
    return surfaces * (Arena::bytes_of(2 * entries(limits.width), sizeof(uint16_t)) +
                       FractionModel::bytes_for(levels)) +
           Arena::bytes_of(flag_words(limits.height), sizeof(uint32_t));
  }
  /// Allocates bytes_for() in the arena; clear() writes to them.
  void start(Arena& arena, const StreamHeader& header) {
    surface_count_ = header.surface_count;
    width_ = header.width;
    height_ = header.height;
    for (uint32_t surface = 0; surface < surface_count_; ++surface) {
      of_[surface].entries = arena.allocate<uint16_t>(2 * entries(width_));
      of_[surface].model.start(arena, header.levels);
    }
    has_samples_ = arena.allocate<uint32_t>(flag_words(height_));
  }
  /// Before the first row, and after a loss.
  void clear() {
    for (uint32_t surface = 0; surface < surface_count_; ++surface)
      clear(of_[surface].entries, 2 * entries(width_));
    for (uint32_t i = 0; i < flag_words(height_); ++i) has_samples_[i] = 0;
  }
  /// Begins a key slice.
  void begin_models() {
    for (uint32_t surface = 0; surface < surface_count_; ++surface) of_[surface].model.begin();
  }
  FractionModel& model(uint32_t surface) { return of_[surface].model; }

  /// Begins the arriving row, without fractions.
  void begin_row(uint32_t surface) { clear(of(surface, is_odd_), entries(width_)); }
  /// What is around the arriving row. has_slice_before: whether its edges along z may cross.
  FractionRow around(const detail::trace::BitRows& rows, uint32_t surface, bool has_slice_before) {
    const uint32_t y = rows.rows();
    FractionRow row;
    row.here = rows.row(0);
    row.behind = y > 0 ? rows.row(1) : rows.off();
    row.below = rows.row(height_);
    row.below_behind = y > 0 ? rows.row(height_ + 1) : rows.off();
    row.now = of(surface, is_odd_) + 1;
    row.before = of(surface, !is_odd_) + 1;
    row.width = width_;
    row.crosses[0] = true;
    row.crosses[1] = y > 0 && has_samples(y - 1);
    row.crosses[2] = has_slice_before && has_samples(y);
    return row;
  }
  /// The entries of the arriving row.
  const uint16_t* now(uint32_t surface) { return of(surface, is_odd_) + 1; }

  /// Completes the arriving row of all surfaces. has_samples: it was not skipped.
  void next_row(uint32_t y, bool has_samples) {
    const uint32_t bit = uint32_t{1} << y % 32;
    has_samples_[y / 32] = (has_samples_[y / 32] & ~bit) | (has_samples ? bit : 0);
    is_odd_ = !is_odd_;
    if (y + 1 < height_) return;
    for (uint32_t surface = 0; surface < surface_count_; ++surface)
      clear(of(surface, !is_odd_), entries(width_));  // the first row of a slice has none before it
  }

 private:
  struct OfSurface {
    uint16_t* entries = nullptr;
    FractionModel model;
  };

  // Those of a row, one more on either side, and one that makes whole words of them.
  static constexpr uint32_t entries(uint32_t width) { return (width + 3) / 2 * 2; }
  static constexpr uint32_t flag_words(uint32_t height) { return (height + 31) / 32; }
  static void clear(uint16_t* entries, uint32_t count) {
    for (uint16_t* const end = entries + count; entries != end; ++entries) *entries = 0;
  }
  uint16_t* of(uint32_t surface, bool is_odd) {
    return of_[surface].entries + (is_odd ? entries(width_) : 0);
  }
  bool has_samples(uint32_t y) const { return (has_samples_[y / 32] >> y % 32 & 1) != 0; }

  OfSurface of_[StreamHeader::max_surfaces];
  uint32_t surface_count_ = 0;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t* has_samples_ = nullptr;  // a bit per row: the row that arrived last at this place
  bool is_odd_ = false;
};

}  // namespace discmc::detail::slices

#endif
