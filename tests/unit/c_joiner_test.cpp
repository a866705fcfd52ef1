// The C functions of the joiner do what the C++ functions do, event for event.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <cstring>
#include <new>

#include "oracle/c_events.hpp"
#include "oracle/join.hpp"
#include "oracle/loose.hpp"
#include "oracle/merge.hpp"
#include "oracle/stream.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// Takes events, and refuses every third.
struct Listener {
  Events events;
  uint32_t calls = 0;

  static discmc_answer take(void* context, const discmc_event* event) {
    Listener& listener = *static_cast<Listener*>(context);
    if (++listener.calls % 3 == 0) return DISCMC_NOT_NOW;
    listener.events.push_back(from_c(*event));
    return DISCMC_TAKEN;
  }
};

Events cut_events() {
  test::Chance chance(1);
  Cuts cuts;
  cuts.below = [&](uint32_t limit) { return chance.below(limit); };
  return events_of(cut(canonical(merge(random({7, 7, 6}, 128, 1), true)), cuts));
}

}  // namespace

TEST_CASE("a joiner through C makes the same events, in any order and memory") {
  const Events events = cut_events();
  for (const uint8_t order : {DISCMC_SWEEP_ORDER, DISCMC_ANY_ORDER})
    for (const JoinCapacities& capacities : {JoinCapacities{1000, 5000}, {10, 60}, {1, 1}}) {
      JoinPlan plan;
      plan.order = static_cast<InputOrder>(order);
      plan.capacities = capacities;
      const Joined expected = join(events, plan);

      const discmc_join_capacities in_c = {capacities.fragments, capacities.runs};
      Block block(discmc_joiner_bytes_for(&in_c));
      Listener listener;
      const discmc_sink sink = {&listener, Listener::take};
      discmc_joiner joiner = {};
      REQUIRE(discmc_joiner_start(&joiner, &in_c, {block.memory().data, block.memory().bytes},
                                  &sink, order) == DISCMC_OK);
      for (const RecordedEvent& event : events) {
        const Event offered = event.event();
        while (discmc_joiner_take(&joiner, to_c(offered)) == DISCMC_NOT_NOW) continue;
      }
      discmc_status status = discmc_joiner_finish(&joiner);
      while (status == DISCMC_MORE) status = discmc_joiner_finish(&joiner);
      CHECK(status == static_cast<discmc_status>(expected.status));
      CHECK(listener.events == expected.events);
      CHECK(block.is_intact());

      const discmc_join_report report = discmc_joiner_report(&joiner);
      CHECK(report.fragments == expected.report.fragments);
      CHECK(report.invalid == expected.report.invalid);
      CHECK(report.regions == expected.report.regions);
      CHECK(report.rings == expected.report.rings);
      CHECK(report.unmatched == expected.report.unmatched);
      CHECK(report.passed == expected.report.passed);
      CHECK(discmc_joiner_high_water(&joiner).fragments == expected.high_water.fragments);
      CHECK(discmc_joiner_high_water(&joiner).runs == expected.high_water.runs);
      CHECK(discmc_joiner_capacities(&joiner).fragments == capacities.fragments);
      CHECK(discmc_joiner_capacities(&joiner).runs == capacities.runs);
    }
}

TEST_CASE("what a joiner's start refuses it refuses through C, and one of zeros is not started") {
  std::vector<uint8_t> memory(2000);
  const discmc_memory all = {memory.data(), memory.size()};
  Listener listener;
  const discmc_sink sink = {&listener, Listener::take}, none = {};
  const discmc_join_capacities bad = {0, 1}, many = {1000, 1};
  const discmc_event event = {};
  discmc_joiner joiner = {};
  CHECK(discmc_joiner_finish(&joiner) == DISCMC_NOT_STARTED);
  CHECK(discmc_joiner_take(&joiner, &event) == DISCMC_NEVER);
  CHECK(discmc_joiner_start(&joiner, nullptr, all, &none, DISCMC_SWEEP_ORDER) == DISCMC_BAD_SINK);
  CHECK(discmc_joiner_start(&joiner, &bad, all, &sink, DISCMC_SWEEP_ORDER) ==
        DISCMC_BAD_CAPACITIES);
  CHECK(discmc_joiner_start(&joiner, &many, all, &sink, DISCMC_SWEEP_ORDER) ==
        DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_joiner_finish(&joiner) == DISCMC_NOT_STARTED);
  REQUIRE(discmc_joiner_start(&joiner, nullptr, all, &sink, DISCMC_SWEEP_ORDER) == DISCMC_OK);
  CHECK(discmc_joiner_capacities(&joiner).runs == Joiner::default_capacities(2000).runs);
  CHECK(discmc_joiner_finish(&joiner) == DISCMC_OK);
}

TEST_CASE("storage of zeros is a joiner as it begins") {
  alignas(Joiner) static unsigned char place[sizeof(Joiner)];
  static const unsigned char zeros[sizeof(Joiner)] = {};
  new (place) Joiner;
  CHECK(std::memcmp(place, zeros, sizeof(Joiner)) == 0);
}

TEST_CASE("a joiner's sizes are the same in C, as functions and as constants") {
  CHECK(discmc_joiner_minimum_bytes() == Joiner::minimum_bytes());
  CHECK(DISCMC_JOINER_MINIMUM_BYTES == Joiner::minimum_bytes());
  for (uint64_t bytes = 0; bytes < uint64_t{1} << 50; bytes = bytes * 7 / 3 + 50) {
    const JoinCapacities split = Joiner::default_capacities(bytes);
    const discmc_join_capacities in_c = discmc_joiner_default_capacities(bytes);
    CHECK(in_c.fragments == split.fragments);
    CHECK(in_c.runs == split.runs);
    const uint64_t as_constants[] = DISCMC_JOINER_DEFAULT_CAPACITIES(bytes);
    CHECK(as_constants[0] == split.fragments);
    CHECK(as_constants[1] == split.runs);
    CHECK(discmc_joiner_bytes_for(&in_c) == Joiner::bytes_for(split));
    CHECK(DISCMC_JOINER_BYTES_FOR(split.fragments, split.runs) == Joiner::bytes_for(split));
  }
}

TEST_CASE("totals are added in C as in C++") {
  Statistics sum{1, 2, 3, 4, 5, 6, 7, 8};
  const Statistics other{10, 20, 30, 40, 50, 60, 70, 80};
  discmc_statistics in_c = {1, 2, 3, 4, 5, 6, 7, 8};
  const discmc_statistics other_in_c = {10, 20, 30, 40, 50, 60, 70, 80};
  add(sum, other);
  discmc_add_statistics(&in_c, &other_in_c);
  CHECK(counts(from_c(in_c)) == counts(sum));
}
