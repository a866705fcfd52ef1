// Holes are assigned to the ring around them, in planes of every direction. Holes without such a
// ring are sent loose.
#include <discmc/trace/delivery.hpp>
#include <discmc/trace/holes.hpp>

#include "oracle/agreement.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// The voxels on one side of a plane, except for some. The plane has rings and holes of many shapes,
// nested rings, and adjacent rings.
BitVolume half_space(Size size, const Vertex& n, uint32_t noise, uint64_t seed) {
  BitVolume volume = random(size, noise, seed);
  const auto middle = [](uint32_t extent) { return static_cast<int32_t>(extent / 2); };
  for (size_t i = 0; i < volume.voxels(); ++i) {
    const auto at = static_cast<uint32_t>(i);
    const auto x = static_cast<int32_t>(at % size.width) - middle(size.width);
    const auto y = static_cast<int32_t>(at / size.width % size.height) - middle(size.height);
    const auto z = static_cast<int32_t>(at / size.width / size.height) - middle(size.depth);
    if (n.x * x + n.y * y + n.z * z > 0) volume.on[i] ^= 1;
  }
  return volume;
}

// Returns how the regions differ between holes in lists, holes in a tree and the reference; empty
// if they agree.
std::string difference_of_indexes(const BitVolume& volume) {
  const Collector lists = scan<uint16_t>(volume), tree = scan<uint32_t>(volume);
  if (lists.regions() != tree.regions()) return "the tree's regions differ from those of the lists";
  return unlike_merge(lists.regions(), volume, true);
}

}  // namespace

TEST_CASE("a hole is assigned to the ring around it in planes of every direction") {
  uint64_t holes = 0;
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    if (incidence == no_incidence) continue;
    for (const uint32_t noise : {10U, 40U}) {
      const BitVolume volume =
          half_space({11, 11, 11}, incidence_normal(incidence), noise, incidence);
      const Collector swept = scan<uint16_t>(volume);
      CAPTURE(incidence);
      CHECK(difference_of_indexes(volume) == "");
      holes += swept.statistics().rings - swept.statistics().regions;
    }
  }
  CHECK(holes > 200);
}

TEST_CASE(
    "a hole is assigned to the ring around the hole, not to a nearby ring with an oblique side") {
  struct Known {
    Size size;
    Incidence incidence;
    uint32_t noise;
    uint64_t seed;
  };
  for (const Known& known : {Known{{10, 3, 11}, 0, 11, 6542}, Known{{6, 7, 7}, 0, 43, 7691},
                             Known{{8, 3, 10}, 1, 9, 5385}, Known{{9, 4, 10}, 1, 21, 8506},
                             Known{{8, 4, 7}, 6, 22, 7486}, Known{{9, 7, 7}, 6, 39, 3648}}) {
    const BitVolume volume =
        half_space(known.size, incidence_normal(known.incidence), known.noise, known.seed);
    CAPTURE(known.seed);
    CHECK(difference_of_indexes(volume) == "");
  }
}

TEST_CASE("a hole is assigned to its own ring, although a corner of another ring is on its line") {
  // A face behind the picture has an island in a hole. Another hole waits to the right of the
  // corner where two oblique sides of the island meet.
  const char* const picture[] = {
      "......#..###..", "....#########.", "..####.##...##", ".###..........", "##.........#..",
      ".##.......###.", "..##..#..#####", "...##.##.#####", "....###...###.", ".....#.....#.."};
  BitVolume volume({14, 2, 10});
  for (int64_t z = 0; z < 10; ++z)
    for (int64_t x = 0; x < 14; ++x) volume.on[volume.index(x, 1, z)] = picture[z][x] == '#';
  for (const auto& [x, z] : {std::pair{6, 6}, {11, 6}, {11, 7}})
    volume.on[volume.index(x, 0, z)] = 1;
  CHECK(difference_of_indexes(volume) == "");
}

