// The surface builder: it removes lost regions, and makes sweep rings simple.
#include "surface/surface_builder.hpp"

#include <discmc/polygon.hpp>
#include <tuple>

#include "hand_made.hpp"
#include "host/host_scan.hpp"
#include "oracle/stream_samples.hpp"
#include "test.hpp"

namespace {

using namespace discmc;
using namespace discmc::meshing;
using discmc::test::Events;
using discmc::test::events_of;
using discmc::test::Script;
using discmc::test::up;
using hand_made::are_same;
using hand_made::Corners;
using hand_made::rings_of;

// The events of a region without its end.
Script begun_region(const std::vector<std::vector<Run>>& rings, Vertex start = {1, 0, 0}) {
  Script script;
  script.region(up);
  for (const auto& ring : rings) {
    script.ring(start, &ring != &rings[0]);
    for (const Run run : ring) script.run(run);
  }
  return script;
}

Events region(const std::vector<std::vector<Run>>& rings, Vertex start = {1, 0, 0}) {
  return begun_region(rings, start).region_end().events;
}

SurfaceBuilder build(const Events& events) {
  SurfaceBuilder builder;
  for (const auto& event : events)
    REQUIRE(builder.accept(event.event()) == discmc::SinkResult::accepted);
  return builder;
}

void check_none(const Events& region) {
  const SurfaceBuilder builder = build(region);
  CHECK(builder.surface().polygons.empty());
  CHECK(builder.incomplete_regions() == 1);
}

// A straight run in the plane of `up` with links of this step.
Run run(const Vertex& step, std::uint32_t length = 1) {
  for (discmc::Direction direction = 0; direction < 8; ++direction)
    if (discmc::direction_vector(up, direction) == step) return Run::straight(direction, length);
  FAIL("no such link");
  return {};
}

const Vertex east = {2, 0, 0}, north = {0, 2, 0}, west = {-2, 0, 0}, south = {0, -2, 0};

std::vector<Run> rectangle() {
  return {run(east, 3), run(north, 2), run(west, 3), run(south, 2)};
}

bool is_simple(const Ring& ring) {
  const std::vector<Vertex> all = hand_made::every_vertex(ring);
  std::set<std::tuple<int, int, int>> vertices;
  for (const Vertex& vertex : all) vertices.emplace(vertex.x, vertex.y, vertex.z);
  return vertices.size() == all.size();
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

}  // namespace

TEST_CASE("a region becomes a polygon with the corners of its rings") {
  const SurfaceBuilder builder = build(region({rectangle()}));
  REQUIRE(builder.surface().polygons.size() == 1);
  const Polygon polygon = builder.surface().polygons[0];
  REQUIRE(polygon.rings.size() == 1);
  CHECK(polygon.incidence == up);
  CHECK(rings_of(polygon)[0] == Corners{{7, 4, 0}, {1, 4, 0}, {1, 0, 0}, {7, 0, 0}});
  CHECK(area(polygon) == 2 * 6 * 4);
}

TEST_CASE("the surface builder drops regions and fragments that the decoder reports lost") {
  const Events rest = region({rectangle()}, {1, 0, 4});
  Script script = begun_region({rectangle(), rectangle()}).lost();
  script.fragment(up, {}, 0).run(run(north, 2)).lost();
  Events events = script.events;
  events.insert(events.end(), rest.begin(), rest.end());
  const Events loose = Script().fragment(up, {}, 0).run(run(north, 2)).fragment_end().events;
  events.insert(events.end(), loose.begin(), loose.end());
  const SurfaceBuilder builder = build(events);
  CHECK(are_same(builder.surface(), build(rest).surface()));
  CHECK(builder.incomplete_regions() == 1);  // the fragment without a partner
}

TEST_CASE("the surface builder removes slits from rings, and drops rings of only slits") {
  const Events with_slits = region({{run(east, 3), run(north), run(east, 5), run(west, 5),
                                     run(north), run(west, 3), run(south, 2)}});
  CHECK(are_same(build(with_slits).surface(), build(region({rectangle()})).surface()));
  CHECK(build(region({{run(east, 3), run(west, 3)}})).surface().polygons.empty());
}

TEST_CASE("a straight side has two corners, for any number of runs and any start of the ring") {
  const SurfaceBuilder builder = build(
      region({{run(east), run(east), run(north, 2), run(west, 3), run(south, 2), run(east)}}));
  REQUIRE(builder.surface().polygons.size() == 1);
  CHECK(rings_of(builder.surface().polygons[0])[0] ==
        Corners{{5, 4, 0}, {-1, 4, 0}, {-1, 0, 0}, {5, 0, 0}});
}

TEST_CASE("a ring that winds twice is split into simple rings, even without a right turn") {
  std::vector<Run> twice = rectangle();
  for (const Run& run : rectangle()) twice.push_back(run);
  const SurfaceBuilder builder = build(region({twice}));
  for (const Polygon& polygon : builder.surface().polygons)
    for (const Ring& ring : polygon.rings) CHECK(is_simple(ring));
}

TEST_CASE("a ring that touches itself is split into simple rings, the outer one first") {
  // Once around a square of 4 by 4 links. From the middle of its first side, the ring also goes
  // around an inner diamond, clockwise.
  const SurfaceBuilder builder =
      build(region({{run(east, 2), run({-1, 1, 0}), run({1, 1, 0}), run({1, -1, 0}),
                     run({-1, -1, 0}), run(east, 2), run(north, 4), run(west, 4), run(south, 4)}}));
  REQUIRE(builder.surface().polygons.size() == 1);
  const Polygon polygon = builder.surface().polygons[0];
  REQUIRE(polygon.rings.size() == 2);
  CHECK(polygon.rings[0].size() == 4);
  CHECK(polygon.rings[1].size() == 4);
  CHECK(area(polygon, polygon.rings[0]) > 0);
  CHECK(area(polygon, polygon.rings[1]) < 0);
}

TEST_CASE("every region has only simple rings, of which one is outer") {
  for (const std::uint32_t density : {60U, 128U, 200U}) {
    const SurfaceBuilder builder =
        build(events_of(discmc::reference::random({12, 12, 12}, density, density)));
    CHECK(builder.incomplete_regions() == 0);
    CHECK(!builder.surface().polygons.empty());
    for (const Polygon& polygon : builder.surface().polygons)
      for (const Ring& ring : polygon.rings) {
        CHECK(is_simple(ring));
        CHECK((area(polygon, ring) > 0) == (ring.data() == polygon.rings[0].data()));
      }
  }
}

TEST_CASE("regions passed in one call give the same polygons as their single events") {
  struct Whole {
    SurfaceBuilder builder{};
    SinkResult accept(const Event& event) { return builder.accept(event); }
    SinkResult accept_region(const OneRingRegion& region) {
      builder.accept_region(region);
      return SinkResult::accepted;
    }
  };
  for (const std::uint32_t density : {60U, 128U, 200U}) {
    const discmc::reference::BitVolume volume =
        discmc::reference::random({12, 12, 12}, density, density);
    Whole whole;
    HostScan scan;
    scan.start({12, 12}, make_sink(whole), make_region_receiver(whole));
    for (std::size_t row = 0; row < volume.on.size(); row += 12) {
      std::uint8_t bits[2] = {};
      for (std::size_t x = 0; x < 12; ++x)
        bits[x / 8] = static_cast<std::uint8_t>(bits[x / 8] | volume.on[row + x] << x % 8);
      scan.push(bits);
    }
    scan.finish();
    CHECK(are_same(whole.builder.surface(), build(events_of(volume)).surface()));
  }
}

TEST_CASE("the surface builder drops rings that do not close or enclose no area") {
  const std::vector<std::vector<std::vector<Run>>> wrong = {
      {{run(east, 3), run(north, 2), run(west, 3)}},
      {{run(north, 2), run(east, 3), run(south, 2), run(west, 3)}},  // clockwise
      {{}},
      {}};
  for (const auto& rings : wrong) check_none(region(rings));
}

TEST_CASE("the surface builder drops rings beyond the coordinates of any scan") {
  constexpr std::uint32_t most = Run::max_length;
  std::vector<Run> far(8, run(east, most));
  far.insert(far.end(), 8, run(west, most));
  check_none(region({far}));
  check_none(region({std::vector<Run>(16, run(east, 1U << 27))}));  // wraps around 32 bits
  check_none(region({rectangle()}, {2147483647, 0, 0}));
}

TEST_CASE("a ring of over 2^29 links is split at the point where the ring touches itself") {
  // A strip with a notch. The tip of the notch is in the middle of the other side.
  constexpr std::int32_t half = 1 << 27;
  const SurfaceBuilder builder =
      build(region({{run(east, half), run({1, 1, 0}, 6), run({1, -1, 0}, 6), run(east, half),
                     run(north, 3), run(west, 2 * half + 6), run(south, 3)}}));
  REQUIRE(builder.surface().polygons.size() == 1);
  const Vertex left = {1 + 2 * half, 0, 0}, tip = {7 + 2 * half, 6, 0},
               right = {13 + 2 * half, 0, 0};
  CHECK(rings_of(builder.surface().polygons[0]) ==
        std::vector<Corners>{{tip, {1, 6, 0}, {1, 0, 0}, left},
                             {{13 + 4 * half, 6, 0}, tip, right, {13 + 4 * half, 0, 0}}});
}

TEST_CASE("a surface builder that only counts gives the same counts as one that keeps polygons") {
  const Events events = events_of(discmc::reference::random({16, 16, 16}, 200, 5));
  SurfaceBuilder counter(Kept::counts);
  for (const auto& event : events) counter.accept(event.event());
  CHECK(counter.surface().polygons.empty());
  const Counts& counts = counter.counts();
  const SurfaceBuilder builder = build(events);
  std::uint64_t rings = 0, corners = 0, links = 0;
  std::map<std::size_t, std::uint64_t> by_corners;
  for (const Polygon& polygon : builder.surface().polygons) {
    std::size_t own = 0;
    for (const Ring& ring : polygon.rings) {
      own += ring.size();
      links += hand_made::every_vertex(ring).size();
    }
    rings += polygon.rings.size();
    corners += own;
    ++by_corners[own];
  }
  const std::uint64_t regions = builder.surface().polygons.size();
  CHECK(counts.regions == regions);
  CHECK(counts.rings == rings);
  CHECK(counts.holes == rings - regions);
  CHECK(counts.holes > 0);
  CHECK(counts.corners == corners);
  CHECK(counts.links == links);
  CHECK(counts.of_three_corners == by_corners[3]);
  CHECK(counts.of_four_corners == by_corners[4]);
  CHECK(counts.of_more_corners == regions - by_corners[3] - by_corners[4]);
}

TEST_CASE("the surface builder sorts polygons by z, y and x of their last vertices") {
  // The heights are so far apart that polygons of two of them have equal sort keys.
  const Corners order = {{1, 2, -1}, {9, -1, 0}, {-1, 4, 0},    {7, 4, 0},
                         {3, 6, 0},  {1, 0, 8},  {9, 8, 5'997}, {1, 0, 5'998}};
  discmc::meshing::Polygons polygons;
  for (std::size_t i = order.size(); i-- > 0;) {
    const Corners ring = {order[i], order[i] + west, order[i] + west + south};
    polygons.add_polygon(up);
    polygons.add_ring({ring.data(), ring.data() + ring.size()});
  }
  polygons.sort();
  for (std::size_t i = 0; i < order.size(); ++i) CHECK(polygons[i].rings[0][0] == order[i]);
}
