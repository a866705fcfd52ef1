// The reference: the paper's own Merge, over a whole volume in memory.
//
// Montani, Scateni, Scopigno, "Discretized Marching Cubes", IEEE Visualization 1994, figure 5: all
// facets of the volume wait in hash tables, one an incidence; a facet taken out grows into a region
// over a stack of edges; connecting links are removed; what is left is chained into rings. It is
// written to be read beside the paper and shares nothing with the library's sweep but the table.
#ifndef DISCMC_TESTS_ORACLE_MERGE_HPP
#define DISCMC_TESTS_ORACLE_MERGE_HPP

#include <discmc/geometry/facet_table.hpp>
#include <vector>

#include "region.hpp"
#include "volume.hpp"

namespace discmc::reference {

/// Extracts and merges the surface of a volume.
/// `closed` adds a halo of off voxels, else the surface ends at the outermost voxels.
/// `table` is there for tests that want to see a wrong one fail.
std::vector<Region> merge(const BitVolume& volume, bool closed,
                          const FacetTable& table = facet_table);

}  // namespace discmc::reference

#endif
