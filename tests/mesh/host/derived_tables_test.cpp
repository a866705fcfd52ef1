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
  QueueTraits ends{};
  ends = derive_queue_traits();
  CHECK(are_same(ends.vertex, queue_traits.vertex));
  CHECK(are_same(ends.incoming, queue_traits.incoming));
  CHECK(are_same(ends.comes_from_ahead, queue_traits.comes_from_ahead));
  CHECK(are_same(ends.centroid, queue_traits.centroid));
  CHECK(are_same(ends.first, queue_traits.first));
  CHECK(are_same(ends.turns, queue_traits.turns));
  CHECK(are_same(ends.goes_ahead, queue_traits.goes_ahead));
  CHECK(are_same(ends.straight_in, queue_traits.straight_in));
  CHECK(are_same(ends.straight_out, queue_traits.straight_out));
  CHECK(are_same(ends.number, queue_traits.number));
  CHECK(are_same(ends.code, queue_traits.code));
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
