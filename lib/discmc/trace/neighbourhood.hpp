// Finds the circle of lines around a crossing edge (sector_table.hpp) in rows of bits.
#ifndef DISCMC_TRACE_NEIGHBOURHOOD_HPP
#define DISCMC_TRACE_NEIGHBOURHOOD_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/trace/bit_rows.hpp>

namespace discmc::detail::trace {

/// The lower bits of a circle's lines, by the three bits of a row at x - 1, x and x + 1.
struct LineBits {
  uint16_t by_row[8];
};

namespace derive {

// The line of each voxel; 8 for the middle voxel, which is not on the circle.
constexpr LineBits line_bits(int left, int middle, int right) {
  LineBits bits{};
  const int line[] = {left, middle, right};
  for (int row = 0; row < 8; ++row)
    for (int i = 0; i < 3; ++i)
      if ((row >> i & 1) != 0 && line[i] < 8)
        bits.by_row[row] = static_cast<uint16_t>(bits.by_row[row] | 1 << 2 * line[i]);
  return bits;
}

}  // namespace derive

/// For edges along y: [0] the row after the edge along u, [1] the row of the edge, [2] the row
/// before it.
inline constexpr LineBits lines_of_y[3] = {derive::line_bits(7, 0, 1), derive::line_bits(6, 8, 2),
                                           derive::line_bits(5, 4, 3)};
/// For edges along z, whose u is x: likewise along v.
inline constexpr LineBits lines_of_z[3] = {derive::line_bits(3, 2, 1), derive::line_bits(4, 8, 0),
                                           derive::line_bits(5, 6, 7)};

/// The edge along an axis from a voxel to the next one, among rows of bits.
struct RowEdge {
  const RowBlock& rows;
  uint32_t word;
  uint32_t bit;  ///< of the voxel in its word, 1 to 30
  int axis;

  DISCMC_ALWAYS_INLINE bool lower_is_on() const { return (rows.row[1][1][word] >> bit & 1) != 0; }
  /// Returns the circle of lines around the edge, two bits per line.
  uint32_t lines() const;

 private:
  // Returns the line along x in a row of the block.
  DISCMC_ALWAYS_INLINE uint32_t line(int k, int j) const { return rows.row[k][j][word] >> bit & 3; }
  // Returns the lines from one row to another.
  DISCMC_ALWAYS_INLINE uint32_t pair(const LineBits& bits, const uint32_t* lower,
                                     const uint32_t* upper) const {
    const uint32_t shift = bit - 1;
    return bits.by_row[lower[word] >> shift & 7] | uint32_t{bits.by_row[upper[word] >> shift & 7]}
                                                       << 1;
  }
};

DISCMC_ALWAYS_INLINE uint32_t RowEdge::lines() const {
  const auto& row = rows.row;
  if (axis == 0)
    return line(1, 2) | line(2, 2) << 2 | line(2, 1) << 4 | line(2, 0) << 6 | line(1, 0) << 8 |
           line(0, 0) << 10 | line(0, 1) << 12 | line(0, 2) << 14;
  if (axis == 1)
    return pair(lines_of_y[0], row[2][1], row[2][2]) | pair(lines_of_y[1], row[1][1], row[1][2]) |
           pair(lines_of_y[2], row[0][1], row[0][2]);
  return pair(lines_of_z[0], row[1][2], row[2][2]) | pair(lines_of_z[1], row[1][1], row[2][1]) |
         pair(lines_of_z[2], row[1][0], row[2][0]);
}

}  // namespace discmc::detail::trace

#endif
