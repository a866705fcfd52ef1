// What every extraction of a surface must agree on, merged or cut in whatever way.
#pragma once

#include <cstdint>
#include <vector>

#include "region.hpp"
#include "volume.hpp"

namespace discmc::reference {

/// Sums over a surface, each of them the same for its facets, its merged regions and everything in
/// between. The hashes are sums of pseudo-random 64-bit numbers, so equal hashes mean equal
/// surfaces but for a chance of 2^-64.
struct Surface {
  uint64_t boundary;  ///< hash of the directed links by incidence: what one plane leaves over
  uint64_t
      open_links;  ///< hash of the directed links: what the whole surface leaves over, 0 if closed
  uint64_t areas;  ///< hash of the area on every signed plane
  int64_t six_volumes;  ///< Units: cubic half-steps
};

bool operator==(const Surface& a, const Surface& b);
inline bool operator!=(const Surface& a, const Surface& b) {
  return !(a == b);
}

Surface surface_of(const std::vector<Region>& regions);

/// The same, summed over the facets of a volume's cells.
Surface surface_of_cells(const BitVolume& volume, bool is_closed);

/// The summand of the hashes: a pseudo-random number for a directed link, which its opposite
/// cancels. The second function has the number of a link on a plane of an incidence.
uint64_t link_hash(const Vertex& from, const Vertex& to);
uint64_t of_incidence(uint64_t link, Incidence incidence);

/// A sum of links as the fingerprint counts it, so that equal sums of two regions do not add up.
uint64_t mix(uint64_t value);

/// One number for a set of regions: which links bound each of them, whatever the rings. The same
/// for sweep rings and simple rings, as slits cancel.
uint64_t fingerprint(const std::vector<Region>& regions);

/// The fingerprint of a volume's merged surface, straight from the definition of a region: facets
/// joined across shared edges. For volumes of a few voxels; much quicker than merge().
uint64_t fingerprint_of_cells(const BitVolume& volume, bool is_closed);

}  // namespace discmc::reference
