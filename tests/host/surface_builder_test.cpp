// The surface builder: fragments put back, lost ones counted, sweep rings made simple.
#include "surface_builder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <discmc/polygon.hpp>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "oracle/stream.hpp"

namespace {

using discmc::Event;
using discmc::Incidence;
using discmc::Run;
using discmc::Vertex;
using discmc::host::Polygon;
using discmc::host::Ring;
using discmc::host::SurfaceBuilder;
using discmc::test::events_of;
using Kind = Event::Kind;
using Events = std::vector<Event>;

const Incidence up = discmc::incidence_of({0, 0, 1});

Event event(Kind kind) {
  Event event{};
  event.kind = kind;
  return event;
}

void add_runs(Events& events, const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    events.push_back(event(Kind::run));
    events.back().run = run;
  }
}

void add_fragment(Events& events, std::uint32_t number, const std::vector<Run>& runs) {
  events.push_back(event(Kind::fragment));
  events.back().number = number;
  events.back().incidence = up;
  add_runs(events, runs);
  events.push_back(event(Kind::fragment_end));
}

void add_region(Events& events, const std::vector<std::vector<Run>>& rings,
                Vertex start = {1, 0, 0}) {
  events.push_back(event(Kind::region));
  events.back().incidence = up;
  for (const auto& ring : rings) {
    events.push_back(event(Kind::ring));
    events.back().start = start;
    events.back().hole = &ring != &rings[0];
    add_runs(events, ring);
  }
  events.push_back(event(Kind::region_end));
}

SurfaceBuilder build(const Events& events) {
  SurfaceBuilder builder;
  for (const Event& event : events) REQUIRE(builder.take(event) == discmc::Answer::taken);
  return builder;
}

// A straight run in the plane of `up` whose links are this step.
Run run(const Vertex& step, std::uint32_t length = 1) {
  for (discmc::Direction direction = 0; direction < 8; ++direction)
    if (discmc::direction_vector(up, direction) == step) return Run::straight(direction, length);
  FAIL("no such link");
  return {};
}

const Vertex east = {2, 0, 0}, north = {0, 2, 0}, west = {-2, 0, 0}, south = {0, -2, 0};

// A rectangle of 3 by 2 links, counter-clockwise.
std::vector<Run> rectangle() {
  return {run(east, 3), run(north, 2), run(west, 3), run(south, 2)};
}

bool is_simple(const Ring& ring) {
  std::set<std::tuple<int, int, int>> vertices;
  for (const Vertex& vertex : ring) vertices.emplace(vertex.x, vertex.y, vertex.z);
  return vertices.size() == ring.size();
}

std::int64_t area(const Polygon& polygon, const Ring& ring) {
  return discmc::twice_area(polygon.incidence, ring.data(),
                            static_cast<std::uint32_t>(ring.size()));
}

std::int64_t area(const Polygon& polygon) {
  std::int64_t sum = 0;
  for (const Ring& ring : polygon.rings) sum += area(polygon, ring);
  return sum;
}

void check_same(const SurfaceBuilder& a, const SurfaceBuilder& b) {
  REQUIRE(a.surface().polygons.size() == b.surface().polygons.size());
  for (std::size_t i = 0; i < a.surface().polygons.size(); ++i) {
    CHECK(a.surface().polygons[i].incidence == b.surface().polygons[i].incidence);
    CHECK(a.surface().polygons[i].rings == b.surface().polygons[i].rings);
  }
}

// The events of a region with every run of its rings sent before, in fragments within fragments.
Events in_fragments(const Events& events, std::uint32_t& number) {
  Events fragments, region;
  for (const Event& event : events) {
    if (event.kind != Kind::run) {
      region.push_back(event);
      continue;
    }
    const bool goes_on = region.back().kind == Kind::run;
    std::vector<Run> runs = {event.run};
    if (goes_on) runs.insert(runs.begin(), region.back().run);
    add_fragment(fragments, number, runs);
    if (!goes_on) add_runs(region, {Run()});
    region.back().run = Run::fragment(number++);
  }
  fragments.insert(fragments.end(), region.begin(), region.end());
  return fragments;
}

}  // namespace

