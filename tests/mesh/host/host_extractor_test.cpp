// A host extractor sends the same events as other extractors.
#include "host/host_extractor.hpp"

#include <iterator>
#include <type_traits>

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

// With these, other extractors send no fragment early. A HostExtractor ignores capacities.
constexpr Capacities much{1000000, 1000};

// A plate with holes of many shapes: rings of many runs, and rings that touch themselves.
BitVolume plate(uint32_t width, uint32_t height) {
  const Size size{width, height, 3};
  const BitVolume noise = random(size, 190, 6);
  return volume_of(size, [&](uint32_t x, uint32_t y, uint32_t z) {
    const bool is_rim = x == 0 || y == 0 || x + 1 == width || y + 1 == height;
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
          plate(60, 50)};
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
  EventLog by(Extractor& extractor, const EventLog::Refuses& refuses = {}) const {
    constexpr bool is_host = std::is_base_of_v<HostExtractor, Extractor>;
    const Capacities capacities = is_host ? minimum_capacities() : much;
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
EventLog scanned(Extractor& extractor, const BitVolume& volume, const Plan& plan = {},
                 const EventLog::Refuses& refuses = {}) {
  return SlabScan{volume, plan.border, 0, volume.depth}.by(extractor, refuses);
}

// Returns the events of another extractor.
EventLog expected_of(const BitVolume& volume, const Plan& plan = {}) {
  Extractor32 extractor;
  return scanned(extractor, volume, plan);
}

void check_like_others(const EventLog::Refuses& refuses = {}) {
  HostExtractor extractor;
  for (const Border border : {Border::closed, Border::open})
    for (const BitVolume& volume : volumes()) {
      const Plan plan{border};
      CHECK(scanned(extractor, volume, plan, refuses).events == expected_of(volume, plan).events);
    }
}

bool refuses_some(uint64_t offer) {
  return offer * 0x9E3779B97F4A7C15 >> 62 == 0;
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

void check_same_parts(const SlabScan& scan) {
  HostExtractor extractor;
  Extractor32 other;
  CHECK(parts_of(scan.by(extractor), scan) == parts_of(scan.by(other), scan));
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

// At an open border only one chain uses a link; elsewhere another chain uses it in the other
// direction.
TEST_CASE("queues have room if more chains leave than enter along a link") {
  constexpr uint32_t teeth = 3000;
  const BitVolume saw = volume_of({4, 8 * teeth, 4}, shapes::Saw{});
  const Plan plan{Border::open, 0};
  HostExtractor extractor;
  CHECK(scanned(extractor, saw, plan).events == expected_of(saw, plan).events);
}

TEST_CASE("rings of any length are closed, even after many unsuccessful walks") {
  HostExtractor extractor;
  Extractor32 other;
  const auto check = [&](const BitVolume& volume) {
    CHECK(scanned(extractor, volume).events == scanned(other, volume).events);
  };
  for (const uint32_t teeth : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 12U, 40U}) {
    CAPTURE(teeth);
    check(jagged_comb(teeth, 40));
    check(upright(jagged_comb(teeth, 40)));
  }
  // A ring of 128 corners, a quarter of what a short walk may find.
  check(jagged_comb(3, 26));
}

TEST_CASE("rings are found even if nodes are copied after long unsuccessful walks") {
  BitVolume plate({200, 200, 3});
  const BitVolume noise = random({200, 200, 2}, 190, 7);
  std::copy(noise.on.begin(), noise.on.end(), plate.on.begin());
  HostExtractor extractor;
  CHECK(scanned(extractor, plate).events == expected_of(plate).events);
}

TEST_CASE("a host extractor sends the same events even if the sink is sometimes busy") {
  check_like_others(refuses_first);
  check_like_others(refuses_some);
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
    const EventLog log = scanned(extractor, plates, {}, refuses);
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
    const EventLog expected = expected_of(volume);
    CHECK(started.log.events == expected.events);
    const uint32_t offered = receiver.offered;
    CHECK(offered > 0);
    // start() forgets the receiver.
    CHECK(scanned(extractor, volume).events == expected.events);
    CHECK(receiver.offered == offered);
  }
}

TEST_CASE("a side across all rows of a slice has the right length") {
  // Firmware divides the side, whose places repeat after 8,192.
  constexpr uint32_t size = 2000;
  BitVolume slope({size, size, 1});
  for (int64_t y = 0; y < size; ++y)
    for (int64_t x = y; x < size && x < y + 10; ++x) slope.on[slope.index(x, y, 0)] = 1;
  HostExtractor extractor;
  CHECK(scanned(extractor, slope).events == expected_of(slope).events);
}

TEST_CASE("a long side that turns upwards at a centroid has the right length") {
  // Firmware divides the side, whose places repeat after 8,192. Noise follows while the end of the
  // side waits for the slice in which it turns.
  constexpr uint32_t size = 850;
  HostExtractor extractor;
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
    CHECK(scanned(extractor, slope).events == expected_of(slope).events);
  }
}

TEST_CASE("a side across all slices of a slab has the right length") {
  // Firmware divides the side, whose places repeat after 8,192.
  constexpr uint32_t size = 2100;
  BitVolume slope({size, 1, size});
  for (int64_t z = 0; z < size; ++z)
    for (int64_t x = z; x < size && x < z + 10; ++x) slope.on[slope.index(x, 0, z)] = 1;
  check_same_parts({slope, Border::closed, 1, size});
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
          const EventLog log = scan.by(extractor);
          CHECK(parts_of(log, scan) == parts_of(scan.by(other), scan));
          CHECK(scan.by(extractor, refuses_first).events == log.events);
          CHECK(scan.by(extractor, refuses_some).events == log.events);
        });
      }
}

