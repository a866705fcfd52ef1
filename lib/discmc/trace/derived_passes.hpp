// The passes that a sweep takes, worked out at every vertex, one vertex at a time.
#ifndef DISCMC_TRACE_DERIVED_PASSES_HPP
#define DISCMC_TRACE_DERIVED_PASSES_HPP

#include <discmc/compiler.hpp>
#include <discmc/trace/passes.hpp>
#include <discmc/trace/swept_row.hpp>

namespace discmc::detail::trace {

class DerivedPasses {
 public:
  /// Forgets where it is in a row, and what it has found.
  void clear() {
    passes_.count = 0;
    word_ = 0;
    crossings_ = {};
  }
  /// Begins in a word of a row. Limit: after clear().
  void go_on_from(uint32_t word) { word_ = word; }

  /// Finds the next vertex of a row that has passes, and counts the cells on the way. False after
  /// the last vertex; the next call begins a row.
  template <class Features = AllFeatures>
  bool find(const SweptRow& row, SweepCounts& counts);

  /// The first pass that has been found and not taken, and where it is. Limit: has_next().
  bool has_next() const { return next_ < passes_.count; }
  const Pass& pass() const { return passes_.pass[next_]; }
  const Vertex& vertex() const { return vertex_; }
  void advance() { ++next_; }

 private:
  // Finds the next word with crossings.
  template <class Features>
  bool find_word(const SweptRow& row);

  PassList passes_{};
  uint32_t next_ = 0;
  Vertex vertex_{};
  uint32_t word_ = 0;         // behind the one that crossings_ are of
  Crossings crossings_ = {};  // those not yet visited
};

template <class Features>
DISCMC_ALWAYS_INLINE bool DerivedPasses::find_word(const SweptRow& row) {
  for (uint32_t word = word_; word < row.words; ++word) {
    if (!crossings_.find<has_absent<Features>>(row, word)) continue;
    word_ = word + 1;
    return true;
  }
  return false;
}

template <class Features>
bool DerivedPasses::find(const SweptRow& row, SweepCounts& counts) {
  next_ = 0;
  for (;;) {
    const uint32_t voxels = crossings_.voxels();
    if (voxels == 0) {
      if (find_word<Features>(row)) continue;
      clear();
      return false;
    }
    const uint32_t bit = trailing_zeros(voxels);
    int axis = 0;
    while ((crossings_.of[axis] >> bit & 1) == 0) ++axis;
    crossings_.of[axis] &= crossings_.of[axis] - 1;
    const uint32_t x = column_of(word_ - 1, bit);
    derive_passes<has_absent<Features>, Features::cell_counts>(
        {row.around, word_ - 1, bit, axis}, has_absent<Features> ? row.absent_at(axis, x) : 0,
        passes_);
    if (Features::cell_counts && (!Features::slabs || row.is_own())) counts.add(passes_.parts);
    if (passes_.count == 0) continue;
    vertex_ = row.vertex(axis, x);
    return true;
  }
}

}  // namespace discmc::detail::trace

#endif
