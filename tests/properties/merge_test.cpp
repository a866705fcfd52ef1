// The sweep's regions on all kinds of volumes, compared with the reference and with known results.
#include "oracle/agreement.hpp"
#include "oracle/event_log.hpp"
#include "oracle/scan.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

struct Named {
  std::string name;
  BitVolume volume;
};

std::vector<Named> shapes() {
  std::vector<Named> shapes = {{"lone voxel", from_bits({1, 1, 1}, 1)},
                               {"all on", box({5, 4, 3}, {0, 0, 0}, {4, 3, 2})},
                               {"all off", BitVolume({5, 4, 3})},
                               {"box", box({7, 6, 5}, {1, 2, 1}, {5, 4, 3})},
                               {"box on the border", box({33, 9, 8}, {0, 0, 0}, {31, 7, 7})},
                               {"plate", box({40, 40, 1}, {3, 3, 0}, {36, 36, 0})},
                               {"ball", ball({17, 17, 17}, {16, 16, 16}, 50)},
                               {"ball at the border", ball({19, 9, 13}, {1, 3, 20}, 60)},
                               {"torus", torus({40, 40, 14}, 26, 9)},
                               {"checkerboard", checkerboard({11, 10, 9})},
                               {"columns", columns({10, 11, 6})},
                               {"tiling of 61", tiling_61({11, 10, 9})},
                               {"tiling of 105", tiling({10, 11, 9}, 105)},
                               {"tiling of 121", tiling({9, 11, 10}, 121)},
                               {"comb", comb({33, 17, 3})},
                               {"spiral", spiral({62, 62, 2})},
                               {"spiral in depth", spiral({26, 31, 5})},
                               {"sparse", random({36, 15, 14}, 20, 1)},
                               {"random", random({36, 15, 14}, 128, 2)},
                               {"dense", random({36, 15, 14}, 236, 3)}};
  for (const uint32_t length : {200U, 97U}) {
    shapes.push_back({"along x", random({length, 2, 2}, 150, length)});
    shapes.push_back({"along y", random({2, length, 2}, 150, length)});
    shapes.push_back({"along z", random({2, 2, length}, 150, length)});
    shapes.push_back({"sheet", random({length, 1, 30}, 190, length)});
    shapes.push_back({"slice", random({length, 60, 1}, 200, length)});
  }
  return shapes;
}

Size small_size(uint64_t seed) {
  return {static_cast<uint32_t>(1 + seed % 9), static_cast<uint32_t>(1 + seed / 9 % 9),
          static_cast<uint32_t>(1 + seed / 81 % 9)};
}

// Densities from 10 to 244 of 256.
BitVolume small_random(uint64_t seed) {
  return random(small_size(seed), static_cast<uint32_t>(10 + seed * 39 % 235), seed);
}

// Returns the fault of a sweep with ample memory, or an empty text.
template <class Index>
std::string fault_of(const BitVolume& volume, bool is_closed) {
  try {
    const Plan plan{is_closed ? Border::closed : Border::open};
    Collector collector;
    scan_into<Index>(collector, volume, plan, ample);
    if (!collector.loose().empty()) return "loose fragments, with memory left";
    if (collector.split_sides() != 0) return "a straight side in more runs than it needs";
    const std::string miscount = miscounted(collector, volume, is_closed);
    if (!miscount.empty()) return miscount;
    const std::string difference = unlike_merge(collector.regions(), volume, is_closed);
    return difference.empty() ? unlike_surface(collector.regions(), volume, is_closed) : difference;
  } catch (const std::exception& error) {
    return error.what();
  }
}

EventLog events_of(const BitVolume& volume, Border border, const Capacities& capacities,
                   bool wide) {
  EventLog log;
  const Plan plan{border};
  if (wide)
    scan_into<uint32_t>(log, volume, plan, capacities);
  else
    scan_into<uint16_t>(log, volume, plan, capacities);
  return log;
}

uint64_t hash_of(const EventLog& log) {
  uint64_t hash = 0;
  for (const RecordedEvent& recorded : log.events)
    for_each_number(recorded.event(), [&](uint64_t number) {
      hash = hash * 0x100000001B3 + static_cast<uint32_t>(number);
    });
  return hash;
}

struct Known {
  uint64_t classic_triangles, facets;
  size_t regions, rings, links;
};

void check_known(const BitVolume& volume, const Known& known) {
  Collector collector;
  scan_into<uint32_t>(collector, volume, {}, 16 << 20);
  CHECK(collector.statistics().classic_triangles == known.classic_triangles);
  CHECK(collector.statistics().facets == known.facets);
  size_t rings = 0;
  size_t links = 0;
  for (const Region& region : simple_rings(collector.regions())) {
    rings += region.rings.size();
    for (const Ring& ring : region.rings) links += ring.size();
  }
  CHECK(collector.regions().size() == known.regions);
  CHECK(rings == known.rings);
  CHECK(links == known.links);
  CHECK(collector.statistics().links == known.links);
  CHECK(unlike_surface(collector.regions(), volume, true) == "");
}

}  // namespace

