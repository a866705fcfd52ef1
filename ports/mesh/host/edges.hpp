// Collects the crossing edges of rows, with the voxels around them.
//
// No branch depends on the surface. A batch of edges comes from several rows of a slice, so that
// the loops over edges are long.
#ifndef DISCMC_MESH_HOST_EDGES_HPP
#define DISCMC_MESH_HOST_EDGES_HPP

#include <discmc/trace/swept_row.hpp>
#include "ray_table.hpp"

namespace discmc::host {

/// An edge, and the voxels around it.
struct Edge {
  uint64_t voxel;  ///< CornerCode::position() of the voxel at the lower end
  uint32_t lines;  ///< the lines of its axis, from bit 0 (see RayTable); higher bits are unused
  uint32_t axis;   ///< with `special`, and quadrants without a cell from special_shift

  static constexpr uint32_t special_shift = 2;
  static constexpr uint32_t special = 1U << 6, at_seam = 1U << 7;
  static_assert(special == 1U << (special_shift + detail::trace::quadrants),
                "quadrants have four bits");
};

class Edges {
 public:
  static constexpr uint32_t max_edges = 192;
  /// Edges at a seam have twice as many passes.
  static constexpr uint32_t max_at_seam = max_edges / 2;

  void clear();
  /// Collects edges of a row, from the word at which the last call stopped. z: the slice of
  /// the row, counted from the first slice with edges. Returns false at the end of the row, and
  /// true if the batch has no room for one more word.
  bool collect(const detail::trace::SweptRow& row, int32_t z);
  /// Discards the collected edges.
  void discard_all() { count_ = 0; }

  bool is_empty() const { return count_ == 0; }
  uint32_t count() const { return count_; }
  const Edge* begin() const { return edge_; }
  const Edge* end() const { return edge_ + count_; }

 private:
  static constexpr uint32_t max_in_word = 3 * detail::trace::columns_per_word;
  static_assert(max_at_seam > max_in_word, "a word has room, at a seam, too");

  void collect_word(const detail::trace::SweptRow& row, uint64_t row_origin, uint32_t word,
                    uint64_t x, uint64_t y, uint64_t z);
  void mark_special(const detail::trace::SweptRow& row, uint64_t row_origin, Edge* first);

  uint32_t word_ = 0;
  uint32_t count_ = 0;
  Edge edge_[max_edges + 3] = {};  // each voxel writes three, even if fewer cross
};

}  // namespace discmc::host

#endif
