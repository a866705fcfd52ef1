// The facets behind a loop: a single facet, or a fan about the centroid.
#ifndef DISCMC_GEOMETRY_LOOP_FACETS_HPP
#define DISCMC_GEOMETRY_LOOP_FACETS_HPP

#include <discmc/geometry/cell.hpp>

namespace discmc {

constexpr int sign_of(int value) {
  return (value > 0) - (value < 0);
}

constexpr Incidence incidence_of_facet(const Vertex& a, const Vertex& b, const Vertex& c) {
  const Vertex n = cross(b - a, c - a);
  return incidence_of(Vertex{sign_of(n.x), sign_of(n.y), sign_of(n.z)});
}

/// A loop with the incidences of the facets behind each of its links. Indexes of links and points
/// wrap, and may be as low as -count.
struct LoopFacets {
  Loop loop;
  bool is_fan;
  Incidence incidence[Loop::max_points];

  constexpr int wrap(int i) const {
    return i < 0 ? i + loop.count : i < loop.count ? i : i - loop.count;
  }
  constexpr Vertex at(int i) const { return position(loop.point[wrap(i)]); }
  constexpr Incidence behind(int link) const { return incidence[wrap(link)]; }
};

constexpr LoopFacets facets_of(const Loop& loop) {
  LoopFacets facets{loop, false, {}};
  const Incidence whole = incidence_of_facet(facets.at(0), facets.at(1), facets.at(2));
  const Vertex n = incidence_normal(whole);
  const bool is_rectangle = loop.count == 4 && dot_product(n, n) == 2;
  facets.is_fan = loop.count != 3 && !is_rectangle;
  for (int i = 0; i < loop.count; ++i)
    facets.incidence[i] =
        facets.is_fan ? incidence_of_facet(position(centroid), facets.at(i), facets.at(i + 1))
                      : whole;
  return facets;
}

}  // namespace discmc

#endif
