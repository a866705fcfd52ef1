// A host extractor sends the same events as other extractors, wherever it hands over its fragments.
#include "host/host_extractor.hpp"

#include <iterator>

#include "oracle/checkpointed_device.hpp"
#include "oracle/event_log.hpp"
#include "oracle/join.hpp"
#include "oracle/minimum_host.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "oracle/stream.hpp"
#include "oracle/thinned.hpp"
#include "shapes/bars.hpp"
#include "shapes/combs.hpp"
#include "shapes/saws.hpp"
#include "shapes/tents.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// The minimum number of slots with which chains are kept as nodes. With a few more, they are kept
// for some rows.
constexpr uint32_t min_for_nodes = host::Chains::min_slots;
constexpr Capacities much{min_for_nodes + 20000, 100};

// A plate with holes of many shapes: rings of many runs, and rings that touch themselves.
BitVolume plate() {
  const Size size{60, 50, 3};
  const BitVolume noise = random(size, 190, 6);
  return volume_of(size, [&](uint32_t x, uint32_t y, uint32_t z) {
    const bool is_rim = x == 0 || y == 0 || x == 59 || y == 49;
    return z == 1 && (is_rim || noise.at(x, y, z));
  });
}

std::vector<BitVolume> volumes() {
  return {random({40, 9, 12}, 128, 1),
          random({9, 40, 12}, 20, 2),
          checkerboard({8, 8, 8}),
          ball({30, 30, 30}, {29, 29, 29}, 600),
          box({5, 5, 5}, {1, 1, 1}, {3, 3, 3}),
          box({4200, 3, 3}, {0, 1, 1}, {4199, 1, 1}),
          plate()};
}

struct SlabScan {
  const BitVolume& volume;
  Border border;
  uint32_t first, end;

  uint32_t slices_before = 0;  // the height of the first slice of the volume

  Limits limits() const {
    Limits limits = limits_of_slab(volume, border, first, end);
    limits.slab.first += slices_before;
    return limits;
  }

  template <class Extractor>
  EventLog by(Extractor& extractor, const Capacities& capacities,
              const EventLog::Refuses& refuses = {}) const {
    EventLog log(refuses);
    Block block(Extractor32::bytes_for(limits(), capacities));
    require_ok(extractor.start(limits(), capacities, 1, block.memory(), make_sink(log)));
    push_all(extractor, voxels_of_slab(volume, first, end));
    finish_all(extractor);
    CHECK(block.is_intact());
    return log;
  }
};

// A started scan, with much memory.
struct Started {
  template <class Extractor>
  Started(Extractor& extractor, const Limits& limits, const EventLog::Refuses& refuses = {})
      : log(refuses), block(Extractor32::bytes_for(limits, much)) {
    require_ok(extractor.start(limits, much, 1, block.memory(), make_sink(log)));
  }
  EventLog log;
  Block block;
};

// Returns the events of an extractor.
template <class Extractor>
EventLog scanned(Extractor& extractor, const BitVolume& volume, const Plan& plan,
                 const Capacities& capacities = much, const EventLog::Refuses& refuses = {}) {
  return SlabScan{volume, plan.border, 0, volume.depth}.by(extractor, capacities, refuses);
}

// Returns the events of another extractor with ample memory.
EventLog expected_of(const BitVolume& volume, const Plan& plan = {}) {
  Extractor32 extractor;
  return scanned(extractor, volume, plan, {1000000, 1000});
}

void check_like_others(const Capacities& capacities = much, const EventLog::Refuses& refuses = {}) {
  HostExtractor extractor;
  for (const Border border : {Border::closed, Border::open})
    for (const BitVolume& volume : volumes()) {
      const Plan plan{border};
      Extractor32 other;
      const EventLog expected = scanned(other, volume, plan, capacities);
      CHECK(scanned(extractor, volume, plan, capacities, refuses).events == expected.events);
    }
}

bool refuses_some(uint64_t offer) {
  return offer * 0x9E3779B97F4A7C15 >> 62 == 0;
}

// Whether the scan kept chains as nodes: then it has used many slots.
template <class Extractor>
bool has_kept_nodes(const Extractor& extractor) {
  return extractor.peaks().slots >= min_for_nodes / 4;
}

// Scans a volume with few slots above the minimum, so that fragments are handed over during the
// scan.
class HandingOver {
 public:
  HandingOver(const BitVolume& volume, Border border) : volume_(volume) {
    plan_.border = border;
    expected_ = expected_of(volume, plan_);
  }
  void check(uint32_t slots_beyond, const EventLog::Refuses& refuses = {}) {
    CAPTURE(slots_beyond);
    const Capacities capacities{min_for_nodes + slots_beyond, 1000};
    const EventLog log = scanned(extractor_, volume_, plan_, capacities, refuses);
    CHECK(has_kept_nodes(extractor_));
    CHECK(log.events == expected_.events);
  }

 private:
  const BitVolume& volume_;
  Plan plan_;
  EventLog expected_;
  HostExtractor extractor_;
};

// Walls along a diagonal of the slices, with sides of a thousand links or more, and some noise.
BitVolume walls(Size size) {
  const BitVolume noise = random(size, 1, 7);
  return volume_of(size, [&](uint32_t x, uint32_t y, uint32_t z) {
    const bool is_flipped = noise.index(x, y, z) % 32 == 0 && noise.at(x, y, z);
    return ((x + y) % 70 < 3) != is_flipped;
  });
}

