// The contexts of a packet's symbols (frequencies.hpp), by name.
#pragma once

#include <discmc/stream/frequencies.hpp>

#include <cstdint>
#include <vector>

namespace discmc::reference {

/// Adjacent contexts with the same name and number of symbols.
struct SymbolContexts {
  const char* name;
  uint32_t first;  ///< index of the first context's first entry
  uint32_t count;
  uint32_t symbols;
};

/// Returns all contexts, in the order of the table.
inline std::vector<SymbolContexts> symbol_contexts() {
  namespace of = detail::stream::contexts;
  std::vector<SymbolContexts> all{
      {"kinds", of::kinds, 3, of::of_kinds},
      {"start_positions", of::start_positions, 1, detail::stream::start_position::count},
      {"axes", of::axes, 8, 4},
      {"steps_x", of::steps_x, 5, of::of_number},
      {"steps_y", of::steps_y, 1, of::of_number},
      {"steps_z", of::steps_z, 1, of::of_number},
      {"headings", of::headings, 9, of::of_headings},
      {"lengths", of::lengths, 4, of::of_number},
      {"longer", of::longer, 4, of::of_number},
      {"is_last", of::is_last, 6, 2},
      {"plain", of::plain, 1, of::of_number}};
  for (uint32_t incidence_class = 0; incidence_class < 3; ++incidence_class) {
    const uint32_t first = of::of_class(incidence_class);
    const uint32_t directions = 4 + 2 * incidence_class;
    const auto by_direction = [&](uint32_t context) {
      return first + of::by_direction + directions * context;
    };
    all.push_back({"ring_direction", first + of::ring_direction, 1, 4});
    all.push_back({"two_lengths", first + of::two_lengths, 1, 16});
    all.push_back({"cut_turn", by_direction(of::cut_turn), 2, directions});
    all.push_back({"first_direction", by_direction(of::first_direction), 1, directions});
    all.push_back({"turn", by_direction(of::turn), incidence_class == 2 ? 2U : 1U, 2 * directions});
    all.push_back(
        {"corners", first + of::corners(incidence_class), 1, of::of_corners(incidence_class)});
  }
  return all;
}

/// Whether a ring with these corners exists: three or four corners, each less than half a turn,
/// make a full turn. Symbol 0 is any other ring.
inline bool has_corners(uint32_t incidence_class, uint32_t symbol) {
  if (symbol == 0) return true;
  const uint32_t directions = 4 + 2 * incidence_class;
  const uint32_t turns = directions / 2 - 1;
  const uint32_t code = symbol - 1;
  const uint32_t sum = 3 + code % turns + code / turns % turns + code / turns / turns;
  return sum == directions || (sum < directions && directions - sum <= turns);
}

}  // namespace discmc::reference
