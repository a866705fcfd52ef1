// Derives the tables of the host's sweep again at run time; the compiler derived them before.
//
// Includes the source, so the linker omits the library's object of it.
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

TEST_CASE("the ray table derived at run time equals the compile-time table") {
  const auto table = std::make_unique<RayTable>();
  *table = derive_rays();
  CHECK(are_same(*table, ray_table));  // the numbers have no gaps
}

TEST_CASE("the queue traits derived at run time equal the compile-time traits") {
  QueueTraits derived{};
  derived = derive_queue_traits();
  CHECK(are_same(derived.vertex, queue_traits.vertex));
  CHECK(are_same(derived.incoming, queue_traits.incoming));
  CHECK(are_same(derived.comes_from_ahead, queue_traits.comes_from_ahead));
  CHECK(are_same(derived.centroid, queue_traits.centroid));
  CHECK(are_same(derived.outgoing, queue_traits.outgoing));
  CHECK(are_same(derived.turns, queue_traits.turns));
  CHECK(are_same(derived.goes_ahead, queue_traits.goes_ahead));
  CHECK(are_same(derived.straight_in, queue_traits.straight_in));
  CHECK(are_same(derived.straight_out, queue_traits.straight_out));
  CHECK(are_same(derived.code, queue_traits.code));
}

TEST_CASE("directions of planes derived at run time equal the compile-time directions") {
  DirectionTable table{};
  table = derive::direction_table();
  CHECK(are_same(table, direction_table));
}

TEST_CASE("link measures derived at run time equal the compile-time measures") {
  LinkMeasures measures{};
  measures = derive::link_measures();
  CHECK(are_same(measures, link_measures));
}

}  // namespace
}  // namespace discmc::host
