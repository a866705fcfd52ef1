// Derives the facet tables again at run time. They equal the tables that the compiler derived, and
// the coverage of the source can be measured.
//
// Includes the source, so the linker omits the library's object of it.
#include <discmc/geometry/facet_table.cpp>

#include "test.hpp"

namespace discmc {
namespace {

TEST_CASE("facet tables derived at run time equal the compile-time tables") {
  Derived again{};
  again = derive_all();  // a constant would be derived by the compiler
  for (int c = 0; c <= configurations; ++c) CHECK(again.table.first[c] == facet_table.first[c]);
  for (int i = 0; i < FacetTable::total; ++i) CHECK(again.table.facet[i] == facet_table.facet[i]);
  for (int facet = 0; facet < 256; ++facet) {
    const FacetRing& ring = again.rings.ring[facet];
    REQUIRE(ring.count == facet_rings.ring[facet].count);
    for (int i = 0; i < ring.count; ++i) CHECK(ring.point[i] == facet_rings.ring[facet].point[i]);
  }
  for (int c = 0; c < configurations; ++c) {
    CHECK(again.facts.facets[c] == cell_facts.facets[c]);
    CHECK(again.facts.classic_triangles[c] == cell_facts.classic_triangles[c]);
    CHECK(again.facts.enclosed[c] == cell_facts.enclosed[c]);
  }
}

TEST_CASE("the checks of the facet tables count correctly and reject wrong numbers") {
  CHECK(configurations_with(7) == 32);
  CHECK(configurations_with(8) == 0);
  CHECK(occurs(3, 93));
  CHECK_FALSE(occurs(3, 92));
  CHECK_FALSE(occurs(1, 45));
  CHECK(facets_with_ring() == 112);
}

}  // namespace
}  // namespace discmc
