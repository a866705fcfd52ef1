// Sums on which all extractions of a surface must agree, however it is merged or cut.
#pragma once

#include <cstdint>
#include <vector>

#include "region.hpp"
#include "volume.hpp"

namespace discmc::reference {

/// Sums over a surface. They are equal for its facets, its merged regions and everything in
/// between. The hashes are sums of pseudo-random 64-bit numbers, so equal hashes mean equal
/// surfaces, except for a chance of 2^-64.
struct Surface {
  uint64_t boundary;    ///< hash of directed links by incidence: the unpaired links of planes
  uint64_t open_links;  ///< hash of directed links: the unpaired links of the surface, 0 if closed
  uint64_t areas;       ///< hash of the area on every signed plane
  int64_t six_volumes;  ///< Units: cubic half-steps
};

bool operator==(const Surface& a, const Surface& b);
inline bool operator!=(const Surface& a, const Surface& b) {
  return !(a == b);
}

Surface surface_of(const std::vector<Region>& regions);

/// Likewise sums over the facets of a volume's cells.
Surface surface_of_cells(const BitVolume& volume, bool is_closed);

/// Returns the summand of the hashes: a pseudo-random number for a directed link, which its
/// opposite cancels. The second function is for a link on a plane of an incidence.
uint64_t link_hash(const Vertex& from, const Vertex& to);
uint64_t of_incidence(uint64_t link, Incidence incidence);

/// Mixes a sum of links for the fingerprint, so that swapping links between regions changes the
/// total.
uint64_t mix(uint64_t value);

/// Returns a number for a set of regions, by the links that bound each of them, however divided
/// into rings. Sweep rings and simple rings give an equal number, because slits cancel.
uint64_t fingerprint(const std::vector<Region>& regions);

/// Returns the fingerprint of a volume's merged surface, by the definition of a region: facets
/// joined across shared edges. For volumes of a few voxels; much faster than merge().
uint64_t fingerprint_of_cells(const BitVolume& volume, bool is_closed);

}  // namespace discmc::reference
