// The lookup table: the facets of each of the 256 configurations, one byte per facet. A loop of
// three links is the corner triangle, and a loop of four around one cell edge the rectangle. Every
// other loop is a fan about the centroid. The compiler derives the table from this rule, and
// static_asserts in facet_table.cpp compare it with known facts. Montani, Scateni, Scopigno 1994,
// section 2 and figures 3 and 4.
#ifndef DISCMC_FACET_TABLE_HPP
#define DISCMC_FACET_TABLE_HPP

#include <discmc/geometry/cell.hpp>

namespace discmc {

/// The number of a facet among those of one incidence in a cell, 0 to 7:
///   axis incidences      the direction of the triangle's link of length 2, halved: 4 shapes
///   diagonal incidences  the rectangle cuts off the cell edge: 0 on the on side, 1 on the off side
///   corner incidences    the triangle cuts off a corner: 0 and 1 likewise;
///                        a sector of the hexagon about the centroid: 2 + its outer link's
///                        direction
using Shape = uint8_t;

/// Incidence (upper 5 bits) and shape (lower 3 bits).
using Facet = uint8_t;

constexpr int facet_codes = 256;

constexpr Facet facet_of(Incidence incidence, Shape shape) {
  return static_cast<Facet>(incidence << 3 | shape);
}
constexpr Incidence incidence_of(Facet facet) {
  return facet >> 3;
}
constexpr Shape shape_of(Facet facet) {
  return facet & 7;
}

/// A facet's boundary: its points in the cell, counter-clockwise seen from the tip of the normal.
struct FacetRing {
  uint8_t count;  ///< 3, 4, or 0 for a code that is no facet
  CellPoint point[4];
};

/// The facets of every configuration. Configuration c has facet[first[c]] to facet[first[c + 1] -
/// 1].
struct FacetTable {
  static constexpr int total = 1068;
  uint16_t first[configurations + 1];
  Facet facet[total];
};

/// The boundary of every facet.
struct FacetRings {
  FacetRing ring[facet_codes];
};

/// Counts of each configuration.
struct CellFacts {
  uint8_t facets[configurations];             ///< 0 to 7
  uint8_t classic_triangles[configurations];  ///< of classic Marching Cubes: loop lengths less 2
  uint8_t enclosed[configurations];           ///< volume on the on side; Units: 48ths of a cell
};

extern const FacetTable facet_table;
extern const FacetRings facet_rings;
extern const CellFacts cell_facts;

}  // namespace discmc

#endif