TEST_CASE("a HostExtractor refuses slices after 32,760, and sends the surface of those before") {
  constexpr uint32_t most = host::CornerCode::max_slices;
  const std::vector<uint8_t> voxels(most + 2, 1);
  for (const bool continues_below : {false, true}) {
    Limits limits{1, 1};
    limits.slab = {continues_below ? 5U : 0U, continues_below, false};
    HostExtractor extractor;
    const Started started(extractor, limits);
    const PushResult pushed = extractor.push(voxels.data(), most + 2);
    CHECK(pushed.status == Status::too_many_slices);
    CHECK(pushed.samples == most);
    finish_all(extractor);
    Extractor32 other;
    const Started expected(other, limits);
    require_ok(other.push(voxels.data(), most).status);
    finish_all(other);
    CHECK(sorted_parts(started.log.events) == sorted_parts(expected.log.events));
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
    CHECK(fragments_of(scan.by(extractor)) == fragments_of(scan.by(other)));
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
      const EventLog log = SlabScan{plate, Border::closed, first, end}.by(extractor);
      std::copy_if(log.events.begin(), log.events.end(), std::back_inserter(events), is_piece);
    });
    const Joined joined = join_all(events, {InputOrder::sweep, enough_for(events)});
    CHECK(joined.report.unmatched == 0);
    CHECK(regions_among(joined.events) == canonical(regions));
  }
}

TEST_CASE("slabs join to the whole surface for any mixture of extractors") {
  HostExtractor extractor;
  Extractor32 other;
  uint32_t turn = 0;
  for (const BitVolume& volume :
       {random({40, 30, 4}, 128, 5), random({60, 40, 4}, 25, 6), rough_columns({32, 20, 6})})
    for (const Border border : {Border::closed, Border::open}) {
      const std::vector<Region> regions =
          collected(expected_of(volume, Plan{border}).events).regions();
      for (const std::vector<uint32_t>& thick : {thicknesses[0], thicknesses[4]}) {
        INFO("thick ", thick[0]);
        std::vector<Collector> slabs;
        Events events;
        for_each_slab(volume, thick, [&](uint32_t first, uint32_t end) {
          const SlabScan scan{volume, border, first, end};
          const EventLog::Refuses refuses = ++turn % 2 == 0 ? refuses_first : nullptr;
          const EventLog log =
              turn % 3 == 0 ? scan.by(other, refuses) : scan.by(extractor, refuses);
          slabs.push_back(collected(log.events, scan.limits().slab));
          std::copy_if(log.events.begin(), log.events.end(), std::back_inserter(events), is_piece);
        });
        CHECK(unlike_joined(slabs, regions) == "");
        const Joined joined = join_all(events, {InputOrder::any, enough_for(events)});
        CHECK(joined.report.unmatched == 0);
        CHECK(regions_among(joined.events) == canonical(regions));
      }
    }
}

TEST_CASE("a slab has the same parts if the chains at a seam exceed the initial queues") {
  const BitVolume volume = columns({60, 60, 3});
  for (const uint32_t end : {2U, 3U}) check_same_parts({volume, Border::closed, 1, end});
}