TEST_CASE("a hole is assigned to its own ring, even if the hole's slot is reused") {
  // Noise, followed by pairs of adjacent plates. One plate closes while the hole of the other
  // waits.
  const BitVolume noise = random({40, 36, 2}, 128, 8);
  BitVolume volume({40, 36, 5});
  std::copy(noise.on.begin(), noise.on.end(), volume.on.begin());
  for (int64_t y = 0; y < 36; ++y)
    for (int64_t x = 0; x < 40; ++x) {
      const int64_t column = x % 8, row = y % 9;
      const bool is_hole =
          (row == 2 && (column == 2 || column == 4)) || (row == 3 && column >= 2 && column <= 4);
      volume.on[volume.index(x, y, 3)] = column < 7 && row < (x / 8 % 2 == 0 ? 6 : 8) && !is_hole;
    }
  CHECK(difference_of_indexes(volume) == "");
}

TEST_CASE_TEMPLATE(
    "a hole is found by its plane, and is sent at the end if no ring encloses the hole", Index,
    uint16_t, uint32_t) {
  using Holes = detail::trace::Holes<Index, detail::trace::NoNormal>;
  typename Holes::Slots slots;
  detail::trace::Slot<Index, detail::trace::NoNormal> memory[300];
  Index heads[16];
  slots.start(memory, 300);
  slots.clear();
  Holes holes;
  holes.start(heads);
  holes.clear();
  const Incidence incidence = 22;
  detail::trace::Outgoing<Index> ring;
  ring.kind = detail::trace::Outgoing<Index>::Kind::fragment;
  ring.incidence = incidence;
  const auto is_on = [&](int32_t z) {
    if constexpr (sizeof(Index) == 2)
      return holes.has_any(slots, incidence, {4, 1, z});
    else
      return holes.has_any(slots, incidence, {4, 1, z}, {0, 0}, {4, 2});
  };
  constexpr uint32_t slots_each_hole = Holes::slots_each + 1;  // and its run
  for (int32_t z = 0; z < 40; ++z) {
    CHECK(!is_on(z));
    ring.start = {2, 1, z};
    typename detail::trace::RunLists<Index, detail::trace::NoNormal>::Entry run;
    run.run = detail::trace::short_run(0, 1);
    ring.runs = no_slot;
    detail::trace::RunLists<Index, detail::trace::NoNormal>::append(slots, ring.runs, run);
    holes.keep(slots, ring);
    CHECK(is_on(z));
  }
  for (uint32_t left = 40; left > 0; --left) {
    CHECK(holes.count() == left);
    Vertex start{};
    ring.incidence = no_incidence;
    holes.any_plane(slots, ring.incidence, ring.start);
    CHECK(ring.incidence == incidence);
    CHECK(is_on(ring.start.z));
    CHECK(holes.mark(slots, ring) == 1);
    holes.remove(slots, ring.runs, start);
    detail::trace::RunLists<Index, detail::trace::NoNormal>::release(slots, ring.runs);
    CHECK(start == ring.start);
    CHECK(!is_on(start.z));
    CHECK(slots.in_use() == (left - 1) * slots_each_hole);
  }
}

TEST_CASE_TEMPLATE("a hole that closes with too few free slots is sent as a loose fragment", Index,
                   uint16_t, uint32_t) {
  using Fragments = detail::trace::Fragments<Index, detail::trace::NoNormal>;
  using Delivery = detail::trace::Delivery<Index, detail::trace::NoNormal, true>;
  constexpr uint32_t enough =
      minimum_capacities().slots + detail::trace::Holes<Index, detail::trace::NoNormal>::slots_each;
  for (const uint32_t spare : {enough, enough - 1}) {
    CAPTURE(spare);
    detail::trace::Slot<Index, detail::trace::NoNormal> memory[300];
    detail::trace::Queue<Index> queues[detail::trace::queue_count];
    Index heads[16];
    Fragments fragments;
    fragments.start(memory, 300, queues);
    fragments.clear();
    Delivery delivery;
    delivery.start(heads, 1);
    delivery.clear();
    Index runs = no_slot;
    for (const Direction direction :
         {Direction{0}, Direction{6}, Direction{4}, Direction{2}}) {  // a square, clockwise
      typename Fragments::Lists::Entry run;
      run.run = detail::trace::short_run(direction, 1);
      Fragments::Lists::append(fragments.slots(), runs, run);
    }
    while (fragments.spare() > spare) (void)fragments.slots().allocate();
    fragments.set_outgoing(detail::trace::Outgoing<Index>::Kind::ring, 22, runs, {4, 4, 1});
    EventLog log;
    Statistics statistics{};
    CHECK(delivery.deliver(fragments, make_sink(log), statistics));
    CHECK(delivery.holes().count() == (spare == enough ? 1 : 0));
    CHECK(statistics.fragments == (spare == enough ? 0 : 1));
    CHECK(log.events.size() == (spare == enough ? 0 : 6));  // the fragment, four runs, its end
  }
}

