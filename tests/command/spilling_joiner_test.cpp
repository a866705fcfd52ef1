// The joiner that writes to a temporary file. Its output does not depend on its memory.
#include "streams/spilling_joiner.hpp"

#include <tuple>

#include "hand_made.hpp"
#include "oracle/normal_events.hpp"
#include "oracle/region.hpp"
#include "oracle/stream.hpp"
#include "surface/surface_builder.hpp"
#include "test.hpp"

namespace {

using discmc::Event;
using discmc::Vertex;
using discmc::command::SpillingJoiner;
using discmc::test::EventLog;
using discmc::test::Events;

constexpr std::uint64_t plenty = std::uint64_t{1} << 30;

// A scan with so little memory that most regions are sent as fragments. Every run has a normal.
Events pieces() {
  const auto volume = discmc::reference::random({20, 20, 20}, 128, 5);
  Events told;
  std::uint32_t number = 0;
  for (const auto& one : discmc::test::events_of(volume, discmc::minimum_capacities())) {
    Event event = one.event();
    event.normal = {static_cast<std::uint8_t>(1 + ++number % 255),
                    static_cast<std::uint8_t>(number / 255)};
    told.emplace_back(event);
  }
  return told;
}

Events joined(const Events& events, std::uint64_t bytes) {
  EventLog log;
  SpillingJoiner joiner(discmc::make_sink(log), bytes);
  for (const auto& one : events)
    REQUIRE(joiner.accept(one.event()) == discmc::SinkResult::accepted);
  joiner.finish();
  return log.events;
}

std::size_t count(const Events& events, Event::Kind kind) {
  return static_cast<std::size_t>(std::count_if(events.begin(), events.end(),
                                                [kind](const auto& one) { return one.is(kind); }));
}

std::vector<discmc::reference::Region> regions_of(const Events& events) {
  discmc::meshing::SurfaceBuilder builder;
  for (const auto& one : events) builder.accept(one.event());
  return hand_made::regions_of(builder.surface());
}

// The starts of runs with their normals, in an order independent of the regions.
auto normals_of(const Events& events) {
  std::vector<std::tuple<int, int, int, int, int>> normals;
  discmc::test::for_each_start(
      events, [&](const Vertex& vertex, discmc::OctahedralNormal normal, bool) {
        normals.emplace_back(vertex.x, vertex.y, vertex.z, normal.u, normal.v);
      });
  std::sort(normals.begin(), normals.end());
  return normals;
}

}  // namespace

TEST_CASE("regions, normals and totals are the same, in memory and through a file") {
  const Events told = pieces();
  REQUIRE(count(told, Event::Kind::fragment) > 1000);
  const Events in_memory = joined(told, plenty);
  REQUIRE(count(in_memory, Event::Kind::fragment) == 0);
  for (const std::uint64_t bytes : {1U, 1000U, 30000U}) {
    const Events spilled = joined(told, bytes);
    CHECK(count(spilled, Event::Kind::fragment) == 0);
    CHECK(regions_of(spilled) == regions_of(in_memory));
    CHECK(normals_of(spilled) == normals_of(in_memory));
    REQUIRE(count(spilled, Event::Kind::finish) == 1);
    CHECK(spilled.back() == in_memory.back());
  }
}

TEST_CASE("the statistics of several streams through a file are their sum") {
  Events twice = pieces();
  const Events once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  CHECK(joined(twice, 1).back() == joined(twice, plenty).back());
}

TEST_CASE("pieces without a partner are delivered loose, through a file as well") {
  Events told = pieces();
  const auto is_fragment = [](const auto& one) { return one.is(Event::Kind::fragment); };
  const auto first = std::find_if(told.begin(), told.end(), is_fragment);
  const auto end = std::find_if(first, told.end(),
                                [](const auto& one) { return one.is(Event::Kind::fragment_end); });
  told.erase(first, end + 1);
  const Events in_memory = joined(told, plenty), spilled = joined(told, 1);
  CHECK(count(in_memory, Event::Kind::fragment) > 0);
  CHECK(count(spilled, Event::Kind::fragment) == count(in_memory, Event::Kind::fragment));
  CHECK(regions_of(spilled) == regions_of(in_memory));
  CHECK(normals_of(spilled) == normals_of(in_memory));
}

TEST_CASE("only a fragment that breaks off is lost, through a file as well") {
  Events told = pieces();
  Event lost{};
  lost.kind = Event::Kind::lost;
  const auto is_end = [](const auto& one) { return one.is(Event::Kind::fragment_end); };
  *std::find_if(told.rbegin(), told.rend(), is_end) = discmc::test::RecordedEvent(lost);
  const Events in_memory = joined(told, plenty), spilled = joined(told, 1);
  CHECK(count(in_memory, Event::Kind::fragment) > 0);
  CHECK(count(spilled, Event::Kind::fragment) == count(in_memory, Event::Kind::fragment));
  CHECK(regions_of(spilled) == regions_of(in_memory));
}