// Columns that alternate from slice to slice: their sides are open to the last slice, with corners
// in each slice.
BitVolume zigzag_columns(Size size) {
  return volume_of(
      size, [](uint32_t x, uint32_t y, uint32_t z) { return (x + z % 2) % 4 < 2 && y % 4 < 2; });
}

// Teeth with jagged sides, joined by the last rows. They are wide, so some sides are level.
BitVolume jagged_comb(uint32_t teeth, uint32_t height) {
  return volume_of({5 * teeth, height, 1}, shapes::Comb{5, 3, height - 2, 1});
}

// Returns a volume with y and z exchanged.
BitVolume upright(const BitVolume& volume) {
  return volume_of({volume.width, volume.depth, volume.height},
                   [&](uint32_t x, uint32_t y, uint32_t z) { return volume.at(x, z, y); });
}

// Copies a volume into another one, from slice z on.
void put(BitVolume& volume, const BitVolume& part, uint32_t z) {
  for (int64_t i = 0; i < part.depth; ++i)
    for (int64_t y = 0; y < part.height; ++y)
      for (int64_t x = 0; x < part.width; ++x)
        volume.on[volume.index(x, y, z + i)] = part.at(x, y, i) ? 1 : 0;
}

// Scans with this many slots, ignores the events, and returns the totals.
template <class Extractor>
Statistics totals_of(Extractor& extractor, const BitVolume& volume, uint32_t slots) {
  struct Taker {
    SinkResult accept(const Event&) { return SinkResult::accepted; }
  } taker;
  const Limits limits = limits_of(volume, Border::closed);
  const Capacities capacities{slots, 1000};
  Block block(Extractor32::bytes_for(limits, capacities));
  require_ok(extractor.start(limits, capacities, 1, block.memory(), make_sink(taker)));
  push_all(extractor, volume.on);
  finish_all(extractor);
  CHECK(block.is_intact());
  return extractor.statistics();
}

// Checks the slots in use with this many slots above the minimum, and with one slot less.
struct Step {
  uint32_t beyond;  // with one less, the peak is that of the step before
  uint32_t in_use;
};
void check_steps(const BitVolume& volume, const std::vector<Step>& steps) {
  HostExtractor extractor;
  Extractor32 other;
  const Statistics expected = totals_of(other, volume, 100000);
  const auto check = [&](uint32_t beyond, uint32_t in_use) {
    CAPTURE(beyond);
    const Statistics totals = totals_of(extractor, volume, min_for_nodes + beyond);
    CHECK(extractor.peaks().slots == in_use);
    CHECK(totals.links == expected.links);
    CHECK(totals.regions == expected.regions);
    CHECK(totals.fragments == 0);
  };
  for (size_t i = 0; i < steps.size(); ++i) {
    if (i > 0) check(steps[i].beyond - 1, steps[i - 1].in_use);
    check(steps[i].beyond, steps[i].in_use);
  }
}

// Records the events of the regions that it accepts whole: every second region.
struct EverySecond {
  EventLog& log;
  uint32_t offered = 0;

  SinkResult accept_region(const OneRingRegion& region) {
    if (++offered % 2 == 0) return SinkResult::busy;
    send_events(region,
                [this](const Event& event) { return log.accept(event) == SinkResult::accepted; });
    return SinkResult::accepted;
  }
};

// ---- slabs ----

// Heights of slabs, used in turn.
const std::vector<uint32_t> thicknesses[] = {{1}, {2}, {3}, {7}, {3, 1, 2}};

template <class Visit>
void for_each_slab(const BitVolume& volume, const std::vector<uint32_t>& thick, Visit visit) {
  size_t turn = 0;
  for (uint32_t first = 0; first < volume.depth;) {
    const uint32_t end = std::min(first + thick[turn++ % thick.size()], volume.depth);
    visit(first, end);
    first = end;
  }
}

std::vector<std::vector<uint64_t>> parts_of(const EventLog& log, const SlabScan& scan) {
  (void)collected(log.events, scan.limits().slab);  // checks the grammar
  return sorted_parts(log.events);
}

void check_same_parts(const SlabScan& scan, const Capacities& capacities = much) {
  HostExtractor extractor;
  Extractor32 other;
  CHECK(parts_of(scan.by(extractor, capacities), scan) ==
        parts_of(scan.by(other, capacities), scan));
}

// Whether an event belongs to a region or a loose fragment.
bool is_piece(const RecordedEvent& event) {
  return !event.is(Event::Kind::start) && !event.is(Event::Kind::layer) &&
         !event.is(Event::Kind::finish);
}

std::vector<Region> regions_among(const Events& events) {
  std::vector<Region> regions;
  for (const Events& piece : test::pieces_of(events)) regions.push_back(region_of(piece));
  return canonical(std::move(regions));
}

// Columns through all slices, without some voxels.
BitVolume rough_columns(Size size) {
  BitVolume volume = columns(size);
  const BitVolume noise = random(size, 12, 9);
  for (size_t i = 0; i < volume.on.size(); ++i) volume.on[i] ^= noise.on[i];
  return volume;
}