TEST_CASE("a hole stores its incidence, its first direction and a note") {
  detail::trace::Hole<uint32_t> hole{};
  // Twice eight half-steps along a row of the widest volume, and half an eighth.
  constexpr int32_t last = 16 * 65531 + 1;
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    for (Direction first = 0; first < max_directions; ++first)
      for (const int32_t crossing : {-17, 0, 1, last}) {
        hole.set(incidence, first);
        CHECK_FALSE(hole.is_noted());
        for (const bool leads_inside : {false, true}) {
          hole.set_note(crossing, leads_inside);
          CHECK(hole.is_noted());
          CHECK(hole.leads_inside() == leads_inside);
          CHECK(hole.crossing() == crossing);
        }
        hole.clear_note();
        CHECK_FALSE(hole.is_noted());
        CHECK(hole.incidence() == incidence);
        CHECK(hole.first() == first);
      }
}

TEST_CASE("each of many holes on a plane is assigned to its own ring") {
  // A plate with holes, islands in the holes, and holes in the islands. Slots cross it at an angle,
  // with thin islands in them. Two of its sides have teeth.
  BitVolume plate({61, 47, 3});
  for (int64_t y = 1; y < 46; ++y)
    for (int64_t x = 1; x < 60; ++x) {
      const int64_t to_edge = std::min({x % 10, 9 - x % 10, y % 10, 9 - y % 10});
      const bool is_on = to_edge == 0 || to_edge == 2 || (to_edge == 3 && x % 20 < 10);
      const bool is_tooth = y > 40 || x > 54;
      const bool is_slot = y > 24 && (x + y) % 23 < 4;
      plate.on[plate.index(x, y, 1)] = is_tooth  ? (x + y) % 4 < 2
                                       : is_slot ? (x + y) % 23 == 2 && y % 11 > 1
                                                 : is_on;
    }
  CHECK(difference_of_indexes(plate) == "");
  const Statistics counts = scan<uint32_t>(plate).statistics();
  CHECK(counts.rings - counts.regions > 30);
  BitVolume upright({3, 47, 61});  // the same on a plane along z
  for (int64_t z = 0; z < 61; ++z)
    for (int64_t y = 0; y < 47; ++y)
      upright.on[upright.index(1, y, z)] = plate.on[plate.index(z, y, 1)];
  CHECK(difference_of_indexes(upright) == "");
}

TEST_CASE_TEMPLATE("the peak of holes is the number waiting at once, and each scan resets the peak",
                   Index, uint16_t, uint32_t) {
  // Three holes in each of two faces of a plate.
  BitVolume plate = box({13, 7, 3}, {0, 0, 1}, {12, 6, 1});
  for (const int64_t x : {2, 6, 10}) plate.on[plate.index(x, 2, 1)] = 0;
  const Limits limits = limits_of(plate, Border::closed);
  Block block(Extractor<Index>::bytes_for(limits, ample));
  EventLog log;
  Extractor<Index> extractor;
  require_ok(extractor.start(limits, ample, 1, block.memory(), make_sink(log)));
  push_all(extractor, plate.on);
  const uint32_t slots = extractor.peaks().slots;
  CHECK(extractor.peaks().holes == 3);
  // The next scan breaks off while the first three wait.
  require_ok(extractor.reset());
  const auto begun = static_cast<std::ptrdiff_t>(plate.index(0, 5, 1));
  push_all(extractor, std::vector<uint8_t>(plate.on.begin(), plate.on.begin() + begun));
  CHECK(extractor.peaks().holes == 3);
  require_ok(extractor.reset());
  CHECK(extractor.peaks().holes == 0);
  for (int plates = 0; plates < 50; ++plates) push_all(extractor, plate.on);
  BitVolume one_hole = plate;
  for (const int64_t x : {2, 6}) one_hole.on[plate.index(x, 2, 1)] = 1;
  push_all(extractor, one_hole.on);
  CHECK(extractor.peaks().holes == 3);
  CHECK(extractor.peaks().slots == slots);
}

