#include <discmc/geometry/facet_table.hpp>
#include <discmc/geometry/loop_facets.hpp>

namespace discmc {

namespace {

constexpr bool contains(const FacetRing& ring, CellPoint point) {
  for (int i = 0; i < ring.count; ++i)
    if (ring.point[i] == point) return true;
  return false;
}

constexpr Shape ring_shape(Incidence incidence, const FacetRing& ring) {
  const Vertex n = incidence_normal(incidence);
  const Shape side = dot_product(n, position(ring.point[0]) - position(centroid)) > 0 ? 1 : 0;
  if (!contains(ring, centroid)) return side;
  // A fan's triangle is listed centroid first, so its outer link runs from point 1 to point 2.
  const Direction outer =
      direction_of(incidence, position(ring.point[2]) - position(ring.point[1]));
  return static_cast<Shape>(dot_product(n, n) == 1 ? outer / 2 : 2 + outer);
}

struct FacetList {
  uint8_t count;
  FacetRing ring[Loop::max_points];
};

constexpr FacetList rings_of(const LoopFacets& facets) {
  FacetList list{};
  if (!facets.is_fan) {
    FacetRing& whole = list.ring[list.count++];
    for (int i = 0; i < facets.loop.count; ++i) whole.point[whole.count++] = facets.loop.point[i];
  } else {
    for (int i = 0; i < facets.loop.count; ++i)
      list.ring[list.count++] = {
          3, {centroid, facets.loop.point[i], facets.loop.point[facets.wrap(i + 1)]}};
  }
  return list;
}

struct Derived {
  FacetTable table;
  FacetRings rings;
  CellFacts facts;
};

// Returns twice the area of a face's on part, in square half-steps, by the bits of its corners in
// ring order.
constexpr uint8_t twice_on_area(int on_count, bool is_diagonal) {
  constexpr uint8_t by_count[] = {0, 1, 4, 7, 8};
  return is_diagonal ? 2 : by_count[on_count];
}

// Returns six times the volume of the pyramids from the centroid to the on parts of the faces.
constexpr int face_pyramids(Configuration configuration) {
  int sum = 0;
  for (int face = 0; face < faces; ++face) {
    const detail::derive::FaceCorners ring = detail::derive::face_corners(face);
    bool is_on[4] = {};
    int count = 0;
    for (int i = 0; i < 4; ++i) count += is_on[i] = configuration >> ring.corner[i] & 1;
    sum += twice_on_area(count, count == 2 && is_on[0] == is_on[2]);
  }
  return sum;
}

constexpr int six_volumes(const FacetRing& ring) {
  int sum = 0;
  const Vertex a = position(ring.point[0]) - position(centroid);
  for (int i = 2; i < ring.count; ++i)
    sum += dot_product(a, cross(position(ring.point[i - 1]) - position(centroid),
                                position(ring.point[i]) - position(centroid)));
  return sum;
}

constexpr Derived derive_all() {
  Derived derived{};
  int total = 0;
  for (int c = 0; c < configurations; ++c) {
    derived.table.first[c] = static_cast<uint16_t>(total);
    const Configuration configuration = static_cast<Configuration>(c);
    const Loops loops = detail::derive::loops(configuration);
    int triangles = 0;
    int enclosed = face_pyramids(configuration);
    for (int l = 0; l < loops.count; ++l) {
      triangles += loops.loop[l].count - 2;
      const LoopFacets facets = facets_of(loops.loop[l]);
      const FacetList list = rings_of(facets);
      for (int i = 0; i < list.count; ++i) {
        const Incidence incidence = facets.incidence[i];
        const Facet facet = facet_of(incidence, ring_shape(incidence, list.ring[i]));
        derived.table.facet[total++] = facet;
        derived.rings.ring[facet] = list.ring[i];
        enclosed += six_volumes(list.ring[i]);
      }
    }
    derived.facts.facets[c] = static_cast<uint8_t>(total - derived.table.first[c]);
    derived.facts.classic_triangles[c] = static_cast<uint8_t>(triangles);
    derived.facts.enclosed[c] = static_cast<uint8_t>(enclosed);
  }
  derived.table.first[configurations] = static_cast<uint16_t>(total);
  return derived;
}

constexpr Derived derived = derive_all();

constexpr int configurations_with(int facets) {
  int count = 0;
  for (const uint8_t n : derived.facts.facets) count += n == facets;
  return count;
}

constexpr bool occurs(int squared_length, int times) {
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    const Vertex n = incidence_normal(incidence);
    if (dot_product(n, n) != squared_length) continue;
    int count = 0;
    for (const Facet facet : derived.table.facet) count += incidence_of(facet) == incidence;
    if (count != times) return false;
  }
  return true;
}

constexpr int facets_with_ring() {
  int count = 0;
  for (const FacetRing& ring : derived.rings.ring) count += ring.count != 0;
  return count;
}

static_assert(derived.table.first[configurations] == FacetTable::total, "1068 facets in all");
static_assert(configurations_with(0) == 2 && configurations_with(1) == 40 &&
                  configurations_with(2) == 50 && configurations_with(3) == 8 &&
                  configurations_with(4) == 8 && configurations_with(5) == 48 &&
                  configurations_with(6) == 68 && configurations_with(7) == 32,
              "0 to 7 facets a configuration");
static_assert(occurs(1, 44), "every axis incidence occurs 44 times");
static_assert(occurs(2, 5), "every diagonal incidence occurs 5 times");
static_assert(occurs(3, 93), "every corner incidence occurs 93 times");
static_assert(facets_with_ring() == 6 * 4 + 12 * 2 + 8 * 8, "every shape occurs");
static_assert(derived.facts.enclosed[0] == 0 && derived.facts.enclosed[255] == 48 &&
                  derived.facts.enclosed[1] == 1 && derived.facts.enclosed[254] == 47,
              "the enclosed volume counts 48ths of a cell");

}  // namespace

const FacetTable facet_table = derived.table;
const FacetRings facet_rings = derived.rings;
const CellFacts cell_facts = derived.facts;

}  // namespace discmc
