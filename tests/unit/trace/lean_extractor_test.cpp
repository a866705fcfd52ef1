// A lean extractor sends the surface of the scans that it accepts, and refuses all others.
#include <discmc/trace/extractor_definitions.hpp>

#include "oracle/agreement.hpp"
#include "oracle/event_log.hpp"
#include "oracle/join.hpp"
#include "oracle/scan.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr uint32_t some_slots = 300;  // too few for the larger volumes

template <class Scanner>
Events events_of(const BitVolume& volume, const Capacities& capacities) {
  const Limits limits = limits_of(volume, Border::closed);
  Block block(Extractor16::bytes_for(limits, capacities));
  EventLog log;
  Scanner extractor;
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

template <class Scanner>
Status status_of_start(const Limits& limits) {
  Block block(Extractor16::minimum_bytes(limits));
  EventLog log;
  Scanner extractor;
  return extractor.start(limits, 1, block.memory(), make_sink(log));
}

size_t count(const Events& events, Event::Kind kind) {
  return static_cast<size_t>(std::count_if(
      events.begin(), events.end(), [kind](const RecordedEvent& each) { return each.is(kind); }));
}

}  // namespace

TEST_CASE("a lean extractor reports no totals of cells, facets and triangles") {
  const Events events = events_of<LeanExtractor16>(ball({20, 20, 20}, {9, 9, 9}, 70), ample);
  const Events all = events_of<Extractor16>(ball({20, 20, 20}, {9, 9, 9}, 70), ample);
  Statistics expected = *all.back().event().statistics;
  expected.cells = expected.facets = expected.classic_triangles = 0;
  CHECK(counts(*events.back().event().statistics) == counts(expected));
}

TEST_CASE("a lean extractor sends holes as loose rings, which a joiner assigns to regions") {
  size_t holes = 0;
  for (const BitVolume& volume : volumes())
    for (const uint32_t slots : {ample.slots, some_slots}) {
      const Events loose = events_of<LeanExtractor16>(volume, {slots, 0});
      const Joined joined = join_all(loose, {InputOrder::sweep, enough_for(loose)});
      Collector collector;
      for (const RecordedEvent& event : joined.events) collector.accept(event.event());
      CHECK(unlike_merge(collector.regions(), volume, true) == "");
      if (slots != ample.slots) continue;
      const Events all = events_of<Extractor16>(volume, ample);
      const size_t loose_rings = count(loose, Event::Kind::fragment);
      CHECK(loose_rings == count(all, Event::Kind::ring) - count(all, Event::Kind::region));
      holes += loose_rings;
    }
  CHECK(holes > 0);
}

TEST_CASE("a lean extractor refuses open borders and slabs") {
  CHECK(status_of_start<LeanExtractor16>({4, 4}) == Status::ok);
  const Limits open{4, 4, Border::open};
  const Limits above{4, 4, Border::closed, {3, true, false}};
  const Limits below{4, 4, Border::closed, {0, false, true}};
  for (const Limits& limits : {open, above, below}) {
    CHECK(status_of_start<Extractor16>(limits) == Status::ok);
    CHECK(status_of_start<LeanExtractor16>(limits) == Status::bad_limits);
  }
}