// Chains of all kinds across seams: holes in level planes, vertical, rising and falling ones, and
// noise.
std::vector<BitVolume> volumes_of_slabs() {
  return {random({13, 9, 8}, 128, 1),
          random({33, 12, 15}, 20, 2),
          checkerboard({8, 8, 8}),
          columns({9, 9, 9}),
          ball({18, 18, 18}, {17, 17, 17}, 200),
          box({5, 5, 15}, {1, 1, 0}, {3, 3, 14}),
          torus({24, 24, 24}, 8, 3),
          spiral({15, 15, 9})};
}

// The faces of the box cross all seams, and so do some of their holes.
BitVolume slanting_plate_with_holes() {
  const auto is_inside = [](uint32_t at) { return at >= 2 && at < 46; };
  BitVolume plate = volume_of({48, 48, 48}, [&](uint32_t x, uint32_t y, uint32_t z) {
    return is_inside(y) && is_inside(z) && x + z >= 44 && x + z < 51;
  });
  test::Chance chance(1);
  for (int hole = 0; hole < 25; ++hole) {
    const uint32_t z = 3 + chance.below(37), y = 3 + chance.below(37);
    const uint32_t height = 1 + chance.below(8), width = 1 + chance.below(8);
    for (uint32_t k = z; k < z + height; ++k)
      for (uint32_t j = y; j < y + width; ++j)
        for (uint32_t x = 0; x < 48; ++x) plate.on[plate.index(x, j, k)] = 0;
  }
  return plate;
}

}  // namespace

TEST_CASE("a HostExtractor sends the events of other extractors in repeated scans") {
  check_like_others();
}

TEST_CASE("a deep scan needs no more node memory than a shallow scan") {
  const Size size{100, 60, 4};
  const BitVolume slices = random(size, 70, 3);
  HostExtractor extractor;
  const auto slots_of = [&](uint32_t depth, uint32_t slots) {
    BitVolume volume({size.width, size.height, depth});
    for (size_t i = 0; i < volume.on.size(); ++i) volume.on[i] = slices.on[i % slices.on.size()];
    CHECK(scanned(extractor, volume, {}, {slots, 100}).events == expected_of(volume).events);
    return extractor.peaks().slots;
  };
  const uint32_t enough = slots_of(8, 400000);
  CHECK(enough > min_for_nodes);  // more than initially
  CHECK(slots_of(20, 400000) == enough);
  for (const uint32_t slots : {enough, 3 * enough / 2}) CHECK(slots_of(4, slots) <= slots);
}

// Only peaks() shows the slots of queues and nodes.
TEST_CASE("memory for nodes grows in steps, even if each step only just fits") {
  check_steps(box({5, 5, 5}, {1, 1, 1}, {3, 3, 3}), {{0, 33097}});
  check_steps(zigzag_columns({40, 40, 12}),
              {{0, 45385}, {10028, 45777}, {10224, 46169}, {36120, 70745}});
  check_steps(random({40, 40, 6}, 128, 3), {{0, 45385}, {36238, 69961}});
}

TEST_CASE("memory grows in steps with more open fragments") {
  check_steps(zigzag_columns({40, 40, 20}), {{36120, 70745}, {137590, 119897}});
}

TEST_CASE("memory for queues grows in steps") {
  check_steps(columns({60, 60, 3}), {{0, 47737}, {144, 48129}, {340, 48737}, {4344, 49569}});
}

TEST_CASE(
    "memory for nodes and memory for queues grow in the same scan, together or one after another") {
  check_steps(random({60, 60, 6}, 128, 3), {{23992, 49060}});
  BitVolume both({60, 60, 16});
  put(both, columns({60, 60, 8}), 0);
  put(both, zigzag_columns({40, 40, 6}), 9);
  check_steps(both, {{50847, 73097}});
}

// At an open border only one chain uses a link; elsewhere another chain uses it in the other
// direction.
TEST_CASE("queues have room if more chains leave than enter along a link") {
  constexpr uint32_t teeth = 3000;
  const BitVolume saw = volume_of({4, 8 * teeth, 4}, shapes::Saw{});
  const Plan plan{Border::open, 0};
  HostExtractor extractor;
  CHECK(scanned(extractor, saw, plan, {500000, 1000}).events == expected_of(saw, plan).events);
  CHECK(has_kept_nodes(extractor));
}

TEST_CASE("a scan after a handover of fragments has all slots available") {
  // Noise and columns for which memory grows, then a distant slice that needs nearly all of it.
  BitVolume volume({241, 241, 7});
  put(volume, columns({60, 60, 2}), 0);
  put(volume, random({40, 40, 2}, 128, 5), 2);
  const BitVolume noise = random({241, 241, 1}, 128, 3);
  std::copy(noise.on.begin(), noise.on.end(), &volume.on[volume.index(0, 0, 6)]);
  HostExtractor extractor;
  Extractor32 other;
  constexpr uint32_t enough = 103685;
  static_assert(enough >= min_for_nodes, "nodes are kept");
  CHECK(totals_of(other, volume, enough - 1).fragments > 0);
  CHECK(totals_of(extractor, volume, enough).fragments == 0);
}

