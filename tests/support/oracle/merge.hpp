// The reference: the paper's own Merge, over a whole volume in memory.
//
// Montani, Scateni, Scopigno, "Discretized Marching Cubes", IEEE Visualization 1994, figure 5.
// All facets of the volume wait in hash tables, one per incidence. A facet grows into a region over
// a stack of edges. Connecting links are removed, and the remaining links are chained into rings.
// The code follows the paper and shares only the table with the library's sweep.
#pragma once

#include <discmc/geometry/facet_table.hpp>
#include <vector>

#include "region.hpp"
#include "volume.hpp"

namespace discmc::reference {

/// Extracts and merges the surface of a volume. `closed` adds a halo of off voxels; otherwise the
/// surface ends at the outermost voxels. `table`: tests pass wrong tables and expect a failure.
std::vector<Region> merge(const BitVolume& volume, bool is_closed,
                          const FacetTable& table = facet_table);

}  // namespace discmc::reference
