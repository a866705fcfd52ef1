// The tables of the host's sweep, which the compiler derives, derived once more at run time.
//
// The source is compiled in here; the library's object of it is then not linked.
#include "host/direction_table.hpp"
#include "host/ray_table.cpp"

#include <string.h>

#include "test.hpp"

namespace discmc::host {
namespace {

template <class Table>
bool are_same(const Table& a, const Table& b) {
  return memcmp(&a, &b, sizeof a) == 0;
}

TEST_CASE("the table of rays derived at run time equals that of the compiler") {
  const auto table = std::make_unique<RayTable>();
  *table = derive_rays();
  CHECK(are_same(*table, ray_table));  // there are no gaps
}

TEST_CASE("the ends of rays derived at run time equal those of the compiler") {
  RayEnds ends{};
  ends = derive_ends();
  CHECK(are_same(ends.vertex, ray_ends.vertex));
  CHECK(are_same(ends.incoming, ray_ends.incoming));
  CHECK(are_same(ends.comes_from_ahead, ray_ends.comes_from_ahead));
  CHECK(are_same(ends.centroid, ray_ends.centroid));
  CHECK(are_same(ends.first, ray_ends.first));
  CHECK(are_same(ends.turns, ray_ends.turns));
  CHECK(are_same(ends.goes_ahead, ray_ends.goes_ahead));
  CHECK(are_same(ends.straight_in, ray_ends.straight_in));
  CHECK(are_same(ends.straight_out, ray_ends.straight_out));
  CHECK(are_same(ends.number, ray_ends.number));
  CHECK(are_same(ends.code, ray_ends.code));
}

TEST_CASE("directions of planes derived at run time equal those of the compiler") {
  DirectionTable table{};
  table = derive::direction_table();
  CHECK(are_same(table, direction_table));
}

TEST_CASE("link measures derived at run time equal those of the compiler") {
  LinkMeasures measures{};
  measures = derive::link_measures();
  CHECK(are_same(measures, link_measures));
}

}  // namespace
}  // namespace discmc::host
