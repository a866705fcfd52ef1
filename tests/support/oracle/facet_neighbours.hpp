// Finds the facet on the other side of an edge, by which the paper merges regions.
#pragma once

#include <array>
#include <discmc/geometry/facet_table.hpp>

namespace discmc::reference {

/// The facet on the other side of a facet's edge, if it belongs to the same plane.
struct Neighbour {
  Vertex cell;  ///< its cell, as an offset in cells; (0, 0, 0) for the same cell
  Facet facet;
};

inline bool has_edge(const FacetRing& ring, const Vertex& from, const Vertex& to) {
  for (int i = 0; i < ring.count; ++i)
    if (position(ring.point[i]) == from && position(ring.point[(i + 1) % ring.count]) == to)
      return true;
  return false;
}

/// Returns the facet of equal incidence that shares edge `edge` (from point edge of the facet's
/// ring to the next) with `facet`. It is unique, whether or not a configuration contains it. Limit:
/// edge < facet_rings.ring[facet].count. Cost: a search.
inline Neighbour across_edge(Facet facet, int edge) {
  constexpr Vertex cells[] = {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0},
                              {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  const FacetRing& ring = facet_rings.ring[facet];
  const Vertex from = position(ring.point[edge]);
  const Vertex to = position(ring.point[(edge + 1) % ring.count]);
  for (const Vertex& cell : cells)
    for (Shape shape = 0; shape < 8; ++shape) {
      const Facet other = facet_of(incidence_of(facet), shape);
      const Vertex shift = cell + cell;
      if (has_edge(facet_rings.ring[other], to - shift, from - shift)) return {cell, other};
    }
  return {{0, 0, 0}, facet};
}

/// Returns the same from the paper's table of adjacent shapes.
inline const Neighbour& tabulated_neighbour(Facet facet, int edge) {
  static const auto table = [] {
    std::array<std::array<Neighbour, 4>, facet_codes> all{};
    for (size_t code = 0; code < facet_codes; ++code)
      for (int i = 0; i < facet_rings.ring[code].count; ++i)
        all[code][static_cast<size_t>(i)] = across_edge(static_cast<Facet>(code), i);
    return all;
  }();
  return table[facet][static_cast<size_t>(edge)];
}

}  // namespace discmc::reference