TEST_CASE("rings of any length are closed, even after many unsuccessful walks") {
  HostExtractor extractor;
  Extractor32 other;
  const auto check = [&](const BitVolume& volume) {
    CHECK(scanned(extractor, volume, {}, {min_for_nodes, 10}).events ==
          scanned(other, volume, {}, {20000, 10}).events);
  };
  for (const uint32_t teeth : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 12U, 40U}) {
    CAPTURE(teeth);
    check(jagged_comb(teeth, 40));
    check(upright(jagged_comb(teeth, 40)));
  }
  // A ring of 128 corners, a quarter of the listed maximum.
  check(jagged_comb(3, 26));
}

TEST_CASE("rings are found even if nodes are copied after long unsuccessful walks") {
  BitVolume plate({200, 200, 3});
  const BitVolume noise = random({200, 200, 2}, 190, 7);
  std::copy(noise.on.begin(), noise.on.end(), plate.on.begin());
  HostExtractor extractor;
  Extractor32 other;
  CHECK(scanned(extractor, plate, {}, {min_for_nodes + 100000, 10000}).events ==
        scanned(other, plate, {}, {1000000, 10000}).events);
}

TEST_CASE("a host extractor with too few slots for nodes sends the same events") {
  constexpr uint32_t slots[] = {60, 200, 1100, 3000, min_for_nodes - 1};
  for (size_t i = 0; i < std::size(slots); i += step(2)) check_like_others({slots[i], 10});
  HostExtractor extractor;
  (void)scanned(extractor, plate(), {}, {min_for_nodes - 1, 10});
  CHECK(!has_kept_nodes(extractor));
  (void)scanned(extractor, plate(), {}, {min_for_nodes, 10});
  CHECK(has_kept_nodes(extractor));
}

TEST_CASE("a host extractor sends the same events even if the sink is sometimes busy") {
  for (const Capacities& capacities : {much, Capacities{1200, 10}}) {
    check_like_others(capacities, refuses_first);
    check_like_others(capacities, refuses_some);
  }
}

TEST_CASE("a host extractor sends the same events if any single offer is refused") {
  // Two plates, one with a hole, so there are rings with and without holes on a plane.
  BitVolume plates = box({9, 5, 5}, {0, 0, 1}, {8, 4, 1});
  plates.on[plates.index(2, 2, 1)] = 0;
  for (int64_t x = 0; x < 4; ++x) plates.on[plates.index(x, 3, 3)] = 1;
  const EventLog expected = expected_of(plates);
  HostExtractor extractor;
  for (uint64_t refused = 0; refused < expected.events.size(); ++refused) {
    const auto refuses = [refused](uint64_t offer) { return offer == refused; };
    const EventLog log = scanned(extractor, plates, {}, {min_for_nodes, 10}, refuses);
    CHECK(log.events == expected.events);
    CHECK(log.refusals() == 1);
  }
}

TEST_CASE("regions delivered whole equal the regions sent to the sink event by event") {
  HostExtractor extractor;
  for (const BitVolume& volume : volumes()) {
    Started started(extractor, limits_of(volume, Border::closed));
    EverySecond receiver{started.log};
    extractor.set_region_receiver(make_region_receiver(receiver));
    push_all(extractor, volume.on);
    finish_all(extractor);
    CHECK(receiver.offered > 0);
    CHECK(started.log.events == expected_of(volume).events);
  }
}

TEST_CASE(
    "a host extractor sends the same events for any point at which fragments are handed over") {
  const BitVolume noise = random({150, 110, 4}, 60, 8);
  HandingOver closed(noise, Border::closed), open(noise, Border::open);
  for (uint32_t beyond = 0; beyond < 24000; beyond += 2000 * step(3)) {
    closed.check(beyond);
    open.check(beyond, refuses_some);
  }
}

TEST_CASE("a side longer than a run is handed over within a row") {
  const BitVolume volume = walls({1400, 900, 2});
  HandingOver scan(volume, Border::closed);
  for (const uint32_t beyond : {0U, 2000U, 5000U, 10000U}) scan.check(beyond);
}

TEST_CASE("a side across all rows of a slice, above a row of noise, is handed over") {
  // The side is longer than the range of places, which repeat after 8,192 links.
  constexpr uint32_t size = 2000;
  BitVolume slope({size, size, 1});
  for (int64_t y = 0; y < size; ++y)
    for (int64_t x = y; x < size && x < y + 10; ++x) slope.on[slope.index(x, y, 0)] = 1;
  const BitVolume noise = random({size, 1, 1}, 128, 6);
  std::copy(noise.on.begin(), noise.on.end(), &slope.on[slope.index(0, size - 50, 0)]);
  HostExtractor extractor;
  Extractor32 other;
  const EventLog expected = scanned(other, slope, {}, much);
  for (const uint32_t beyond : {0U, 20000U}) {
    const EventLog log = scanned(extractor, slope, {}, {min_for_nodes + beyond, 100});
    CHECK(log.events == expected.events);
    CHECK(has_kept_nodes(extractor));
  }
}

