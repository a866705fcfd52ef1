// The sweep: visits the vertices of a row and hands their passes to the fragments.
//
// A vertex is visited with the voxel at the lower end of its edge: voxels in the order x, y, z, and
// at each its edges in the same order. The sweep may be suspended between any two passes.
#ifndef DISCMC_TRACE_SWEEP_HPP
#define DISCMC_TRACE_SWEEP_HPP

#include <discmc/compiler.hpp>
#include <discmc/trace/delivery.hpp>
#include <discmc/trace/neighbourhood.hpp>

namespace discmc::trace {

/// A row of voxels and what of its surroundings takes part.
struct SweptRow {
  RowBlock rows;
  int32_t y, z;
  uint32_t absent[3];  ///< by axis of an edge: quadrants whose row of cells takes no part
  uint32_t axes;       ///< whose edges are there, a bit each
  bool is_above_slab;  ///< what comes from below ends here, and nothing begins

  /// is_absent: of the four rows of cells around, [z - 1, z][y - 1, y].
  void set_absent(const bool (&is_absent)[2][2]) {
    const auto quadrants_of = [&](int y0, int z0, int y1, int z1, int y2, int z2, int y3, int z3) {
      return (is_absent[z0][y0] ? 1U : 0U) | (is_absent[z1][y1] ? 2U : 0U) |
             (is_absent[z2][y2] ? 4U : 0U) | (is_absent[z3][y3] ? 8U : 0U);
    };
    absent[0] = quadrants_of(1, 1, 0, 1, 0, 0, 1, 0);
    absent[1] = quadrants_of(1, 1, 1, 0, 1, 0, 1, 1);
    absent[2] = quadrants_of(1, 1, 1, 1, 0, 1, 0, 1);
  }
};

/// What happens at the ends of a row: nothing but with an open border.
struct RowEnds {
  bool are_open;
  uint32_t width;

  /// Quadrants without a cell for lack of a column. x: of the voxel.
  uint32_t absent(int axis, uint32_t x) const {
    if (!are_open || axis == 0) return 0;
    const uint32_t before = axis == 1 ? 12 : 6;
    return (x == 0 ? before : 0) | (x + 1 == width ? before ^ 15 : 0);
  }
};

/// A sum of parts of one.
class PartCount {
 public:
  void add(uint32_t parts) { parts_ += parts; }
  void add_to(uint64_t& total, uint32_t parts_of_one) {
    total += parts_ / parts_of_one;
    parts_ %= parts_of_one;
  }

 private:
  uint32_t parts_ = 0;
};

template <class Index, class Normal>
class Sweep {
 public:
  Fragments<Index, Normal>& chains() { return chains_; }
  Delivery<Index, Normal>& delivery() { return delivery_; }
  /// After the last vertex: delivers holes that still wait, loose. As sweep().
  bool settle_holes(const Sink& sink, Statistics& statistics) {
    return delivery_.settle_holes(chains_, sink, statistics);
  }
  const Fragments<Index, Normal>& chains() const { return chains_; }
  const Delivery<Index, Normal>& delivery() const { return delivery_; }

  void clear() {
    chains_.clear();
    delivery_.clear();
    cells_ = facets_ = triangles_ = {};
    place_ = Place{};
  }

  /// Sweeps a row, or goes on with it. False when the sink said "not now": call again.
  template <class Normals>
  bool sweep(const SweptRow& row, uint32_t words, const RowEnds& ends, const Normals& normals,
             const Sink& sink, Statistics& statistics);

 private:
  template <class Normals>
  bool visit(const SweptRow& row, const RowEnds& ends, const Neighbourhood& around, int axis,
             uint32_t x, const Normals& normals, const Sink& sink, Statistics& statistics);
  bool end_above(Passes& passes, const Vertex& vertex, const Sink& sink, Statistics& statistics);
  void count(uint32_t parts) {
    constexpr uint32_t facet = CountParts::facet_shift, triangle = CountParts::triangle_shift;
    cells_.add(parts & ((1U << facet) - 1));
    facets_.add(parts >> facet & ((1U << (triangle - facet)) - 1));
    triangles_.add(parts >> triangle);
  }

  // Where the sweep of a row was suspended: the word, what of it has been visited (voxels, and of the
  // next voxel the axes of edges), and the steps done at the next vertex: one a pass, or two above a
  // slab.
  struct Place {
    uint32_t word = 0;
    uint32_t voxels = 0;
    uint32_t axes = 0;
    uint32_t steps = 0;
  };
  Place place_;
  PartCount cells_, facets_, triangles_;
  Fragments<Index, Normal> chains_;
  Delivery<Index, Normal> delivery_;
};

// ---- implementation ----

/// Bits of the voxels in a word whose edges cross, by axis.
struct Crossings {
  uint32_t of[3];