TEST_CASE("a loose hole is sent before the last fragment of the ring around the hole") {
  BitVolume volume = random({12, 14, 2}, 36, 11999326367699514143U);
  for (uint8_t& voxel : volume.on) voxel ^= 1;
  const std::vector<Region> merged = merge(volume, true);
  uint32_t holes = 0;
  for (uint32_t slots = 200; slots < 360; slots += 13) {
    CAPTURE(slots);
    Collector collector;
    scan_into<uint16_t>(collector, volume, {}, Capacities{slots, 1000});
    CHECK(unlike_joined({collector}, merged) == "");
    const std::vector<Fragment>& loose = collector.loose();
    for (auto at = loose.begin(); at != loose.end(); ++at) {
      const Ring ring = vertices_of(at->incidence, at->start, at->runs);
      const auto runs = static_cast<uint32_t>(at->runs.size());
      if (!is_closed(at->incidence, at->runs.data(), runs)) continue;
      if (signed_area(at->incidence, ring) > 0) continue;
      ++holes;
      CHECK(std::any_of(at + 1, loose.end(), [&](const Fragment& later) {
        return later.incidence == at->incidence &&
               plane_offset(later.incidence, later.start) == plane_offset(at->incidence, at->start);
      }));
    }
  }
  CHECK(holes > 0);
}

namespace {

// Returns the events of a slab that scans `volume`. The sink refuses all events from `refused` on,
// until the end of the scan.
Events slab_events(const BitVolume& volume, const Slab& slab, const Capacities& capacities,
                   size_t refused = SIZE_MAX) {
  bool refuses = true;
  EventLog log([&](uint64_t offer) { return refuses && offer >= refused; });
  Limits limits = limits_of(volume, Border::closed);
  limits.slab = slab;
  Block block(Extractor16::bytes_for(limits, capacities));
  Extractor16 extractor;
  require_ok(extractor.start(limits, capacities, 1, block.memory(), make_sink(log)));
  push_all(extractor, volume.on);
  CHECK(extractor.finish() == (refused == SIZE_MAX ? Status::ok : Status::suspended));
  refuses = false;
  CHECK(extractor.resume() == Status::ok);
  CHECK(block.is_intact());
  return log.events;
}

}  // namespace

TEST_CASE("a hole whose ring was sent as fragments before it is sent at the end of the slab") {
  const BitVolume volume = half_space({15, 11, 4}, incidence_normal(18), 27, 1079688895);
  BitVolume upper({15, 11, 2});
  std::copy_n(&volume.on[volume.index(0, 0, 2)], upper.voxels(), upper.on.begin());
  const Slab below{0, false, true}, above{3, true, false};
  const Collector above_it = collected(slab_events(upper, above, ample), above);
  const std::vector<Region> merged = merge(volume, true);
  for (const uint32_t slots : {202U, 218U, 241U, 250U}) {
    CAPTURE(slots);
    const Capacities few{slots, 30};
    const Events events = slab_events(volume, below, few);
    const Collector below_it = collected(events, below);
    CHECK(unlike_joined({below_it, above_it}, merged) == "");
    // A whole ring, although all events before it end at the seam.
    const Fragment& last = below_it.loose().back();
    CHECK(is_closed(last.incidence, last.runs.data(), static_cast<uint32_t>(last.runs.size())));
    // Its first and last event, and the end of the scan.
    for (const size_t back : {last.runs.size() + 3, size_t{2}, size_t{1}})
      CHECK(slab_events(volume, below, few, events.size() - back) == events);
  }
}