TEST_CASE("a long side that turns upwards at a centroid is handed over") {
  // The side is longer than the range of places, which repeat after 8,192 links. Noise follows
  // while the end of the side waits for the slice in which it turns.
  constexpr uint32_t size = 850;
  HostExtractor extractor;
  Extractor32 other;
  for (const uint32_t seed : {1U, 9U, 12U}) {  // links whose ends turn
    CAPTURE(seed);
    const BitVolume end = random({size, 10, 3}, 128, seed);
    const BitVolume noise = random({size, 100, 1}, 43, seed);
    BitVolume slope({size, size, 4});
    for (int64_t y = 0; y < size; ++y)
      for (int64_t x = 0; x < size; ++x) {
        const bool is_slope = x > y - 3 && x < y + 3;
        slope.on[slope.index(x, y, 1)] = is_slope;
        if (y + 10 >= size && x > y - 6)
          for (int64_t z = 0; z < 3; ++z)
            slope.on[slope.index(x, y, z)] = end.at(x, y + 10 - size, z);
        if (y < 100 && x > 150) slope.on[slope.index(x, y, 2)] = noise.at(x, y, 0);
      }
    const EventLog expected = scanned(other, slope, {}, much);
    const EventLog log = scanned(extractor, slope, {}, {min_for_nodes, 100});
    CHECK(log.events == expected.events);
    CHECK(has_kept_nodes(extractor));
  }
}

TEST_CASE("a side across all slices of a slab is handed over") {
  // The side is longer than the range of places, which repeat after 8,192 links.
  constexpr uint32_t size = 2100;
  BitVolume slope({size, 1, size});
  for (int64_t z = 0; z < size; ++z)
    for (int64_t x = z; x < size && x < z + 10; ++x) slope.on[slope.index(x, 0, z)] = 1;
  for (const uint32_t slices : {size - 1, size / 2, 5U}) {
    CAPTURE(slices);
    check_same_parts({slope, Border::closed, 1, size, host::CornerCode::max_slices - slices});
  }
}

TEST_CASE("fragments are handed over if the number of slices exceeds the range of a corner code") {
  const BitVolume column = box({2, 1, 33000}, {0, 0, 0}, {0, 0, 32999});
  for (const Border border : {Border::closed, Border::open}) HandingOver(column, border).check(0);
}

TEST_CASE(
    "a slab of a HostExtractor has the regions, loose fragments and counts of other extractors") {
  HostExtractor extractor;
  Extractor32 other;
  for (const BitVolume& volume : volumes_of_slabs())
    for (const Border border : {Border::closed, Border::open})
      for (const std::vector<uint32_t>& thick : thicknesses) {
        INFO("depth ", volume.depth, ", thick ", thick[0]);
        for_each_slab(volume, thick, [&](uint32_t first, uint32_t end) {
          const SlabScan scan{volume, border, first, end};
          const EventLog log = scan.by(extractor, much);
          CHECK(parts_of(log, scan) == parts_of(scan.by(other, {1000000, 1000}), scan));
          CHECK(has_kept_nodes(extractor));
          CHECK(scan.by(extractor, much, refuses_first).events == log.events);
          CHECK(scan.by(extractor, much, refuses_some).events == log.events);
        });
      }
}

TEST_CASE("a slab has the same parts for any point at which fragments are handed over") {
  const BitVolume volume = random({70, 14, 6}, 128, 4);
  HostExtractor extractor;
  Extractor32 other;
  for (const auto& slab : {std::pair{1U, 6U}, {1U, 4U}, {2U, 4U}}) {
    INFO("slab ", slab.first, " to ", slab.second);
    const SlabScan scan{volume, Border::closed, slab.first, slab.second};
    const auto expected = parts_of(scan.by(other, much), scan);
    for (uint32_t beyond = 0; beyond < 12000; beyond += 1500) {
      CAPTURE(beyond);
      CHECK(parts_of(scan.by(extractor, {min_for_nodes + beyond, 1000}), scan) == expected);
    }
  }
}

TEST_CASE("a slab has the same parts if the number of slices exceeds the range of a corner code") {
  for (const BitVolume& volume : {random({20, 7, 12}, 128, 1), rough_columns({20, 7, 12})})
    for (const Border border : {Border::closed, Border::open})
      for (const uint32_t end : {11U, 12U})
        for (const uint32_t beyond : {0U, 4U, 10U}) {
          INFO("end ", end, ", beyond ", beyond);
          check_same_parts({volume, border, 1, end, host::CornerCode::max_slices - beyond});
        }
}

TEST_CASE("a slab that ends at the maximal slice number has the same parts") {
  const BitVolume volume = random({20, 7, 12}, 128, 1);
  for (const Border border : {Border::closed, Border::open})
    check_same_parts({volume, border, 1, 12, Limits::max_slices - 12});
}

TEST_CASE("a slab has the same parts if its seam has the maximal number of passes") {
  const BitVolume volume = checkerboard({130, 5, 4});
  check_same_parts({volume, Border::closed, 1, 3});
}

