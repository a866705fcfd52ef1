// Freeman chains: runs, closure, reversal and area, in integers.
#include <discmc/chain.hpp>

#include "incidences.hpp"
#include "oracle/collector.hpp"
#include "test.hpp"

using namespace discmc;
using test::for_each_incidence;

namespace {

std::vector<Run> runs_of(const std::vector<int>& directions_and_lengths) {
  std::vector<Run> runs;
  for (size_t i = 0; i < directions_and_lengths.size(); i += 2)
    runs.push_back(Run::straight(static_cast<Direction>(directions_and_lengths[i]),
                                 static_cast<uint32_t>(directions_and_lengths[i + 1])));
  return runs;
}

uint32_t size_of(const std::vector<Run>& runs) {
  return static_cast<uint32_t>(runs.size());
}

// A closed chain: it returns by the same links in another order.
std::vector<Run> closed_chain(Incidence incidence, uint32_t seed) {
  const int count = direction_count(incidence);
  std::vector<Run> runs;
  for (int i = 0; i < 6; ++i) {
    seed = seed * 1664525 + 1013904223;
    const int direction = static_cast<int>(seed >> 16) & 0x7FFF;
    runs.push_back(Run::straight(static_cast<Direction>(direction % count), 1 + (seed >> 8) % 9));
  }
  for (size_t i = 0; i < 6; ++i) {
    const Run run = runs[(i * 5 + 2) % 6];
    runs.push_back(
        Run::straight(static_cast<Direction>((run.direction() + count / 2) % count), run.length()));
  }
  return runs;
}

}  // namespace

TEST_CASE("a run stores its direction and any length up to the maximum") {
  for (Direction direction = 0; direction < max_directions; ++direction)
    for (const uint32_t length : {1U, 2U, 1000U, Run::max_length}) {
      const Run run = Run::straight(direction, length);
      CHECK(run.direction() == direction);
      CHECK(run.length() == length);
      CHECK_FALSE(run.is_empty());
      CHECK(Run::from_code(run.code()) == run);
      CHECK(Run::straight(direction, length % 1000 + 2) != run);
    }
  CHECK(Run().is_empty());
}

TEST_CASE("a run absorbs another run of its direction up to the maximal length") {
  Run run = Run::straight(3, 5);
  CHECK(run.absorb(Run::straight(3, 2)));
  CHECK(run == Run::straight(3, 7));
  CHECK_FALSE(run.absorb(Run::straight(4, 2)));
  CHECK(run == Run::straight(3, 7));
  Run long_run = Run::straight(3, Run::max_length - 1);
  CHECK(long_run.absorb(Run::straight(3, 1)));
  CHECK(long_run == Run::straight(3, Run::max_length));
  CHECK_FALSE(long_run.absorb(Run::straight(3, 1)));
  CHECK(long_run == Run::straight(3, Run::max_length));
  Run longest = Run::straight(7, Run::max_length);
  CHECK_FALSE(longest.absorb(Run::straight(7, Run::max_length)));
  CHECK(longest == Run::straight(7, Run::max_length));
}

TEST_CASE("an empty run does not absorb the first links of direction 0") {
  Run run;
  Run other = Run::straight(2, 4);
  CHECK_FALSE(run.absorb(other));
  CHECK(run.is_empty());
  // An empty run of direction 0 has the code of a run of length 0.
  CHECK(run.absorb(Run::straight(0, 4)));
  CHECK(run == Run::straight(0, 4));
}

TEST_CASE("a chain that returns along its own links is closed and has zero area") {
  for_each_incidence([](Incidence incidence) {
    const int half = direction_count(incidence) / 2;
    for (int direction = 0; direction < half; ++direction) {
      const std::vector<Run> runs = runs_of({direction, 5, direction + half, 5});
      CHECK(is_closed(incidence, runs.data(), 2));
      CHECK(twice_area(incidence, runs.data(), 2) == 0);
      CHECK_FALSE(is_closed(incidence, runs.data(), 1));
      const Vertex step = direction_vector(incidence, static_cast<Direction>(direction));
      CHECK(displacement(incidence, runs.data(), 1) == Vertex{5 * step.x, 5 * step.y, 5 * step.z});
    }
    CHECK(is_closed(incidence, nullptr, 0));
  });
}

TEST_CASE("the area of a closed chain does not depend on its start") {
  for_each_incidence([](Incidence incidence) {
    for (uint32_t seed = 0; seed < 200; ++seed) {
      const std::vector<Run> runs = closed_chain(incidence, seed);
      REQUIRE(is_closed(incidence, runs.data(), size_of(runs)));
      CHECK(twice_area(incidence, runs.data(), size_of(runs)) ==
            reference::signed_area(incidence, reference::vertices_of(incidence, {1, 2, 4}, runs)));
    }
  });
}

TEST_CASE("a reversed chain visits the same vertices backwards, and reversing twice restores it") {
  for_each_incidence([](Incidence incidence) {
    for (uint32_t seed = 0; seed < 100; ++seed) {
      const std::vector<Run> all = closed_chain(incidence, seed);
      for (uint32_t count = 0; count <= 12; ++count) {
        const std::vector<Run> forwards(all.begin(), all.begin() + count);
        std::vector<Run> backwards = forwards;
        reverse(incidence, backwards.data(), count);
        const Vertex start{0, 0, 1};
        const Vertex end = start + displacement(incidence, forwards.data(), count);
        reference::Ring there = reference::vertices_of(incidence, start, forwards);
        there.push_back(end);
        reference::Ring back = reference::vertices_of(incidence, end, backwards);
        back.push_back(start);
        CHECK(reference::Ring(back.rbegin(), back.rend()) == there);
        reverse(incidence, backwards.data(), count);
        CHECK(backwards == forwards);
      }
    }
  });
}

TEST_CASE("the area of the largest possible ring does not overflow") {
  // A slice of 32,766 voxels per side: 65,532 half-steps.
  const Incidence up = incidence_of({0, 0, 1});
  std::vector<Run> runs;
  for (Direction direction = 0; direction < 8; ++direction) {
    const Vertex step = direction_vector(up, direction);
    if (step.x == 0 || step.y == 0) runs.push_back(Run::straight(direction, 32766));
  }
  REQUIRE(runs.size() == 4);
  CHECK(is_closed(up, runs.data(), 4));
  CHECK(twice_area(up, runs.data(), 4) == int64_t{2} * 65532 * 65532);
}