TEST_CASE("a region becomes a polygon with every vertex of its rings") {
  Events events;
  add_region(events, {rectangle()});
  const SurfaceBuilder builder = build(events);
  REQUIRE(builder.surface().polygons.size() == 1);
  const Polygon& polygon = builder.surface().polygons[0];
  REQUIRE(polygon.rings.size() == 1);
  CHECK(polygon.incidence == up);
  CHECK(polygon.rings[0].size() == 10);
  CHECK(polygon.rings[0][0] == Vertex{1, 0, 0});
  CHECK(polygon.rings[0][3] == Vertex{7, 0, 0});
  CHECK(area(polygon) == 2 * 6 * 4);
}

TEST_CASE("fragments are put back where their numbers stand") {
  Events whole, parts;
  add_region(whole, {rectangle()});
  add_fragment(parts, 7, {run(north, 2), run(west, 1)});
  add_fragment(parts, 3, {run(south, 2)});
  add_region(parts, {{run(east, 3), Run::fragment(7), run(west, 2), Run::fragment(3)}});
  const SurfaceBuilder builder = build(parts);
  check_same(builder, build(whole));
  CHECK(builder.incomplete_regions() == 0);
}

TEST_CASE("fragments within fragments are put back however deep they lie") {
  Events whole, parts;
  add_region(whole, {{run(east, 50000), run(north), run(west, 50000), run(south)}});
  add_fragment(parts, 0, {run(east)});
  for (std::uint32_t i = 1; i < 50000; ++i)
    add_fragment(parts, i, {Run::fragment(i - 1), run(east)});
  add_region(parts, {{Run::fragment(49999), run(north), run(west, 50000), run(south)}});
  const SurfaceBuilder builder = build(parts);
  check_same(builder, build(whole));
  CHECK(builder.incomplete_regions() == 0);
}

TEST_CASE("a surface sent in fragments alone is the surface") {
  const auto told = events_of(discmc::reference::random({9, 8, 7}, 128, 5));
  Events whole, parts, region;
  std::uint32_t number = 0;
  for (const auto& one : told) {
    whole.push_back(one.event());
    region.push_back(one.event());
    if (one.kind() == Kind::ring || one.kind() == Kind::run || one.kind() == Kind::region) continue;
    const Events fragments = in_fragments(region, number);
    parts.insert(parts.end(), fragments.begin(), fragments.end());
    region.clear();
  }
  REQUIRE(number > 1000);
  const SurfaceBuilder builder = build(parts);
  CHECK(builder.surface().polygons.size() > 100);
  check_same(builder, build(whole));
  CHECK(builder.incomplete_regions() == 0);
}

TEST_CASE("a region whose fragment is lost is counted and left out, and only that") {
  Events events, rest;
  add_fragment(events, 1, {run(north, 2), Run::fragment(0)});  // 0 never came
  add_region(events, {{run(east, 3), Run::fragment(1), run(south, 2)}});
  add_region(events, {rectangle()}, {1, 0, 8});
  add_region(rest, {rectangle()}, {1, 0, 8});
  const SurfaceBuilder builder = build(events);
  check_same(builder, build(rest));
  CHECK(builder.incomplete_regions() == 1);
}

TEST_CASE("a fragment is put back once") {
  Events events;
  const std::vector<Run> ring = {run(east, 3), Run::fragment(1), run(south, 2)};
  add_fragment(events, 1, {run(north, 2), run(west, 3)});
  add_region(events, {ring});
  add_region(events, {ring});
  const SurfaceBuilder builder = build(events);
  CHECK(builder.surface().polygons.size() == 1);
  CHECK(builder.incomplete_regions() == 1);
}

