// A merged polygon, and comparisons and counts of sets of polygons.
#pragma once

#include <cstdint>
#include <discmc/geometry/facet_table.hpp>
#include <string>
#include <vector>

#include "volume.hpp"

namespace discmc::reference {

/// A closed ring, every vertex of its unit links listed once. Units: half-steps.
using Ring = std::vector<Vertex>;

/// A merged polygon: its outer ring first, counter-clockwise seen from the normal's tip, then
/// holes. The rings of a reference merge are simple: no vertex twice in a ring, though rings may
/// touch.
struct Region {
  Incidence incidence;
  std::vector<Ring> rings;
};

bool operator==(const Region& a, const Region& b);
inline bool operator!=(const Region& a, const Region& b) {
  return !(a == b);
}

/// Compares by z, then y, then x.
bool before(const Vertex& a, const Vertex& b);

/// Returns the regions in an order that depends only on the regions, so that == compares two
/// results. A ring starts at its smallest vertex (by z, y, x); holes and regions are sorted.
std::vector<Region> canonical(std::vector<Region> regions);

/// Describes the first difference of two canonical results, or returns an empty text.
std::string describe_difference(const std::vector<Region>& a, const std::vector<Region>& b);

/// Returns twice a ring's area times the length of the incidence's normal, an integer: positive if
/// the ring is counter-clockwise. Units: square half-steps.
int64_t signed_area(Incidence incidence, const Ring& ring);

/// Counts of a volume's surface.
struct Counts {
  int64_t facets;
  int64_t classic_triangles;  ///< of classic Marching Cubes
  int64_t regions;
  int64_t rings;
  int64_t holes;
  int64_t links;
  int64_t enclosed;     ///< volume by cells. Units: 48ths of a cell
  int64_t six_volumes;  ///< six times the volume of the polygons. Units: cubic half-steps
};

/// A cell has eight cubic half-steps, so `enclosed` and `six_volumes` of a closed surface are equal
/// (a lone voxel: 8). With an open border, only the other counts are meaningful.
Counts counts(const BitVolume& volume, bool is_closed, const std::vector<Region>& regions);

}  // namespace discmc::reference
