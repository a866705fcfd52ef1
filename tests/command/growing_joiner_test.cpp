// The growing joiner of the command. Fragments without a partner remain loose.
#include "surface/growing_joiner.hpp"

#include "joined_events.hpp"

namespace {

using namespace joined_events;
using discmc::meshing::GrowingJoiner;

// The events of the first fragment only.
Events first_fragment() {
  Events events = pieces();
  std::size_t first = 0, end = 0;
  while (!events[first].is(Event::Kind::fragment)) ++first;
  for (end = first; !events[end].is(Event::Kind::fragment_end);) ++end;
  return Events(events.begin() + static_cast<std::ptrdiff_t>(first),
                events.begin() + static_cast<std::ptrdiff_t>(end) + 1);
}

Events joined(const Events& events, std::uint64_t bytes = GrowingJoiner::first_bytes) {
  return joined_by<GrowingJoiner>(events, discmc::InputOrder::sweep, bytes);
}

std::vector<discmc::reference::Region> regions_of(const Events& events) {
  const auto builder = built(events);
  CHECK(builder.incomplete_regions() == 0);
  return hand_made::regions_of(builder.surface());
}

}  // namespace

TEST_CASE("a growing joiner joins all regions, however small its initial memory") {
  const auto volume = discmc::reference::random({20, 20, 20}, 128, 5);
  const Events sent_pieces = pieces();
  REQUIRE(count(sent_pieces, Event::Kind::fragment) > 1000);
  const auto whole = regions_of(discmc::test::events_of(volume));
  for (const std::uint64_t bytes : {discmc::Joiner::minimum_bytes(), std::uint64_t{1000},
                                    std::uint64_t{30000}, GrowingJoiner::first_bytes}) {
    const Events events = joined(sent_pieces, bytes);
    CHECK(count(events, Event::Kind::fragment) == 0);
    CHECK(count(events, Event::Kind::finish) == 1);
    CHECK(regions_of(events) == whole);
  }
}

TEST_CASE("the totals of a growing joiner count the delivered regions") {
  for (const std::uint64_t bytes : {discmc::Joiner::minimum_bytes(), GrowingJoiner::first_bytes}) {
    const Events events = joined(pieces(), bytes);
    REQUIRE(events.back().is(Event::Kind::finish));
    const discmc::Statistics& totals = *events.back().event().statistics;
    CHECK(totals.regions == count(events, Event::Kind::region_end));
    CHECK(totals.rings == count(events, Event::Kind::ring));
    CHECK(totals.fragments == 0);
  }
}

TEST_CASE(
    "a growing joiner leaves fragments without a partner loose, also at the end of a truncated "
    "stream") {
  const Events alone = first_fragment();
  CHECK(joined(alone) == alone);
  Events twice = alone;
  twice.insert(twice.end(), alone.begin(), alone.end());
  CHECK(joined(twice) == twice);
}
