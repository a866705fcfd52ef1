// The patches of one cell: what it adds to the surface when it stands alone.
//
// The facets of a cell on one plane make one patch, a ring of at most eight links. Where a sink
// takes no fragments and memory is short, rows of cells are cut off: their cells are delivered
// patch by patch, as regions, and take no part in the sweep.
#ifndef DISCMC_TRACE_CELL_PATCHES_HPP
#define DISCMC_TRACE_CELL_PATCHES_HPP

#include <discmc/cell.hpp>
#include <discmc/chain.hpp>

namespace discmc::trace {

struct CellPatch {
  static constexpr int max_runs = 8;
  Incidence incidence;
  Point start;
  uint8_t count;  ///< 0: there is no such patch
  Run run[max_runs];
};

/// What a cell counts: facets, and triangles of classic Marching Cubes.
struct CellCounts {
  uint32_t facets;
  uint32_t classic_triangles;
};

/// The patch of a number, counted from 0. Cost: the loops of the cell, some hundred instructions.
CellPatch cell_patch(Configuration configuration, uint32_t number);

CellCounts cell_counts(Configuration configuration);

}  // namespace discmc::trace

#endif
