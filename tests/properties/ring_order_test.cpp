// The fact behind the proof that the outer ring of a region closes after its holes: lib/DESIGN.md,
// "Rings, holes and regions".
#include <discmc/geometry/facet_table.hpp>
#include <discmc/trace/sector_derivation.hpp>

#include "test.hpp"

namespace {

using namespace discmc;
using detail::trace::derive::is_visited_before;

using Polygon = std::vector<Vertex>;

bool is_even(int32_t value) {
  return value % 2 == 0;
}

// Midpoints have one odd coordinate, centroids three.
bool is_midpoint(const Vertex& v) {
  return is_even(v.x) + is_even(v.y) + is_even(v.z) == 2;
}

// All facets of an incidence in the cells within a distance of the origin.
std::vector<Polygon> facets_near(Incidence incidence, int cells) {
  std::vector<Polygon> facets;
  for (Shape shape = 0; shape < 8; ++shape) {
    const FacetRing& ring = facet_rings.ring[facet_of(incidence, shape)];
    if (ring.count == 0) continue;
    for (int z = -cells; z <= cells; ++z)
      for (int y = -cells; y <= cells; ++y)
        for (int x = -cells; x <= cells; ++x) {
          facets.emplace_back();
          for (int i = 0; i < ring.count; ++i)
            facets.back().push_back(position(ring.point[i]) + Vertex{2 * x, 2 * y, 2 * z});
        }
  }
  return facets;
}

// Whether a facet has a point v + t way with 0 < t <= 1. A point is on the left of a side if a + b
// t >= 0. If any t is a solution, so is t = 1, or a t at which the way meets a side.
bool meets(const Polygon& facet, const Vertex& n, const Vertex& v, const Vertex& way) {
  struct Line {
    int32_t a, b;
  };
  std::vector<Line> sides;
  for (std::size_t i = 0; i < facet.size(); ++i) {
    const Vertex side = facet[(i + 1) % facet.size()] - facet[i];
    sides.push_back({dot_product(n, cross(side, v - facet[i])), dot_product(n, cross(side, way))});
  }
  const auto holds = [&sides](int32_t above, int32_t below) {
    for (const Line& side : sides)
      if (side.a * below + side.b * above < 0) return false;
    return true;
  };
  if (holds(1, 1)) return true;
  for (const Line& side : sides) {
    const int32_t above = side.b < 0 ? side.a : -side.a;
    const int32_t below = side.b < 0 ? -side.b : side.b;
    if (0 < above && above <= below && holds(above, below)) return true;
  }
  return false;
}

bool has_later_midpoint(const Polygon& facet, const Vertex& v) {
  for (const Vertex& vertex : facet)
    if (is_midpoint(vertex) && is_visited_before(v, vertex)) return true;
  return false;
}

// Whether the way meets only facets that the sweep has not completed at v.
bool leads_out(const std::vector<Polygon>& plane, const Vertex& n, const Vertex& v,
               const Vertex& way) {
  for (const Polygon& facet : plane)
    if (meets(facet, n, v, way) && !has_later_midpoint(facet, v)) return false;
  return true;
}

bool has_way_out(const std::vector<Polygon>& plane, const Vertex& n, const Vertex& v) {
  constexpr int longest = 2;
  for (int z = 0; z <= longest; ++z)
    for (int y = -longest; y <= longest; ++y)
      for (int x = -longest; x <= longest; ++x) {
        const Vertex way{2 * x, 2 * y, 2 * z};
        if (precedes({0, 0, 0}, way) && dot_product(way, n) == 0 && leads_out(plane, n, v, way))
          return true;
      }
  return false;
}

}  // namespace

TEST_CASE(
    "a straight path leads from each midpoint out of the facets of its plane visited before") {
  int planes = 0;
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    if (incidence == no_incidence) continue;
    const Vertex n = incidence_normal(incidence);
    const std::vector<Polygon> facets = facets_near(incidence, 4);
    for (const Vertex v : {Vertex{1, 0, 0}, Vertex{0, 1, 0}, Vertex{0, 0, 1}}) {
      std::vector<Polygon> plane;
      for (const Polygon& facet : facets)
        if (dot_product(n, facet[0]) == dot_product(n, v)) plane.push_back(facet);
      if (plane.empty()) continue;
      INFO(n.x, " ", n.y, " ", n.z, " from ", v.x, " ", v.y, " ", v.z);
      CHECK(has_way_out(plane, n, v));
      ++planes;
    }
  }
  CHECK(planes == 6 + 12 * 2 + 8 * 3);
}
