// An extractor with chosen features gives what one with all of them gives of the scans that it
// takes, and refuses the others.
#include <doctest/doctest.h>
#include <discmc/trace/extractor_definitions.hpp>

#include "oracle/agreement.hpp"
#include "oracle/event_log.hpp"
#include "oracle/join.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

struct WholeVolumes : AllFeatures {
  static constexpr bool open_border = false;
  static constexpr bool slabs = false;
};
struct OpenBorders : AllFeatures {
  static constexpr bool slabs = false;
};
struct WithoutCounts : AllFeatures {
  static constexpr bool cell_counts = false;
};
struct LooseHoles : AllFeatures {
  static constexpr bool holes_wait = false;
};
struct Leanest : WholeVolumes {
  static constexpr bool cell_counts = false;
  static constexpr bool holes_wait = false;
};

constexpr uint32_t some_slots = 300;  // too few for the larger volumes

template <class Features>
Events events_of(const BitVolume& volume, const Capacities& capacities,
                 Border border = Border::closed) {
  const Limits limits = limits_of(volume, border);
  Block block(Extractor16::bytes_for(limits, capacities));
  EventLog log;
  Extractor<uint16_t, Features> extractor;
  require_ok(extractor.start(limits, capacities, 1, block.memory(), make_sink(log)));
  push_all(extractor, volume.on);
  finish_all(extractor);
  CHECK(block.is_intact());
  return log.events;
}

BitVolume plate_with_a_hole() {
  BitVolume plate = box({12, 12, 4}, {1, 1, 1}, {10, 10, 2});
  for (int z = 1; z <= 2; ++z)
    for (int y = 4; y <= 7; ++y)
      for (int x = 4; x <= 7; ++x) plate.on[plate.index(x, y, z)] = 0;
  return plate;
}

std::vector<BitVolume> volumes() {
  return {random({40, 9, 8}, 128, 1), random({9, 8, 12}, 20, 2), ball({20, 20, 20}, {9, 9, 9}, 70),
          plate_with_a_hole(), spiral({15, 15, 4})};
}

Events without_totals(Events events) {
  events.pop_back();
  return events;
}

template <class Features>
Status status_of_start(const Limits& limits) {
  Block block(Extractor16::minimum_bytes(limits));
  EventLog log;
  Extractor<uint16_t, Features> extractor;
  return extractor.start(limits, 1, block.memory(), make_sink(log));
}

size_t count(const Events& events, Event::Kind kind) {
  return static_cast<size_t>(std::count_if(
      events.begin(), events.end(), [kind](const RecordedEvent& each) { return each.is(kind); }));
}

}  // namespace

TEST_CASE("extractors without borders, slabs or counts send the events of one with all features") {
  for (const BitVolume& volume : volumes())
    for (const uint32_t slots : {ample.slots, some_slots}) {
      const Capacities capacities{slots, ample.holes};
      const Events all = events_of<AllFeatures>(volume, capacities);
      CHECK(events_of<WholeVolumes>(volume, capacities) == all);
      CHECK(without_totals(events_of<WithoutCounts>(volume, capacities)) == without_totals(all));
      CHECK(events_of<OpenBorders>(volume, capacities, Border::open) ==
            events_of<AllFeatures>(volume, capacities, Border::open));
    }
}

TEST_CASE("a scan without counts has no totals of cells, facets and triangles, but all others") {
  const BitVolume volume = random({20, 20, 9}, 100, 3);
  const Events events = events_of<WithoutCounts>(volume, ample);
  const Events all = events_of<AllFeatures>(volume, ample);
  Statistics expected = *all.back().event().statistics;
  expected.cells = expected.facets = expected.classic_triangles = 0;
  CHECK(counts(*events.back().event().statistics) == counts(expected));
}

TEST_CASE("holes that do not wait are sent as loose rings, and a joiner assigns them to regions") {
  size_t holes = 0;
  for (const BitVolume& volume : volumes())
    for (const uint32_t slots : {ample.slots, some_slots}) {
      const Events loose = events_of<Leanest>(volume, {slots, 0});
      const Joined joined = join_all(loose, {InputOrder::sweep, enough_for(loose)});
      Collector collector;
      for (const RecordedEvent& event : joined.events) collector.accept(event.event());
      CHECK(unlike_merge(collector.regions(), volume, true) == "");
      if (slots != ample.slots) continue;
      const Events all = events_of<AllFeatures>(volume, ample);
      const size_t loose_rings = count(loose, Event::Kind::fragment);
      CHECK(loose_rings == count(all, Event::Kind::ring) - count(all, Event::Kind::region));
      holes += loose_rings;
      CHECK(events_of<LooseHoles>(volume, ample).size() == loose.size());
    }
  CHECK(holes > 0);
}

TEST_CASE("limits that need a feature that was left out are refused") {
  const Limits open{4, 4, Border::open};
  const Limits above{4, 4, Border::closed, {3, true, false}};
  const Limits below{4, 4, Border::closed, {0, false, true}};
  CHECK(status_of_start<WholeVolumes>({4, 4}) == Status::ok);
  for (const Limits& limits : {open, above, below}) {
    CHECK(status_of_start<AllFeatures>(limits) == Status::ok);
    CHECK(status_of_start<WholeVolumes>(limits) == Status::bad_limits);
  }
  CHECK(status_of_start<OpenBorders>(open) == Status::ok);
  CHECK(status_of_start<OpenBorders>(above) == Status::bad_limits);
}