TEST_CASE("a slab has the same parts if edges have several chains across a seam") {
  const BitVolume grating = volume_of({60, 60, 3}, shapes::Bars{});
  check_same_parts({grating, Border::closed, 1, 2});
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
  const EventLog expected = scan.by(extractor);
  for (const uint64_t left : {2U, 100U, 400U}) {
    const Started started(extractor, scan.limits(),
                          [&](uint64_t offer) { return offer >= expected.events.size() - left; });
    const std::vector<uint8_t> voxels = voxels_of_slab(volume, 2, 5);
    require_ok(extractor.push(voxels.data(), static_cast<uint32_t>(voxels.size())).status);
    CHECK(extractor.finish() == Status::suspended);
    CHECK(scan.by(extractor).events == expected.events);
  }
}

TEST_CASE("a scan is independent of a previous slab that stopped at any row") {
  const BitVolume volume = random({20, 9, 9}, 100, 3);
  const SlabScan slab{volume, Border::closed, 2, 5, 100};
  const std::vector<uint8_t> voxels = voxels_of_slab(volume, 2, 5);
  const EventLog expected = expected_of(volume);
  for (uint32_t samples = 20; samples < voxels.size(); samples += 20) {
    CAPTURE(samples);
    HostExtractor extractor;
    const Started stopped(extractor, slab.limits());
    require_ok(extractor.push(voxels.data(), samples).status);
    CHECK(scanned(extractor, volume).events == expected.events);
  }
}

TEST_CASE("a slab sends the same events if its sink refuses any one of the last") {
  const BitVolume volume = upright(plate(20, 20));
  const SlabScan scan{volume, Border::closed, 5, 15};
  HostExtractor extractor;
  const EventLog expected = scan.by(extractor);
  for (uint64_t left = 1; left < 300; ++left) {
    CAPTURE(left);
    const uint64_t refused = expected.events.size() - left;
    CHECK(scan.by(extractor, [&](uint64_t offer) { return offer == refused; }).events ==
          expected.events);
  }
}

// ---- holes ----

// The corner of a cube, cut off by a slope, with a pit in the slope near each of its ends. Bits of
// `mirrored`: the axes that run backwards.
BitVolume slope_with_pits(uint32_t mirrored) {
  constexpr uint32_t size = 24;
  return volume_of({size, size, size}, [&](uint32_t x, uint32_t y, uint32_t z) {
    if (mirrored & 1) x = size - 1 - x;
    if (mirrored & 2) y = size - 1 - y;
    if (mirrored & 4) z = size - 1 - z;
    const bool is_pit = std::min({x, y, z}) == 3 && std::max({x, y, z}) == 13;
    return x + y + z < 20 && !is_pit;
  });
}

TEST_CASE("a hole waits for the ring around it near any of its corners") {
  HostExtractor extractor;
  for (uint32_t mirrored = 0; mirrored < 8; ++mirrored) {
    const BitVolume volume = slope_with_pits(mirrored);
    CAPTURE(mirrored);
    CHECK(scanned(extractor, volume).events == expected_of(volume).events);
  }
}

// ---- growing memory ----

TEST_CASE("a host extractor sends the same events if all of its memory grows") {
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
      CHECK(scanned(extractor, volume, plan).events == expected_of(volume, plan).events);
    }
}

TEST_CASE("a slab of a structured volume has the parts of other extractors if all memory grows") {
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
          const SlabScan scan{volume, border, first, end};
          CHECK(parts_of(scan.by(extractor), scan) == parts_of(scan.by(other), scan));
        });
      }
}

TEST_CASE("a host extractor sends the same events for any initial number of slots") {
  const BitVolume volume = plate(20, 20);
  const EventLog expected = expected_of(volume);
  for (uint32_t slots = 1; slots < 300; ++slots) {
    CAPTURE(slots);
    MinimumHost extractor(0, slots);
    CHECK(scanned(extractor, volume).events == expected.events);
  }
}

TEST_CASE("a host extractor has the same parts for any size of its queues") {
  Extractor32 other;
  for (const uint32_t size : {20U, 40U, 60U}) {
    const BitVolume volume = volume_of({size, size, 3}, shapes::Bars{});
    const SlabScan scan{volume, Border::closed, 1, 2};
    const auto expected = parts_of(scan.by(other), scan);
    for (uint32_t more = 0; more < 600; more += 16) {
      INFO("size ", size, ", more ", more);
      MinimumHost extractor(more);
      CHECK(parts_of(scan.by(extractor), scan) == expected);
    }
  }
}
