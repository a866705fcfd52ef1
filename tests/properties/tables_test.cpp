// Statements that any wrong byte of a derived table breaks; by exhaustion. proofs/table_mutation
// tries every wrong byte.
#include "oracle/sector_statements.hpp"
#include "oracle/table_statements.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

TEST_CASE("links are numbered in order, and directions of a plane are counter-clockwise") {
  CHECK(broken(detail::link_table) == nullptr);
}

TEST_CASE("the facets of every configuration fill its loops and match the recorded counts") {
  CHECK(broken(facet_tables()) == nullptr);
}

TEST_CASE(
    "the sector table has the sectors of a vertex's four cells and a queue per kind of link") {
  CHECK(broken(detail::trace::sector_table) == nullptr);
}
