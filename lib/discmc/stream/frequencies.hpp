// The frequencies of the symbols of a packet of records (record_model.hpp), in 256ths.
//
// A context is a distribution of symbols. Its entries are cumulative: each is the sum of the
// frequencies of all lower symbols. The entry after a context is 0, which represents 256. The
// frequency of a symbol is the difference to the next entry: at least 1, except for corners that no
// ring has.
#ifndef DISCMC_STREAM_FREQUENCIES_HPP
#define DISCMC_STREAM_FREQUENCIES_HPP

#include <stdint.h>

namespace discmc::detail::stream {

/// The position of a chain's start relative to the vertex coded last: the distance along the row if
/// it is short, otherwise which coordinates follow.
namespace start_position {

constexpr uint32_t ahead = 8;  ///< further in the row
constexpr uint32_t behind = ahead + 1;
constexpr uint32_t next_row = behind + 1;
constexpr uint32_t row_before = next_row + 1;
constexpr uint32_t elsewhere = row_before + 1;
constexpr uint32_t count = elsewhere + 1;

}  // namespace start_position

/// The index of the first context of each kind.
namespace contexts {

constexpr uint32_t of_kinds = 9;  ///< symbols of a context
constexpr uint32_t of_headings = 10;
constexpr uint32_t of_number = 11;
constexpr uint32_t other_heading = of_headings - 1;

constexpr uint32_t kinds = 0;  ///< by preceding fragments
constexpr uint32_t start_positions = kinds + 3 * of_kinds;
constexpr uint32_t axes =
    start_positions + start_position::count;    ///< by same voxel, previous axis
constexpr uint32_t steps_x = axes + 2 * 4 * 4;  ///< by start_position, from `ahead` on
constexpr uint32_t steps_y = steps_x + 5 * of_number;
constexpr uint32_t steps_z = steps_y + of_number;
constexpr uint32_t headings = steps_z + of_number;        ///< by previous heading
constexpr uint32_t lengths = headings + 9 * of_headings;  ///< by kind of link
constexpr uint32_t longer = lengths + 4 * of_number;      ///< likewise
constexpr uint32_t is_last = longer + 4 * of_number;      ///< by chain, level
constexpr uint32_t plain = is_last + 3 * 2 * 2;
constexpr uint32_t of_diagonals = plain + of_number;

// Each class of links has a block of further contexts. First in a block come those that all classes
// have in equal number. Offsets are relative to the block.
constexpr uint32_t ring_direction = 0;
constexpr uint32_t two_lengths = ring_direction + 4;
constexpr uint32_t by_direction = two_lengths + 4 * 4;
// The symbols of these contexts are directions; a context of `turn` has two symbols per direction.
// Offsets count directions, from by_direction on.
constexpr uint32_t cut_turn = 0;  ///< 2, by level
constexpr uint32_t first_direction = cut_turn + 2;
constexpr uint32_t turn = first_direction + 1;  ///< of two; across an axis by parity
// The last context of a block.
constexpr uint32_t corners(uint32_t incidence_class) {
  return by_direction + (4 + 2 * incidence_class) * (turn + (incidence_class == 2 ? 2 * 2 : 2));
}
constexpr uint32_t of_corners(uint32_t incidence_class) {
  return 1 + (incidence_class + 1) * (incidence_class + 1) * (incidence_class + 1);
}

/// Returns the block of a class, or the end for the class after the last.
constexpr uint32_t of_class(uint32_t incidence_class) {
  uint32_t block = of_diagonals;
  for (uint32_t i = 0; i < incidence_class; ++i) block += corners(i) + of_corners(i);
  return block;
}
constexpr uint32_t end = of_class(3);

}  // namespace contexts

extern const uint8_t cumulative_frequencies[contexts::end + 1];

}  // namespace discmc::detail::stream

#endif
