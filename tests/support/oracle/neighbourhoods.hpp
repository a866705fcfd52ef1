// Enumerates all voxels around an edge, and the passes at its vertex.
#pragma once

#include <discmc/trace/passes.hpp>

namespace discmc::reference {

/// Calls visit for the passes of all 131,072 neighbourhoods of an edge along an axis. absent: as
/// for derive_passes().
template <class Visit>
void for_each_neighbourhood(int axis, Visit visit, uint32_t absent = 0) {
  for (uint32_t around = 0; around < 1U << 18; ++around) {
    uint32_t words[9] = {};
    uint32_t voxels = around;
    detail::trace::RowBlock rows;
    for (int row = 0; row < 9; ++row) {
      rows.row[row / 3][row % 3] = &words[row];
      for (int x = 0; x < 3; ++x) {
        const int along = axis == 0 ? x : axis == 1 ? row % 3 : row / 3;
        if (along == 0) continue;
        words[row] |= (voxels & 1) << (x + 1);
        voxels >>= 1;
      }
    }
    constexpr uint32_t middle_bit = 2;
    const int next_row = axis == 0 ? 4 : axis == 1 ? 5 : 7;
    const uint32_t next_bit = axis == 0 ? middle_bit + 1 : middle_bit;
    if ((words[4] >> middle_bit & 1) == (words[next_row] >> next_bit & 1)) continue;
    detail::trace::PassList passes;
    detail::trace::derive_passes({rows, 0, middle_bit, axis}, absent, passes);
    visit(passes);
  }
}

}  // namespace discmc::reference