TEST_CASE("fragments of the last slab are sent in the order of their completion") {
  const auto fragments_of = [](const EventLog& log) {
    Events events;
    bool is_fragment = false;
    for (const RecordedEvent& event : log.events) {
      is_fragment = is_fragment || event.is(Event::Kind::fragment);
      if (is_fragment) events.push_back(event);
      if (event.is(Event::Kind::fragment_end)) is_fragment = false;
    }
    return events;
  };
  // Slits across the slab. Every second one has long sides, which take long walks.
  BitVolume slits({120, 2, 60});
  for (size_t i = 0; i < slits.on.size(); ++i) {
    const size_t x = i % 120, z = i / 240;
    slits.on[i] = (x + (x % 20 < 10 ? z % 2 : 0)) % 5 < 3 || z >= 57 ? 1 : 0;
  }
  // Nested tents with ragged rims. The inner ones are complete first.
  const BitVolume tents = volume_of({120, 4, 60}, [](uint32_t x, uint32_t y, uint32_t z) {
    return shapes::Tents{}(x, y, z) && (x < 60 ? 60 - x : x - 60) + z < 58;
  });
  std::vector<BitVolume> volumes{random({60, 40, 8}, 60, 2), slits, tents};
  for (uint32_t seed = 0; seed < 50; ++seed)
    volumes.push_back(random({3 + seed % 3, 2 + seed % 2, 6}, 90, seed));
  HostExtractor extractor;
  Extractor32 other;
  for (const BitVolume& volume : volumes) {
    const SlabScan scan{volume, Border::closed, 1, volume.depth};
    CHECK(fragments_of(scan.by(extractor, much)) == fragments_of(scan.by(other, much)));
  }
}

TEST_CASE("holes of each slab are sent before the last fragment of the ring around the hole") {
  const BitVolume plate = slanting_plate_with_holes();
  const std::vector<Region> regions = collected(expected_of(plate, {}).events).regions();
  HostExtractor extractor;
  for (const uint32_t thick : {3U, 5U, 8U, 11U, 16U}) {
    CAPTURE(thick);
    Events events;
    for_each_slab(plate, {thick}, [&](uint32_t first, uint32_t end) {
      const EventLog log = SlabScan{plate, Border::closed, first, end}.by(extractor, much);
      std::copy_if(log.events.begin(), log.events.end(), std::back_inserter(events), is_piece);
    });
    const Joined joined = join_all(events, {InputOrder::sweep, enough_for(events)});
    CHECK(joined.report.unmatched == 0);
    CHECK(regions_among(joined.events) == canonical(regions));
  }
}

TEST_CASE("slabs join to the whole surface for any handover and any mixture of extractors") {
  // With these numbers of slots, fragments are handed over in the slice below, in the first slice,
  // in a later slice, or never.
  constexpr uint32_t slots[] = {200, min_for_nodes, min_for_nodes + 2000, min_for_nodes + 10000,
                                min_for_nodes + 30000};
  HostExtractor extractor;
  Extractor32 other;
  uint32_t turn = 0;
  for (const BitVolume& volume :
       {random({40, 30, 4}, 128, 5), random({60, 40, 4}, 25, 6), rough_columns({32, 20, 6})})
    for (const Border border : {Border::closed, Border::open}) {
      const Plan plan{border};
      const EventLog whole = expected_of(volume, plan);
      const std::vector<Region> regions = collected(whole.events).regions();
      const std::vector<Region> expected = canonical(regions);
      for (size_t i = 0; i < std::size(slots); i += step(2)) {
        const uint32_t capacity = slots[i];
        for (const std::vector<uint32_t>& thick : {thicknesses[0], thicknesses[4]}) {
          INFO("capacity ", capacity, ", thick ", thick[0]);
          std::vector<Collector> slabs;
          Events events;
          for_each_slab(volume, thick, [&](uint32_t first, uint32_t end) {
            const SlabScan scan{volume, border, first, end};
            const EventLog::Refuses refuses = ++turn % 2 == 0 ? refuses_first : nullptr;
            const EventLog log = turn % 5 == 0 ? scan.by(other, {capacity, 100}, refuses)
                                               : scan.by(extractor, {capacity, 100}, refuses);
            slabs.push_back(collected(log.events, scan.limits().slab));
            std::copy_if(log.events.begin(), log.events.end(), std::back_inserter(events),
                         is_piece);
          });
          CHECK(unlike_joined(slabs, regions) == "");
          const Joined joined = join_all(events, {InputOrder::any, enough_for(events)});
          CHECK(joined.report.unmatched == 0);
          CHECK(regions_among(joined.events) == expected);
        }
      }
    }
}

TEST_CASE("a slab has the same parts if the chains at a seam exceed the initial queues") {
  const BitVolume volume = columns({60, 60, 3});
  for (const uint32_t end : {2U, 3U})
    check_same_parts({volume, Border::closed, 1, end}, {300000, 100});
}

TEST_CASE("a slab has the same parts if edges have several chains across a seam") {
  const BitVolume grating = volume_of({60, 60, 3}, shapes::Bars{});
  check_same_parts({grating, Border::closed, 1, 2}, {3000000, 100});
}

TEST_CASE("memory for corners of sent loose fragments is reused") {
  HostExtractor extractor;
  const auto slots_used = [&](bool has_fragments) {
    BitVolume volume({30, 30, 9});
    const BitVolume noise = random({30, 30, 2}, 128, 8);
    const auto put_noise = [&](uint32_t z) {
      std::copy(noise.on.begin(), noise.on.end(), &volume.on[volume.index(0, 0, z)]);
    };
    if (has_fragments) put_noise(0);
    put_noise(5);
    (void)SlabScan{volume, Border::closed, 1, 9}.by(extractor, much);
    return extractor.peaks().slots;
  };
  // Equal except for the runs of one fragment.
  CHECK(slots_used(true) < slots_used(false) + 1000);
}

