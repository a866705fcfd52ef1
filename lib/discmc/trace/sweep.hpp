// The sweep: visits the vertices of a row and hands their passes to the fragments.
//
// A vertex is visited with the voxel at the lower end of its edge: voxels as they come, and
// at each its edges in the same order. The sweep may be suspended between any two passes.
#ifndef DISCMC_TRACE_SWEEP_HPP
#define DISCMC_TRACE_SWEEP_HPP

#include <discmc/compiler.hpp>
#include <discmc/trace/delivery.hpp>
#include <discmc/trace/passes.hpp>

namespace discmc::trace {

/// What is done at the vertices of a row.
enum class RowWork : uint8_t {
  take_passes,
  end_chains,   ///< above a slab: the chains that come up to it end,
  begin_chains  ///< and those that go down from it begin
};

/// A row of voxels and what of its surroundings takes part.
struct SweptRow {
  RowBlock rows;
  RowWork work;
  int32_t y, z;
  uint32_t absent[3];  ///< by axis of an edge: quadrants whose row of cells takes no part
  uint32_t axes;       ///< whose edges are there, a bit each

  /// cells: of the four rows of cells around, a bit each: 2 * layer + row.
  void set_absent(uint32_t cells) {
    const uint32_t front_below = cells & 1, back_below = cells >> 1 & 1;
    const uint32_t front_above = cells >> 2 & 1, back_above = cells >> 3;
    absent[0] = back_above | front_above << 1 | front_below << 2 | back_below << 3;
    absent[1] = 9 * back_above | 6 * back_below;
    absent[2] = 3 * back_above | 12 * front_above;
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

template <class Index, class Normal, class Passes>
class Sweep {
 public:
  Fragments<Index, Normal>& fragments() { return fragments_; }
  Delivery<Index, Normal>& delivery() { return delivery_; }
  Passes& passes() { return passes_; }
  /// After the last vertex: delivers holes that still wait, loose. As sweep().
  bool settle_holes(const Sink& sink, Statistics& statistics) {
    return delivery_.settle_holes(fragments_, sink, statistics);
  }
  const Fragments<Index, Normal>& fragments() const { return fragments_; }
  const Delivery<Index, Normal>& delivery() const { return delivery_; }

  void clear() {
    fragments_.clear();
    delivery_.clear();
    cells_ = facets_ = triangles_ = {};
    suspension_ = Suspension{};
  }

  /// Sweeps a row, or goes on with it. False when the sink said "not now": call again.
  template <class Normals>
  bool sweep(const SweptRow& row, uint32_t words, const RowEnds& ends, const Normals& normals,
             const Sink& sink, Statistics& statistics);

 private:
  // A row, and all that its vertices have in common.
  template <class Normals>
  struct Visits {
    const SweptRow& row;
    RowEnds ends;
    const Normals& normals;
    const Sink& sink;
    Statistics& statistics;
    Vertex first[3];  // the vertex of voxel 0, by axis
  };
  template <class Normals>
  bool visit(const Visits<Normals>& visits, uint32_t word, uint32_t bit, int axis);
  template <class Normals>
  void pass_through(const Visits<Normals>& visits, const Pass& pass, const Vertex& vertex);
  void count(uint32_t parts) {
    constexpr uint32_t facet = CountParts::facet_shift, triangle = CountParts::triangle_shift;
    cells_.add(parts & ((1U << facet) - 1));
    facets_.add(parts >> facet & ((1U << (triangle - facet)) - 1));
    triangles_.add(parts >> triangle);
  }

  // Where the sweep of a row was suspended: the word, the edges in it that have been visited, and
  // how many of the passes at the next vertex are done, if it has begun.
  struct Suspension {
    uint32_t word = 0;
    uint32_t visited[3] = {};  // by axis
    uint32_t passes = 0;
  };
  Suspension suspension_;
  PartCount cells_, facets_, triangles_;
  Fragments<Index, Normal> fragments_;
  Delivery<Index, Normal> delivery_;
  Passes passes_;
};

// ---- implementation ----

/// Bits of the voxels in a word whose edges cross, by axis.
struct Crossings {
  uint32_t of[3];

  Crossings(const RowBlock& rows, uint32_t word) {
    const uint32_t here = rows.row[1][1][word];
    of[0] = here ^ here >> 1;
    of[1] = here ^ rows.row[1][2][word];
    of[2] = here ^ rows.row[2][1][word];
  }
  uint32_t voxels() const { return of[0] | of[1] | of[2]; }
};

template <class Index, class Normal, class Passes>
template <class Normals>
bool Sweep<Index, Normal, Passes>::sweep(const SweptRow& row, uint32_t words, const RowEnds& ends,
                                         const Normals& normals, const Sink& sink,
                                         Statistics& statistics) {
  if (!delivery_.settle(fragments_, sink, statistics)) return false;
  const int32_t y = 2 * row.y, z = 2 * row.z;
  const Visits<Normals> visits{row,  ends,       normals,
                               sink, statistics, {{1, y, z}, {0, y + 1, z}, {0, y, z + 1}}};
  const uint32_t has_y = (row.axes & 2) != 0 ? own_columns : 0;
  const uint32_t has_z = (row.axes & 4) != 0 ? own_columns : 0;
  for (uint32_t word = suspension_.word; word < words; ++word) {
    Crossings crossings(row.rows, word);
    if ((crossings.voxels() & own_columns) == 0) continue;
    crossings.of[0] &= ends.are_open ? inner_columns(word, ends.width) : own_columns;
    crossings.of[1] &= has_y;
    crossings.of[2] &= has_z;
    for (int axis = 0; axis < 3; ++axis) crossings.of[axis] &= ~suspension_.visited[axis];
    for (uint32_t voxels = crossings.voxels(); voxels != 0; voxels &= voxels - 1) {
      const uint32_t bit = trailing_zeros(voxels);
      for (int axis = 0; axis < 3; ++axis) {
        if ((crossings.of[axis] >> bit & 1) == 0 || visit(visits, word, bit, axis)) continue;
        suspension_.word = word;
        for (int i = 0; i < 3; ++i)
          suspension_.visited[i] = (uint32_t{1} << bit) * (i < axis ? 2 : 1) - 1;
        return false;
      }
    }
    for (uint32_t& visited : suspension_.visited) visited = 0;
  }
  suspension_.word = 0;
  cells_.add_to(statistics.cells, CountParts::cell);
  facets_.add_to(statistics.facets, CountParts::facet);
  triangles_.add_to(statistics.classic_triangles, CountParts::triangle);
  return true;
}

// Visits the vertex on the edge along an axis of the voxel at a bit of a word.
template <class Index, class Normal, class Passes>
template <class Normals>
bool Sweep<Index, Normal, Passes>::visit(const Visits<Normals>& visits, uint32_t word, uint32_t bit,
                                         int axis) {
  const uint32_t x = word * columns_per_word + bit - 2;  // -1 wraps
  const Vertex& first = visits.first[axis];
  const Vertex vertex{first.x + 2 * static_cast<int32_t>(x), first.y, first.z};
  PassList scratch;
  const PassList& passes =
      passes_.at({visits.row.rows, word, bit, axis},
                 visits.row.absent[axis] | visits.ends.absent(axis, x), scratch);
  if (suspension_.passes == 0 && visits.row.work == RowWork::take_passes) count(passes.parts);
  for (uint32_t i = suspension_.passes; i < passes.count; ++i) {
    pass_through(visits, passes.pass[i], vertex);
    if (!fragments_.has_outgoing() || delivery_.settle(fragments_, visits.sink, visits.statistics))
      continue;
    suspension_.passes = i + 1;
    return false;
  }
  suspension_.passes = 0;
  return true;
}

template <class Index, class Normal, class Passes>
template <class Normals>
void Sweep<Index, Normal, Passes>::pass_through(const Visits<Normals>& visits, const Pass& pass,
                                                const Vertex& vertex) {
  if (visits.row.work == RowWork::take_passes)
    fragments_.take(pass, vertex, visits.normals);
  else if (visits.row.work == RowWork::end_chains)
    fragments_.end_at(pass, vertex);
  else
    fragments_.begin_below(pass, vertex);
}

}  // namespace discmc::trace

#endif