  Crossings(const SweptRow& row, uint32_t word) {
    const uint32_t here = row.rows.row[1][1][word];
    of[0] = here ^ here >> 1;
    of[1] = here ^ row.rows.row[1][2][word];
    of[2] = here ^ row.rows.row[2][1][word];
  }
  /// The axes along which the edge of a voxel crosses, a bit each.
  uint32_t axes(uint32_t bit) const {
    return (of[0] >> bit & 1) | (of[1] >> bit & 1) << 1 | (of[2] >> bit & 1) << 2;
  }
};

template <class Index, class Normal>
template <class Normals>
bool Sweep<Index, Normal>::sweep(const SweptRow& row, uint32_t words, const RowEnds& ends,
                                 const Normals& normals, const Sink& sink,
                                 Statistics& statistics) {
  if (!delivery_.settle(chains_, sink, statistics)) return false;
  const uint32_t has_y = (row.axes & 2) != 0 ? own_columns : 0;
  const uint32_t has_z = (row.axes & 4) != 0 ? own_columns : 0;
  for (uint32_t word = place_.word; word < words; ++word) {
    Crossings crossings(row, word);
    crossings.of[0] &= ends.are_open ? inner_columns(word, ends.width) : own_columns;
    crossings.of[1] &= has_y;
    crossings.of[2] &= has_z;
    uint32_t voxels = (crossings.of[0] | crossings.of[1] | crossings.of[2]) & ~place_.voxels;
    for (; voxels != 0; voxels &= voxels - 1) {
      const uint32_t bit = trailing_zeros(voxels);
      const Neighbourhood around(row.rows, word, bit);
      uint32_t axes = crossings.axes(bit) & ~place_.axes;
      for (; axes != 0; axes &= axes - 1) {
        const int axis = static_cast<int>(trailing_zeros(axes));
        const uint32_t x = word * columns_per_word + bit - 2;  // -1 wraps
        if (visit(row, ends, around, axis, x, normals, sink, statistics)) continue;
        place_.word = word;
        place_.voxels = ~voxels;
        place_.axes = ~axes;
        return false;
      }
      place_.axes = 0;
    }
    place_.voxels = 0;
  }
  place_ = Place{};
  cells_.add_to(statistics.cells, CountParts::cell);
  facets_.add_to(statistics.facets, CountParts::facet);
  triangles_.add_to(statistics.classic_triangles, CountParts::triangle);
  return true;
}

// Visits the vertex on the edge of voxel x along an axis.
template <class Index, class Normal>
template <class Normals>
bool Sweep<Index, Normal>::visit(const SweptRow& row, const RowEnds& ends,
                                 const Neighbourhood& around, int axis, uint32_t x,
                                 const Normals& normals, const Sink& sink,
                                 Statistics& statistics) {
  Passes passes(sector_table.axis[axis], around.is_on(), around.lines(axis),
                row.absent[axis] | ends.absent(axis, x));
  const Vertex vertex{2 * static_cast<int32_t>(x) + (axis == 0), 2 * row.y + (axis == 1),
                      2 * row.z + (axis == 2)};
  if (row.is_above_slab) return end_above(passes, vertex, sink, statistics);
  if (place_.steps == 0) count(passes.counts());
  uint32_t step = 0;
  Pass pass;
  while (passes.next(pass)) {
    if (++step <= place_.steps) continue;
    chains_.take(pass, vertex, normals);
    if (!chains_.has_outgoing() || delivery_.settle(chains_, sink, statistics)) continue;
    place_.steps = step;
    return false;
  }
  place_.steps = 0;
  return true;
}

// Ends the chains that come up to a vertex of the slice above a slab, and begins those that go down
// from it: two steps a pass.
template <class Index, class Normal>
bool Sweep<Index, Normal>::end_above(Passes& passes, const Vertex& vertex, const Sink& sink,
                                     Statistics& statistics) {
  uint32_t step = 0;
  Pass pass;
  while (passes.next(pass))
    for (int half = 0; half < 2; ++half) {
      if (++step <= place_.steps) continue;
      if (half == 0)
        chains_.end_at(pass, vertex);
      else
        chains_.begin_below(pass, vertex);
      if (delivery_.settle(chains_, sink, statistics)) continue;
      place_.steps = step;
      return false;
    }
  place_.steps = 0;
  return true;
}

}  // namespace discmc::trace

#endif