TEST_CASE("regions and fragments that the decoder reports lost are forgotten") {
  Events events, rest;
  add_region(events, {rectangle(), rectangle()});
  events.back().kind = Kind::lost;
  add_fragment(events, 4, {run(north, 2)});
  events.back().kind = Kind::lost;
  add_region(events, {rectangle()}, {1, 0, 4});
  add_region(events, {{run(east, 3), Run::fragment(4), run(west, 3), run(south, 2)}});
  add_region(rest, {rectangle()}, {1, 0, 4});
  const SurfaceBuilder builder = build(events);
  check_same(builder, build(rest));
  CHECK(builder.incomplete_regions() == 1);  // the one that needs the fragment
}

TEST_CASE("slits are dropped, and a ring that is nothing else is no region") {
  Events events, plain, slit;
  add_region(plain, {rectangle()});
  add_region(events, {{run(east, 3), run(north), run(east, 5), run(west, 5), run(north),
                       run(west, 3), run(south, 2)}});
  check_same(build(events), build(plain));
  add_region(slit, {{run(east, 3), run(west, 3)}});
  CHECK(build(slit).surface().polygons.empty());
}

TEST_CASE("a ring that touches itself is split into simple rings, the outer one first") {
  Events events;
  // Once around a square of 4 by 4 links, and on the way, from the middle of its first side, around
  // a diamond inside, clockwise.
  add_region(events,
             {{run(east, 2), run({-1, 1, 0}), run({1, 1, 0}), run({1, -1, 0}), run({-1, -1, 0}),
               run(east, 2), run(north, 4), run(west, 4), run(south, 4)}});
  const SurfaceBuilder builder = build(events);
  REQUIRE(builder.surface().polygons.size() == 1);
  const Polygon& polygon = builder.surface().polygons[0];
  REQUIRE(polygon.rings.size() == 2);
  CHECK(polygon.rings[0].size() == 16);
  CHECK(polygon.rings[1].size() == 4);
  CHECK(area(polygon, polygon.rings[0]) > 0);
  CHECK(area(polygon, polygon.rings[1]) < 0);
}

TEST_CASE("all rings of all regions are simple, one of them outer") {
  for (const std::uint32_t density : {60U, 128U, 200U}) {
    Events events;
    const auto told = events_of(discmc::reference::random({12, 12, 12}, density, density));
    for (const auto& one : told) events.push_back(one.event());
    const SurfaceBuilder builder = build(events);
    CHECK(builder.incomplete_regions() == 0);
    CHECK(!builder.surface().polygons.empty());
    for (const Polygon& polygon : builder.surface().polygons)
      for (const Ring& ring : polygon.rings) {
        CHECK(is_simple(ring));
        CHECK((area(polygon, ring) > 0) == (&ring == &polygon.rings[0]));
      }
  }
}

TEST_CASE("rings that do not close or enclose nothing are no regions") {
  Events events;
  add_region(events, {{run(east, 3), run(north, 2), run(west, 3)}});
  add_region(events, {{run(north, 2), run(east, 3), run(south, 2), run(west, 3)}});  // clockwise
  add_region(events, {{}});
  add_region(events, {});
  const SurfaceBuilder builder = build(events);
  CHECK(builder.surface().polygons.empty());
  CHECK(builder.incomplete_regions() == 4);
}

TEST_CASE("rings beyond the coordinates of any scan are no regions") {
  constexpr std::uint32_t most = Run::max_length;
  Events events;
  std::vector<Run> far(8, run(east, most));
  far.insert(far.end(), 8, run(west, most));
  add_region(events, {far});
  add_region(events, {std::vector<Run>(16, run(east, 1U << 27))});  // once around 32 bits
  add_region(events, {rectangle()}, {2147483647, 0, 0});
  const SurfaceBuilder builder = build(events);
  CHECK(builder.surface().polygons.empty());
  CHECK(builder.incomplete_regions() == 3);
}

TEST_CASE("more links than memory should hold are refused before they are unfolded") {
  constexpr std::uint32_t many = 1U << 27;
  Events events;
  add_region(events, {{run(east, many), run(west, many)}});
  SurfaceBuilder builder;
  const auto take_all = [&] {
    for (const Event& event : events) builder.take(event);
  };
  CHECK_THROWS_AS(take_all(), std::runtime_error);
}
