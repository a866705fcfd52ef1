// The 27 voxels around one, and the lines around the three crossing edges that begin at it.
#ifndef DISCMC_TRACE_NEIGHBOURHOOD_HPP
#define DISCMC_TRACE_NEIGHBOURHOOD_HPP

#include <discmc/trace/bit_rows.hpp>

namespace discmc::trace {

/// Where the voxels of a row, at x - 1, x and x + 1, stand among the lines of a ring: the lower
/// bits of these lines, by the three bits of the row.
struct LineBits {
  uint16_t of[8];
};

namespace derive {

// line: of each voxel, or 8 for the one in the middle, which is none of the ring.
constexpr LineBits line_bits(int left, int middle, int right) {
  LineBits bits{};
  const int line[] = {left, middle, right};
  for (int row = 0; row < 8; ++row)
    for (int i = 0; i < 3; ++i)
      if ((row >> i & 1) != 0 && line[i] < 8)
        bits.of[row] = static_cast<uint16_t>(bits.of[row] | 1 << 2 * line[i]);
  return bits;
}

}  // namespace derive

/// [0]: the row of the lines farther along u, [1]: that of the edge, [2]: the one before.
inline constexpr LineBits lines_of_y[3] = {derive::line_bits(7, 0, 1), derive::line_bits(6, 8, 2),
                                           derive::line_bits(5, 4, 3)};
/// The same of v for edges along z, whose u is x.
inline constexpr LineBits lines_of_z[3] = {derive::line_bits(3, 2, 1), derive::line_bits(4, 8, 0),
                                           derive::line_bits(5, 6, 7)};

class Neighbourhood {
 public:
  /// bit: of the voxel in its word, 1 to 30.
  Neighbourhood(const RowBlock& rows, uint32_t word, uint32_t bit) {
    const uint32_t shift = bit - 1;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
#pragma GCC unroll 3
      for (int j = 0; j < 3; ++j) row_[k][j] = rows.row[k][j][word] >> shift & 7;
  }

  bool is_on() const { return (row_[1][1] & 2) != 0; }

  /// The lines around the edge to the next voxel along x, y or z (sector_table.hpp).
  uint32_t lines(int axis) const {
    if (axis == 0)
      return row_[1][2] >> 1 | (row_[2][2] & 6) << 1 | (row_[2][1] & 6) << 3 |
             (row_[2][0] & 6) << 5 | (row_[1][0] & 6) << 7 | (row_[0][0] & 6) << 9 |
             (row_[0][1] & 6) << 11 | (row_[0][2] & 6) << 13;
    if (axis == 1)
      return pair(lines_of_y[0], row_[2][1], row_[2][2]) |
             pair(lines_of_y[1], row_[1][1], row_[1][2]) |
             pair(lines_of_y[2], row_[0][1], row_[0][2]);
    return pair(lines_of_z[0], row_[1][2], row_[2][2]) |
           pair(lines_of_z[1], row_[1][1], row_[2][1]) |
           pair(lines_of_z[2], row_[1][0], row_[2][0]);
  }

 private:
  static uint32_t pair(const LineBits& bits, uint32_t lower, uint32_t upper) {
    return bits.of[lower] | uint32_t{bits.of[upper]} << 1;
  }

  uint32_t row_[3][3];  // [z - 1, z, z + 1][y - 1, y, y + 1]: bits of x - 1, x, x + 1
};

}  // namespace discmc::trace

#endif
