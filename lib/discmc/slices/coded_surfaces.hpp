// The surfaces of one stream of slices: the rows and the model of each.
#ifndef DISCMC_SLICES_CODED_SURFACES_HPP
#define DISCMC_SLICES_CODED_SURFACES_HPP

#include <discmc/sink.hpp>
#include <discmc/slices/row_code.hpp>

namespace discmc::detail::slices {

struct CodedSurface {
  detail::trace::BitRows rows;
  SliceModel model;
};

class CodedSurfaces {
 public:
  /// Allocates rows and probabilities in the arena; clear() writes to them. Limit: a valid header.
  void start(Arena& arena, const StreamHeader& header, uint32_t rows) {
    const Limits limits{header.width, header.height, header.border};
    DISCMC_LIMIT(limits.is_valid() && header.surface_count <= StreamHeader::max_surfaces);
    count_ = header.surface_count;
    height_ = header.height;
    for (CodedSurface& surface : *this) {
      surface.rows.start(arena, limits, rows);
      surface.model.start(arena, &surface != begin());
    }
  }
  void clear() {
    for (CodedSurface& surface : *this) surface.rows.clear();
  }

  CodedSurface* begin() { return surface_; }
  CodedSurface* end() { return surface_ + count_; }
  uint32_t count() const { return count_; }
  CodedSurface& operator[](uint32_t surface) { return surface_[surface]; }

  /// The rows of all surfaces arrive together.
  const detail::trace::BitRows& rows() const { return surface_[0].rows; }
  LearntProbability& note() { return surface_[0].model[context::note]; }

  /// Begins a key slice.
  void begin_key_slice() {
    kind_ = SliceKind::key;
    begin_models();
  }
  /// Begins a slice that follows another, after its first note. It does not continue the
  /// probabilities of a key slice.
  void begin_following_slice() {
    if (kind_ == SliceKind::follows) return;
    kind_ = SliceKind::follows;
    begin_models();
  }

  bool is_in_key_slice() const { return kind_ == SliceKind::key; }

  /// Begins the arriving row of one surface. width: 0 if the row is skipped.
  void begin_row(RowCode& row, uint32_t surface, uint32_t width) {
    const uint32_t* const first = surface > 0 ? rows().row(0) : nullptr;
    detail::trace::BitRows& rows = surface_[surface].rows;
    row.begin(rows.arriving(), rows_before(rows, height_, kind_, first), width);
  }
  /// Turns off the arriving row of all surfaces.
  void clear_row() {
    for (CodedSurface& surface : *this) {
      uint32_t* const row = surface.rows.arriving();
      for (uint32_t word = 0; word < surface.rows.words(); ++word) row[word] = 0;
    }
  }
  /// Completes the arriving row of all surfaces. True if the slice is complete, too.
  bool next_row() {
    for (CodedSurface& surface : *this) {
      surface.rows.next_row();
      if (surface.rows.rows() == height_) surface.rows.next_slice();
    }
    return rows().rows() == 0;
  }

 private:
  void begin_models() {
    for (CodedSurface& surface : *this) surface.model.begin(kind_);
  }

  CodedSurface surface_[StreamHeader::max_surfaces];
  uint32_t count_ = 0;
  uint32_t height_ = 0;
  SliceKind kind_ = SliceKind::key;
};

}  // namespace discmc::detail::slices

#endif
