// The existing facets, their numbers and their symmetry; by exhaustion. The compiler counts them
// (facet_table.cpp), and properties/tables_test compares them with the loops of their cells.
#include <discmc/geometry/facet_table.hpp>

#include "oracle/cell_symmetry.hpp"
#include "test.hpp"

using namespace discmc;
using test::cell_symmetries;
using test::CellSymmetry;

namespace {

constexpr Vertex middle{1, 1, 1};

std::vector<Facet> facets_of(int configuration) {
  return {facet_table.facet + facet_table.first[configuration],
          facet_table.facet + facet_table.first[configuration + 1]};
}

std::vector<CellPoint> ring_of(Facet facet) {
  const FacetRing& ring = facet_rings.ring[facet];
  return {ring.point, ring.point + ring.count};
}

bool has_centroid(Facet facet) {
  const std::vector<CellPoint> ring = ring_of(facet);
  return std::find(ring.begin(), ring.end(), centroid) != ring.end();
}

// All facets, whether or not a configuration has them.
template <typename Check>
void for_each_facet(Check check) {
  for (int code = 0; code < facet_codes; ++code) {
    if (facet_rings.ring[code].count == 0) continue;
    CAPTURE(code);
    check(static_cast<Facet>(code));
  }
}

// A ring of a facet, starting at its smallest point, so that equal rings compare equal.
std::vector<CellPoint> normalised(std::vector<CellPoint> ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

// A facet as geometry, so that a symmetry of the cell can map it.
using Placed = std::pair<Incidence, std::vector<CellPoint>>;

std::set<Placed> placed_facets(int configuration) {
  std::set<Placed> set;
  for (const Facet facet : facets_of(configuration))
    set.insert({incidence_of(facet), normalised(ring_of(facet))});
  return set;
}

}  // namespace

TEST_CASE("facet_of() restores a facet from its incidence and its shape") {
  for_each_facet([](Facet facet) {
    CHECK(facet_of(incidence_of(facet), shape_of(facet)) == facet);
    CHECK(incidence_of(facet) != no_incidence);
    CHECK(incidence_of(facet) < incidence_codes);
  });
}

TEST_CASE(
    "a facet's incidence determines its form: right triangle, rectangle or equilateral triangle") {
  for_each_facet([](Facet facet) {
    std::multiset<int> squared_lengths;
    const std::vector<CellPoint> ring = ring_of(facet);
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vertex link = position(ring[(i + 1) % ring.size()]) - position(ring[i]);
      CHECK(detail::derive::link_of(detail::link_table, link) < link_codes);
      squared_lengths.insert(dot_product(link, link));
    }
    const Vertex n = incidence_normal(incidence_of(facet));
    if (dot_product(n, n) == 1) CHECK(squared_lengths == std::multiset<int>{2, 2, 4});
    if (dot_product(n, n) == 2) CHECK(squared_lengths == std::multiset<int>{2, 2, 4, 4});
    if (dot_product(n, n) == 3) CHECK(squared_lengths == std::multiset<int>{2, 2, 2});
  });
}

TEST_CASE("shape numbers are as documented in facet_table.hpp") {
  for_each_facet([](Facet facet) {
    const Incidence incidence = incidence_of(facet);
    const Vertex n = incidence_normal(incidence);
    const Shape shape = shape_of(facet);
    if (!has_centroid(facet)) {
      // Normals point from on to off: a cut-off part opposite to the normal is on, shape 0.
      CHECK(shape == (dot_product(n, position(ring_of(facet)[0]) - middle) < 0 ? 0 : 1));
      return;
    }
    CHECK(ring_of(facet)[0] == centroid);
    const Vertex outer = position(ring_of(facet)[2]) - position(ring_of(facet)[1]);
    const Direction direction = direction_of(incidence, outer);
    CHECK(shape == (dot_product(n, n) == 1 ? direction / 2 : 2 + direction));
  });
}

TEST_CASE("a rotated or reflected configuration has the rotated or reflected facets") {
  CHECK(cell_symmetries().size() == 48);
  for (const CellSymmetry& symmetry : cell_symmetries())
    for (int c = 0; c < configurations; ++c) {
      CAPTURE(c);
      std::set<Placed> moved;
      for (auto [incidence, ring] : placed_facets(c)) {
        for (CellPoint& point : ring) point = symmetry.point(point);
        if (symmetry.is_mirror()) std::reverse(ring.begin(), ring.end());
        moved.insert(
            {incidence_of(symmetry.vector(incidence_normal(incidence))), normalised(ring)});
      }
      CHECK(moved == placed_facets(symmetry.configuration(static_cast<Configuration>(c))));
    }
}
