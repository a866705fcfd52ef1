// How likely the symbols of a packet of records are (record_model.hpp).
//
// A row tells of each symbol how much lies below it, in 256ths; what follows a row begins with 0,
// which stands for 256. A symbol's share is the difference to what follows. Shares are at least 1,
// but for corners that no ring has.
#ifndef DISCMC_STREAM_SHARES_HPP
#define DISCMC_STREAM_SHARES_HPP

#include <stdint.h>

namespace discmc::stream {

/// Where a chain begins, seen from the vertex told last: how many voxels further in the row, if
/// they are few, or how much of the way is told.
namespace place {

constexpr uint32_t ahead = 8;  ///< further in the row
constexpr uint32_t behind = ahead + 1;
constexpr uint32_t next_row = behind + 1;
constexpr uint32_t row_before = next_row + 1;
constexpr uint32_t elsewhere = row_before + 1;
constexpr uint32_t count = elsewhere + 1;

}  // namespace place

/// Where the rows are, by what they tell.
namespace rows {

constexpr uint32_t of_kinds = 9;  ///< symbols of a row
constexpr uint32_t of_headings = 10;
constexpr uint32_t of_number = 11;
constexpr uint32_t other_heading = of_headings - 1;

constexpr uint32_t kinds = 0;  ///< by what came before
constexpr uint32_t places = kinds + 3 * of_kinds;
constexpr uint32_t axes = places + place::count;  ///< by same voxel, axis before
constexpr uint32_t steps_x = axes + 2 * 4 * 4;    ///< by place, from `ahead` on
constexpr uint32_t steps_y = steps_x + 5 * of_number;
constexpr uint32_t steps_z = steps_y + of_number;
constexpr uint32_t headings = steps_z + of_number;        ///< by heading before
constexpr uint32_t lengths = headings + 9 * of_headings;  ///< by kind of link
constexpr uint32_t longer = lengths + 4 * of_number;      ///< likewise
constexpr uint32_t is_last = longer + 4 * of_number;      ///< by chain, level
constexpr uint32_t plain = is_last + 3 * 2 * 2;
constexpr uint32_t of_diagonals = plain + of_number;

// The others stand together for each class: first those that are as long in each.
constexpr uint32_t ring_direction = 0;
constexpr uint32_t two_lengths = ring_direction + 4;
constexpr uint32_t by_direction = two_lengths + 4 * 4;
// Then rows of a symbol for each direction, or two; their places are counted in rows of one.
constexpr uint32_t cut_turn = 0;  ///< 2, by level
constexpr uint32_t first_direction = cut_turn + 2;
constexpr uint32_t turn = first_direction + 1;  ///< of two; across an axis by parity
// And a row of corners.
constexpr uint32_t corners(uint32_t link_class) {
  return by_direction + (4 + 2 * link_class) * (turn + (link_class == 2 ? 2 * 2 : 2));
}
constexpr uint32_t of_corners(uint32_t link_class) {
  return 1 + (link_class + 1) * (link_class + 1) * (link_class + 1);
}

/// Where a class begins; of a class more, the end.
constexpr uint32_t of_class(uint32_t link_class) {
  uint32_t row = of_diagonals;
  for (uint32_t i = 0; i < link_class; ++i) row += corners(i) + of_corners(i);
  return row;
}
constexpr uint32_t end = of_class(3);

}  // namespace rows

extern const uint8_t shares[rows::end + 1];

}  // namespace discmc::stream

#endif
