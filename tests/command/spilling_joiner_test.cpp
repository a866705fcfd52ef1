// The joiner that writes to a temporary file. Its output does not depend on its memory.
#include "streams/spilling_joiner.hpp"

#include <tuple>

#include "joined_events.hpp"
#include "oracle/normal_events.hpp"

namespace {

using namespace joined_events;

constexpr std::uint64_t plenty = std::uint64_t{1} << 30;

// Every run has a normal.
Events pieces_with_normals() {
  Events events;
  std::uint32_t number = 0;
  for (const auto& one : pieces()) {
    Event event = one.event();
    event.normal = {static_cast<std::uint8_t>(1 + ++number % 255),
                    static_cast<std::uint8_t>(number / 255)};
    events.emplace_back(event);
  }
  return events;
}

Events joined(const Events& events, std::uint64_t bytes) {
  return joined_by<discmc::command::SpillingJoiner>(events, bytes);
}

std::vector<discmc::reference::Region> regions_of(const Events& events) {
  return hand_made::regions_of(built(events).surface());
}

// The starts of runs with their normals, in an order independent of the regions.
auto normals_of(const Events& events) {
  std::vector<std::tuple<int, int, int, int, int>> normals;
  discmc::test::for_each_start(
      events, [&](const discmc::Vertex& vertex, discmc::OctahedralNormal normal, bool) {
        normals.emplace_back(vertex.x, vertex.y, vertex.z, normal.u, normal.v);
      });
  std::sort(normals.begin(), normals.end());
  return normals;
}

}  // namespace

TEST_CASE("a joiner gives the same regions, normals and totals in memory and through a file") {
  const Events sent_pieces = pieces_with_normals();
  REQUIRE(count(sent_pieces, Event::Kind::fragment) > 1000);
  const Events in_memory = joined(sent_pieces, plenty);
  REQUIRE(count(in_memory, Event::Kind::fragment) == 0);
  for (const std::uint64_t bytes : {1U, 1000U, 30000U}) {
    const Events spilled = joined(sent_pieces, bytes);
    CHECK(count(spilled, Event::Kind::fragment) == 0);
    CHECK(regions_of(spilled) == regions_of(in_memory));
    CHECK(normals_of(spilled) == normals_of(in_memory));
    REQUIRE(count(spilled, Event::Kind::finish) == 1);
    CHECK(spilled.back() == in_memory.back());
  }
}

TEST_CASE("the statistics of several streams joined through a file are summed") {
  Events twice = pieces_with_normals();
  const Events once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  CHECK(joined(twice, 1).back() == joined(twice, plenty).back());
}

TEST_CASE("a joiner delivers fragments without a partner loose, in memory and through a file") {
  Events sent_pieces = pieces_with_normals();
  const auto is_fragment = [](const auto& one) { return one.is(Event::Kind::fragment); };
  const auto first = std::find_if(sent_pieces.begin(), sent_pieces.end(), is_fragment);
  const auto end = std::find_if(first, sent_pieces.end(),
                                [](const auto& one) { return one.is(Event::Kind::fragment_end); });
  sent_pieces.erase(first, end + 1);
  const Events in_memory = joined(sent_pieces, plenty), spilled = joined(sent_pieces, 1);
  CHECK(count(in_memory, Event::Kind::fragment) > 0);
  CHECK(count(spilled, Event::Kind::fragment) == count(in_memory, Event::Kind::fragment));
  CHECK(regions_of(spilled) == regions_of(in_memory));
  CHECK(normals_of(spilled) == normals_of(in_memory));
}

TEST_CASE("the loss of a fragment loses no other fragment, in memory and through a file") {
  Events sent_pieces = pieces_with_normals();
  Event lost{};
  lost.kind = Event::Kind::lost;
  const auto is_end = [](const auto& one) { return one.is(Event::Kind::fragment_end); };
  *std::find_if(sent_pieces.rbegin(), sent_pieces.rend(), is_end) =
      discmc::test::RecordedEvent(lost);
  const Events in_memory = joined(sent_pieces, plenty), spilled = joined(sent_pieces, 1);
  CHECK(count(in_memory, Event::Kind::fragment) > 0);
  CHECK(count(spilled, Event::Kind::fragment) == count(in_memory, Event::Kind::fragment));
  CHECK(regions_of(spilled) == regions_of(in_memory));
}
