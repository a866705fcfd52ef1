// Statements that any wrong byte of a derived table breaks; by exhaustion. proofs/table_mutation
// tries every wrong byte.
#include "oracle/sector_statements.hpp"
#include "oracle/table_statements.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

TEST_CASE("links are numbered in order, and the directions of a plane counter-clockwise") {
  CHECK(broken(detail::link_table) == nullptr);
}

TEST_CASE("the facets of every configuration fill its loops, and their counts are right") {
  CHECK(broken(facet_tables()) == nullptr);
}

TEST_CASE("a vertex has the sectors of its four cells, and each kind of link has a queue") {
  CHECK(broken(detail::trace::sector_table) == nullptr);
}