TEST_CASE("slabs whose slices exceed the range of a corner code join to the whole surface") {
  constexpr uint32_t depth = 32790;
  BitVolume column({4, 3, depth});
  const BitVolume noise = random({4, 3, 60}, 90, 7);
  std::copy(noise.on.begin(), noise.on.end(), &column.on[column.index(0, 0, depth - 60)]);
  const std::vector<Region> regions = collected(expected_of(column).events).regions();
  HostExtractor extractor;
  for (uint32_t cut = 32755; cut < 32775; ++cut) {
    CAPTURE(cut);
    std::vector<Collector> slabs;
    for_each_slab(column, {cut, 2, depth}, [&](uint32_t first, uint32_t end) {
      const SlabScan scan{column, Border::closed, first, end};
      slabs.push_back(collected(scan.by(extractor, much).events, scan.limits().slab));
    });
    CHECK(unlike_joined(slabs, regions) == "");
  }
}

TEST_CASE("a slab without slices of its own has no surface, even with corners in the slice below") {
  const BitVolume noise = random({9, 9, 9}, 128, 5);
  HostExtractor extractor;
  for (const bool continues_above : {false, true}) {
    Limits limits = limits_of(noise, Border::closed);
    limits.slab = {7, true, continues_above};
    const Started started(extractor, limits);
    require_ok(extractor.push(noise.on.data(), continues_above ? 162 : 81).status);
    finish_all(extractor);
    CHECK(extractor.statistics().cells == 0);
    CHECK(extractor.statistics().links == 0);
  }
}

TEST_CASE("a slab abandoned at any sample has the same parts, even if the sink is busy") {
  const BitVolume volume = random({7, 6, 7}, 128, 4);
  const auto abandoned = [](auto& extractor, const SlabScan& scan, uint32_t samples,
                            const EventLog::Refuses& refuses) {
    const Started started(extractor, scan.limits(), refuses);
    uint32_t pushed = 0;
    const std::vector<uint8_t> voxels = voxels_of_slab(scan.volume, scan.first, scan.end);
    while (pushed < samples)
      pushed += extractor.push(voxels.data() + pushed, samples - pushed).samples;
    while (extractor.abandon() == Status::suspended) continue;
    return started.log;
  };
  HostExtractor extractor;
  Extractor32 other;
  for (const Border border : {Border::closed, Border::open})
    for (uint32_t samples = 0; samples <= 6 * 42; samples += 5) {
      const SlabScan scan{volume, border, 2, 6};
      const auto expected = parts_of(abandoned(other, scan, samples, {}), scan);
      CAPTURE(samples);
      CHECK(parts_of(abandoned(extractor, scan, samples, {}), scan) == expected);
      CHECK(parts_of(abandoned(extractor, scan, samples, refuses_first), scan) == expected);
    }
}

TEST_CASE("a slab continues from a checkpoint in any slice, including the context slices") {
  const BitVolume volume = random({20, 20, 7}, 100, 3);
  const SlabScan scan{volume, Border::closed, 1, 6};
  HostExtractor extractor;
  const EventLog expected = scan.by(extractor, much);
  const std::vector<uint8_t> voxels = voxels_of_slab(volume, 1, 6);
  for (uint32_t cut = 0; cut <= voxels.size(); cut += 130) {
    Started started(extractor, scan.limits());
    require_ok(extractor.push(voxels.data(), cut).status);
    HostExtractor after;
    require_ok(test::move_scan(extractor, after, started.block.memory(), make_sink(started.log)));
    require_ok(after.push(voxels.data() + cut, static_cast<uint32_t>(voxels.size()) - cut).status);
    finish_all(after);
    CHECK(started.log.events == expected.events);
  }
}

TEST_CASE("a scan is independent of a previous scan that stopped at a busy sink") {
  const BitVolume volume = random({70, 9, 5}, 100, 4);
  for (const Border border : {Border::closed, Border::open}) {
    const Plan plan{border};
    const EventLog expected = expected_of(volume, plan);
    for (const uint64_t last : {0U, 300U, 2000U}) {
      CAPTURE(last);
      bool is_first_scan = true;
      HostExtractor extractor;
      const Limits limits = limits_of(volume, border);
      Started started(extractor, limits,
                      [&](uint64_t offer) { return is_first_scan && offer >= last; });
      const auto samples = static_cast<uint32_t>(volume.voxels());
      CHECK(extractor.push(volume.on.data(), samples).status == Status::suspended);
      is_first_scan = false;
      for (int scan = 0; scan < 2; ++scan) {
        EventLog next;
        require_ok(extractor.start(limits, much, 1, started.block.memory(), make_sink(next)));
        push_all(extractor, volume.on);
        finish_all(extractor);
        CHECK(next.events == expected.events);
      }
    }
  }
}

