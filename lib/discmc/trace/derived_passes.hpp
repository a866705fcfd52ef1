// Computes the passes of a sweep at every vertex, one vertex at a time.
#ifndef DISCMC_TRACE_DERIVED_PASSES_HPP
#define DISCMC_TRACE_DERIVED_PASSES_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/trace/passes.hpp>
#include <discmc/trace/swept_row.hpp>

namespace discmc::detail::trace {

class DerivedPasses {
 public:
  /// Forgets its position in a row, and the passes found.
  void clear() {
    passes_.count = 0;
    word_ = 0;
    crossings_ = {};
  }

  /// Finds the next vertex of a row that has passes, and counts the cells on the way. Returns false
  /// after the last vertex; the next call begins a row.
  template <bool is_lean = false>
  bool find(const SweptRow& row, SweepCounts& counts);

  /// The first found pass that was not processed, and its vertex. Limit: has_next().
  bool has_next() const { return next_ < passes_.count; }
  const Pass& pass() const { return passes_.pass[next_]; }
  const Vertex& vertex() const { return vertex_; }
  void advance() { ++next_; }

 private:
  // Finds the next word with crossings.
  template <bool is_lean>
  bool find_word(const SweptRow& row);

  PassList passes_{};
  uint32_t next_ = 0;
  Vertex vertex_{};
  uint32_t word_ = 0;             // word after the one of crossings_
  CrossingEdges crossings_ = {};  // edges not yet visited
};

template <bool is_lean>
DISCMC_ALWAYS_INLINE bool DerivedPasses::find_word(const SweptRow& row) {
  for (uint32_t word = word_; word < row.words; ++word) {
    if (!crossings_.find<!is_lean>(row, word)) continue;
    word_ = word + 1;
    return true;
  }
  return false;
}

template <bool is_lean>
bool DerivedPasses::find(const SweptRow& row, SweepCounts& counts) {
  next_ = 0;
  for (;;) {
    const uint32_t voxels = crossings_.voxels();
    if (voxels == 0) {
      if (find_word<is_lean>(row)) continue;
      clear();
      return false;
    }
    const uint32_t bit = trailing_zeros(voxels);
    int axis = 0;
    while ((crossings_.by_axis[axis] >> bit & 1) == 0) ++axis;
    crossings_.by_axis[axis] &= crossings_.by_axis[axis] - 1;
    const uint32_t x = column_of(word_ - 1, bit);
    derive_passes<is_lean>({row.around, word_ - 1, bit, axis}, is_lean ? 0 : row.absent_at(axis, x),
                           passes_);
    if (!is_lean && row.is_own()) counts.add(passes_.parts);
    if (passes_.count == 0) continue;
    vertex_ = row.vertex(axis, x);
    return true;
  }
}

}  // namespace discmc::detail::trace

#endif
