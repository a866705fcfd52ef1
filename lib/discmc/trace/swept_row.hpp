// A row of voxels for the sweep: its crossing edges, and the participating cells around them.
//
// A vertex is visited with the voxel at the lower end of its edge. Voxels are visited in order of
// arrival, and the edges of each in the order of their axes.
#ifndef DISCMC_TRACE_SWEPT_ROW_HPP
#define DISCMC_TRACE_SWEPT_ROW_HPP

#include <discmc/sink.hpp>
#include <discmc/trace/bit_rows.hpp>
#include <discmc/trace/sector_table.hpp>

namespace discmc::detail::trace {

/// The slice of a row, relative to a slab.
enum class SlabRole : uint8_t {
  inside,
  first_of_slab,  ///< chains from below belong to another slab
  below_slab,     ///< the context slice below a slab
  above_slab,     ///< the context slice above a slab
};

/// A row of voxels and its participating surroundings.
struct SweptRow {
  RowBlock around;
  uint32_t words;
  uint32_t width;
  int32_t y, z;
  uint32_t absent_rows;  ///< rows of cells (CellRowBits) that do not participate
  SlabRole role;
  bool has_open_ends;           ///< whether its first and last columns are those of an open border
  bool has_y, has_z;            ///< whether edges along y and z are visited
  uint8_t absent_quadrants[3];  ///< by axis of an edge: quadrants whose row of cells does not
                                ///< participate

  /// Whether the slice is not context.
  bool is_own() const { return role <= SlabRole::first_of_slab; }
  /// Sets the members that follow from absent_rows. Edges along y are visited if cells behind
  /// participate, edges along z if cells above do.
  void set_absent_quadrants() {
    has_y = (absent_rows & CellRowBits::back) != CellRowBits::back;
    has_z = (absent_rows & CellRowBits::above) != CellRowBits::above;
    const uint32_t front_below = absent_rows & 1, back_below = absent_rows >> 1 & 1;
    const uint32_t front_above = absent_rows >> 2 & 1, back_above = absent_rows >> 3;
    absent_quadrants[0] =
        static_cast<uint8_t>(back_above | front_above << 1 | front_below << 2 | back_below << 3);
    absent_quadrants[1] = static_cast<uint8_t>(9 * back_above | 6 * back_below);
    absent_quadrants[2] = static_cast<uint8_t>(3 * back_above | 12 * front_above);
  }
  /// Returns a bit per quadrant without a cell around an edge of the voxel at x.
  uint32_t absent_at(int axis, uint32_t x) const {
    uint32_t absent = absent_quadrants[axis];
    if (!has_open_ends || (x != 0 && x + 1 != width) || axis == 0) return absent;
    const uint32_t before = axis == 1 ? 12 : 6;
    if (x == 0) absent |= before;
    if (x + 1 == width) absent |= before ^ 15;
    return absent;
  }
  /// Returns the vertex on an edge of the voxel at x (-1 wraps).
  Vertex vertex(int axis, uint32_t x) const {
    return {2 * static_cast<int32_t>(x) + (axis == 0 ? 1 : 0), 2 * y + (axis == 1 ? 1 : 0),
            2 * z + (axis == 2 ? 1 : 0)};
  }
};

/// Returns the column of a voxel, by its word and bit. -1 wraps.
constexpr uint32_t column_of(uint32_t word, uint32_t bit) {
  return word * columns_per_word + bit - 2;
}

/// The edges that cross, for the voxels in a word.
struct CrossingEdges {
  uint32_t by_axis[3];  ///< a bit per voxel at the lower end of such an edge

  uint32_t voxels() const { return by_axis[0] | by_axis[1] | by_axis[2]; }

  /// Returns false if there are none; then nothing changes.
  template <bool has_absent_cells = true>
  bool find(const SweptRow& row, uint32_t word) {
    const auto& rows = row.around.row;
    const uint32_t here = rows[1][1][word];
    const uint32_t x = here ^ here >> 1;
    const uint32_t y = here ^ rows[1][2][word];
    const uint32_t z = here ^ rows[2][1][word];
    if (((x | y | z) & own_columns) == 0) return false;
    by_axis[0] =
        x & (has_absent_cells && row.has_open_ends ? inner_columns(word, row.width) : own_columns);
    by_axis[1] = !has_absent_cells || row.has_y ? y & own_columns : 0;
    by_axis[2] = !has_absent_cells || row.has_z ? z & own_columns : 0;
    return true;
  }
};

/// Counts cells from the parts that vertices add (CountParts).
class SweepCounts {
 public:
  void add(uint32_t parts) {
    constexpr uint32_t facet = CountParts::facet_shift, triangle = CountParts::triangle_shift;
    add(parts & ((1U << facet) - 1), parts >> facet & ((1U << (triangle - facet)) - 1),
        parts >> triangle);
  }
  void add(uint32_t cells, uint32_t facets, uint32_t triangles) {
    cells_ += cells;
    facets_ += facets;
    triangles_ += triangles;
  }
  /// Moves whole counts to the statistics.
  void add_to(Statistics& statistics) {
    carry_whole(cells_, CountParts::cell, statistics.cells);
    carry_whole(facets_, CountParts::facet, statistics.facets);
    carry_whole(triangles_, CountParts::triangle, statistics.classic_triangles);
  }

  /// Returns the parts that do not make a whole triangle, after add_to().
  uint32_t triangle_parts() const { return triangles_; }

 private:
  static void carry_whole(uint32_t& parts, uint32_t parts_per_whole, uint64_t& total) {
    if constexpr (has_division) {
      total += parts / parts_per_whole;
      parts %= parts_per_whole;
    } else {
      uint32_t divisor = parts_per_whole, count = 1, whole = 0;
      for (; divisor <= parts; divisor <<= 1) count <<= 1;
      for (; count != 0; divisor >>= 1, count >>= 1)
        if (parts >= divisor) {
          parts -= divisor;
          whole += count;
        }
      total += whole;
    }
  }
  uint32_t cells_ = 0, facets_ = 0, triangles_ = 0;
};

}  // namespace discmc::detail::trace

#endif