TEST_CASE("a slab is independent of a previous slab that stopped above its last slice") {
  const BitVolume volume = random({20, 20, 9}, 100, 3);
  const SlabScan scan{volume, Border::closed, 2, 5};
  HostExtractor extractor;
  const EventLog expected = scan.by(extractor, much);
  for (const uint64_t left : {2U, 100U, 400U}) {
    const Started started(extractor, scan.limits(),
                          [&](uint64_t offer) { return offer >= expected.events.size() - left; });
    const std::vector<uint8_t> voxels = voxels_of_slab(volume, 2, 5);
    require_ok(extractor.push(voxels.data(), static_cast<uint32_t>(voxels.size())).status);
    CHECK(extractor.finish() == Status::suspended);
    CHECK(scan.by(extractor, much).events == expected.events);
  }
}

TEST_CASE("a scan restored from a checkpoint of a HostExtractor sends the same events") {
  const BitVolume volume = random({30, 30, 8}, 100, 4);
  const Limits limits = limits_of(volume, Border::closed);
  const auto slice = static_cast<uint32_t>(volume.width) * volume.height;
  const EventLog expected = expected_of(volume);
  for (const uint32_t cut : {slice, 4 * slice + 7 * volume.width, 7 * slice}) {
    HostExtractor before{};
    Started started(before, limits);
    Block elsewhere(started.block.memory().bytes);
    require_ok(before.push(volume.on.data(), cut).status);
    HostExtractor after;
    require_ok(test::move_scan(before, after, elsewhere.memory(), make_sink(started.log)));
    require_ok(after.push(volume.on.data() + cut, 8 * slice - cut).status);
    finish_all(after);
    CHECK(started.log.events == expected.events);
  }
}

// ---- the minimum capacities ----

TEST_CASE("a host extractor with minimum capacities sends the events of other extractors") {
  MinimumHost extractor;
  std::vector<BitVolume> all = volumes();
  all.push_back(volume_of({40, 30, 4}, shapes::Bars{2, 1, 1, 3}));
  all.push_back(zigzag_columns({40, 40, 12}));
  all.push_back(columns({60, 60, 3}));
  all.push_back(jagged_comb(40, 40));
  all.push_back(upright(jagged_comb(40, 40)));
  for (const BitVolume& volume : all)
    for (const Border border : {Border::closed, Border::open}) {
      const Plan plan{border, 0};
      constexpr Capacities plenty{600000, 1000};
      CHECK(scanned(extractor, volume, plan, plenty).events == expected_of(volume, plan).events);
      CHECK(extractor.peaks().slots >= MinimumHost::min_slots / 8);
    }
}

TEST_CASE(
    "a HostExtractor with minimum capacities has the same parts of structured volumes in slabs") {
  MinimumHost extractor;
  Extractor32 other;
  std::vector<BitVolume> all = volumes_of_slabs();
  all.push_back(volume_of({60, 60, 3}, shapes::Bars{}));
  all.push_back(volume_of({61, 31, 5}, shapes::Bars{2, 1, 1, 4}));
  all.push_back(columns({60, 60, 3}));
  all.push_back(zigzag_columns({40, 40, 6}));
  all.push_back(upright(jagged_comb(12, 40)));
  all.push_back(checkerboard({93, 5, 4}));
  for (const BitVolume& volume : all)
    for (const Border border : {Border::closed, Border::open})
      for (const std::vector<uint32_t>& thick : {thicknesses[0], thicknesses[4]}) {
        INFO("width ", volume.width, ", depth ", volume.depth);
        for_each_slab(volume, thick, [&](uint32_t first, uint32_t end) {
          constexpr Capacities plenty{600000, 1000};
          const SlabScan scan{volume, border, first, end};
          const auto expected = parts_of(scan.by(other, plenty), scan);
          CHECK(parts_of(scan.by(extractor, plenty), scan) == expected);
          CHECK(extractor.peaks().slots >= MinimumHost::min_slots / 8);
        });
      }
}

TEST_CASE("a host extractor has the same parts for any size of its queues") {
  Extractor32 other;
  for (const uint32_t size : {20U, 40U, 60U}) {
    const BitVolume volume = volume_of({size, size, 3}, shapes::Bars{});
    const SlabScan scan{volume, Border::closed, 1, 2};
    constexpr Capacities plenty{1000000, 1000};
    const auto expected = parts_of(scan.by(other, plenty), scan);
    for (uint32_t more = 0; more < 600; more += 16) {
      INFO("size ", size, ", more ", more);
      MinimumHost extractor(more);
      CHECK(parts_of(scan.by(extractor, plenty), scan) == expected);
    }
  }
}

TEST_CASE("a HostExtractor with minimum capacities can hand over fragments at any point") {
  MinimumHost extractor;
  Extractor32 other;
  const BitVolume noise = random({150, 60, 4}, 60, 8);
  const EventLog expected = expected_of(noise);
  const SlabScan slab{noise, Border::closed, 1, 3};
  const auto parts = parts_of(slab.by(other, {1000000, 1000}), slab);
  for (uint32_t beyond = 0; beyond < 40000; beyond += 2000 * step(4)) {
    CAPTURE(beyond);
    const Capacities capacities{MinimumHost::min_slots + beyond, 1000};
    CHECK(scanned(extractor, noise, {}, capacities, refuses_some).events == expected.events);
    CHECK(parts_of(slab.by(extractor, capacities), slab) == parts);
  }
}
