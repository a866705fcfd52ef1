// Chains in their plane: the ends of runs.
#include <discmc/chain.hpp>

#include "incidences.hpp"
#include "test.hpp"

using namespace discmc;
using test::for_each_incidence;

TEST_CASE("after_run() returns the vertex after a run's links, and coordinates wrap") {
  for_each_incidence([](Incidence incidence) {
    for (Direction direction = 0; direction < direction_count(incidence); ++direction) {
      Vertex at{7, -3, 100};
      for (uint32_t length = 1; length < 5; ++length) {
        at = at + direction_vector(incidence, direction);
        CHECK(after_run(incidence, {7, -3, 100}, Run::straight(direction, length)) == at);
      }
    }
  });
  const Incidence up = incidence_of({0, 0, 1});
  const Run longest = Run::straight(direction_of(up, Vertex{2, 0, 0}), Run::max_length);
  Vertex at{INT32_MAX, 0, 0};
  for (int i = 0; i < 8; ++i) at = after_run(up, at, longest);
  CHECK(at == Vertex{INT32_MAX - 16, 0, 0});
}

TEST_CASE(
    "all vertices of a plane have the same offset, and a neighbouring plane has another offset") {
  for_each_incidence([](Incidence incidence) {
    const Vertex vertex{3, -4, 12};
    const int32_t offset = plane_offset(incidence, vertex);
    CHECK(offset == dot_product(incidence_normal(incidence), vertex));
    for (Direction direction = 0; direction < direction_count(incidence); ++direction)
      CHECK(plane_offset(incidence, vertex + direction_vector(incidence, direction)) == offset);
    CHECK(plane_offset(incidence, vertex + incidence_normal(incidence)) != offset);
  });
  CHECK(plane_offset(incidence_of({1, 1, 1}), {INT32_MAX, INT32_MAX, INT32_MAX}) == INT32_MAX - 2);
}

TEST_CASE("a run is valid in a plane if its direction and its length are valid") {
  const Incidence corner = incidence_of({1, 1, 1});
  CHECK(is_run_of(corner, Run::straight(5, 1)));
  CHECK_FALSE(is_run_of(corner, Run::straight(6, 1)));
  CHECK(is_run_of(corner, Run::straight(0, Run::max_length)));
  CHECK_FALSE(is_run_of(corner, Run::straight(0, Run::max_length + 1)));
  CHECK_FALSE(is_run_of(corner, Run()));
  CHECK_FALSE(is_incidence(no_incidence));
  CHECK_FALSE(is_incidence(27));
  CHECK(is_incidence(26));
}