TEST_CASE("regular and hostile shapes are swept as in the paper") {
  for (const Named& shape : shapes())
    for (const bool is_closed : {true, false}) {
      INFO(shape.name, ", is_closed ", is_closed);
      CHECK(fault_of<uint16_t>(shape.volume, is_closed) == "");
      CHECK(fault_of<uint32_t>(shape.volume, is_closed) == "");
    }
}

TEST_CASE("thousands of small random volumes are swept as in the paper") {
  for (uint64_t seed = 0; seed < 5000; seed += step(13))
    for (const bool is_closed : {true, false}) {
      const std::string fault = fault_of<uint16_t>(small_random(seed), is_closed);
      INFO("seed ", seed, ", is_closed ", is_closed);
      REQUIRE(fault == "");
    }
}

TEST_CASE("every combination of sides from 1 to 6 voxels is swept as in the paper") {
  for (uint32_t i = 0; i < 216; i += step(5))
    for (const uint32_t density : {90U, 180U, 256U})
      for (const bool is_closed : {true, false}) {
        const BitVolume volume = random({1 + i % 6, 1 + i / 6 % 6, 1 + i / 36}, density, i);
        INFO("i ", i, ", density ", density, ", is_closed ", is_closed);
        CHECK(fault_of<uint16_t>(volume, is_closed) == "");
      }
}

TEST_CASE("spirals of more than 255 turns are swept as in the paper") {
  // More turns than a byte can count.
  for (const uint32_t side : {100U, 181U, 260U}) {
    const BitVolume volume = spiral({side, side, 1});
    CAPTURE(side);
    CHECK(fault_of<uint32_t>(volume, true) == "");
  }
}

TEST_CASE("balls yield the recorded counts") {
  constexpr Size size{100, 100, 100};
  constexpr Vertex centre{100, 100, 100};
  check_known(ball(size, centre, 1004), {37784, 46040, 2422, 2466, 32880});
  check_known(ball(size, centre, 1001), {37784, 46136, 2278, 2322, 32208});
  check_known(ball(size, centre, 1002), {37784, 45944, 2328, 2374, 32208});
}

TEST_CASE("a ball of radius 120 centred between voxels yields the recorded counts") {
  check_known(ball({256, 256, 256}, {255, 255, 255}, 120 * 120),
              {542924, 663116, 37558, 37746, 484992});
}

TEST_CASE("events do not depend on index width or capacities unless fragments are loose") {
  for (const Named& shape : shapes())
    for (const Border border : {Border::closed, Border::open}) {
      constexpr Capacities more{ample.slots + 1777, ample.holes + 79};
      CAPTURE(shape.name);
      const EventLog narrow = events_of(shape.volume, border, ample, false);
      CHECK(events_of(shape.volume, border, ample, true).events == narrow.events);
      CHECK(events_of(shape.volume, border, more, true).events == narrow.events);
    }
}

TEST_CASE("events do not depend on the index width, even if slots run out") {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    const BitVolume volume = small_random(seed);
    const auto extra = static_cast<uint32_t>(seed % 50);
    const Capacities few{minimum_capacities().slots + 3 * extra, extra / 5};
    const Border border = seed % 2 == 0 ? Border::closed : Border::open;
    CHECK(events_of(volume, border, few, true).events ==
          events_of(volume, border, few, false).events);
  }
}

TEST_CASE("a region is delivered before the first layer mark that it does not reach") {
  const BitVolume volume = random({12, 12, 12}, 60, 5);
  const Collector collector = scan<uint16_t>(volume);
  REQUIRE(collector.layers().size() == 12);
  for (const LayerMark& mark : collector.layers())
    for (size_t i = 0; i < collector.regions().size(); ++i) {
      int32_t top = INT32_MIN;
      for (const Vertex& vertex : collector.regions()[i].rings[0]) top = std::max(top, vertex.z);
      const bool reaches = top >= 2 * static_cast<int32_t>(mark.slice);
      CHECK((i < mark.regions || reaches));
    }
}

TEST_CASE("the events of a fixed volume have the recorded hash") {
  const BitVolume volume = random({14, 13, 12}, 150, 11);
  const EventLog log = events_of(volume, Border::closed, ample, false);
  CHECK(hash_of(log) == 2843474493360604257ULL);
}

TEST_CASE("the order of rings in regions with many holes is the same on every machine") {
  const BitVolume volume = random({40, 40, 2}, 235, 3);
  const EventLog log = events_of(volume, Border::closed, ample, false);
  CHECK(hash_of(log) == 11100549875466600305ULL);
}
