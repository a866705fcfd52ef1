// Statements that any wrong byte of a derived table breaks (proofs/table_mutation tries every
// one), and the patches of cells that stand alone; by exhaustion.
#include <doctest/doctest.h>

#include <discmc/polygon.hpp>
#include <discmc/trace/cell_patches.hpp>

#include "oracle/collect.hpp"
#include "oracle/sector_statements.hpp"
#include "oracle/surface.hpp"
#include "oracle/table_statements.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// What the facets of a cell leave over on their planes.
uint64_t links_of_facets(int configuration) {
  uint64_t sum = 0;
  for (int i = facet_table.first[configuration]; i < facet_table.first[configuration + 1]; ++i) {
    const Facet facet = facet_table.facet[i];
    const FacetRing& ring = facet_rings.ring[facet];
    for (int p = 0; p < ring.count; ++p)
      sum += of_incidence(
          link_hash(position(ring.point[p]), position(ring.point[(p + 1) % ring.count])),
          incidence_of(facet));
  }
  return sum;
}

uint64_t links_of(const trace::CellPatch& patch) {
  uint64_t sum = 0;
  const std::vector<Run> runs(patch.run, patch.run + patch.count);
  const Ring ring = vertices_of(patch.incidence, position(patch.start), runs);
  for (size_t i = 0; i < ring.size(); ++i)
    sum += of_incidence(link_hash(ring[i], ring[(i + 1) % ring.size()]), patch.incidence);
  return sum;
}

void check_ring(const trace::CellPatch& patch) {
  CHECK(patch.count <= trace::CellPatch::max_runs);
  CHECK(is_closed(patch.incidence, patch.run, patch.count));
  CHECK(twice_area(patch.incidence, patch.run, patch.count) > 0);
  for (int i = 0; i < patch.count; ++i)
    CHECK(patch.run[i].direction() != patch.run[(i + 1) % patch.count].direction());
}

}  // namespace

TEST_CASE("links are numbered in order, and the directions of a plane go round") {
  CHECK(broken(links) == nullptr);
}

TEST_CASE("the facets of every configuration fill its loops, and are counted right") {
  CHECK(broken(facet_tables()) == nullptr);
}

TEST_CASE("a vertex sees the sectors of its four cells, and each kind of link has a queue") {
  CHECK(broken(trace::sector_table) == nullptr);
}

TEST_CASE("the patches of every configuration are rings around its facets, plane by plane") {
  for (int c = 0; c < configurations; ++c) {
    CAPTURE(c);
    uint64_t sum = 0;
    for (uint32_t number = 0;; ++number) {
      const trace::CellPatch patch = trace::cell_patch(static_cast<Configuration>(c), number);
      if (patch.count == 0) break;
      check_ring(patch);
      sum += links_of(patch);
    }
    CHECK(sum == links_of_facets(c));
  }
}

TEST_CASE("a cell that stands alone counts its facets and classic triangles") {
  for (int c = 0; c < configurations; ++c) {
    const trace::CellCounts counts = trace::cell_counts(static_cast<Configuration>(c));
    CHECK(counts.facets == cell_facts.facets[c]);
    CHECK(counts.classic_triangles == cell_facts.classic_triangles[c]);
  }
}
