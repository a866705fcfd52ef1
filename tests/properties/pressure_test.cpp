// Under pressure: whatever the memory, the surface is the same, and without cuts so are the
// regions.
#include <doctest/doctest.h>

#include <iterator>

#include "oracle/agreement.hpp"
#include "oracle/sanitized.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// One volume with one border, and what must come out of it.
class Pressed {
 public:
  Pressed(BitVolume volume, Border border, bool takes_fragments)
      : volume_(std::move(volume)),
        plan_{border, takes_fragments, 0},
        closed_(border == Border::closed),
        merged_(canonical(merge(volume_, closed_))) {}

  Limits limits() const { return limits_of(volume_, plan_.border); }

  /// Enough for everything, spills and sinks that take no fragments included.
  Capacities ample() const {
    Capacities capacities = worst_case_capacities(limits());
    capacities.runs = 4 * capacities.runs + 4 * capacities.edges + 1000;
    return capacities;
  }

  /// What is wrong with a scan in this memory, or nothing. Alternates between blocks whose end
  /// address sanitizers watch and blocks between guards.
  template <class Index, class Room>
  std::string fault(const Room& room, bool may_cut) const {
    try {
      Collector collector(plan_.takes_fragments);
      const Block::Kind kind = ++scans_ % 2 == 0 ? Block::Kind::exact : Block::Kind::guarded;
      scan_into<Index>(collector, volume_, plan_, room, kind);
      return fault_of(collector, may_cut);
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  /// The high-water marks of a scan that lacks nothing.
  HighWater needed() const {
    Collector collector(plan_.takes_fragments);
    Block block(bytes_for<uint16_t>(limits(), ample()));
    Extractor16 extractor;
    require_ok(extractor.start(limits(), ample(), 1, block.memory(), collector.sink()));
    push_all(extractor, volume_.on);
    finish_all(extractor);
    return extractor.high_water();
  }

  /// What is wrong with a scan in the memory of one that was broken off by reset(), or nothing.
  std::string fault_after_reset(const Capacities& capacities, bool may_cut) const {
    Collector collector(plan_.takes_fragments);
    Collector broken_off(plan_.takes_fragments);
    Switch receiver{&broken_off};
    const Block::Kind kind = ++scans_ % 2 == 0 ? Block::Kind::exact : Block::Kind::guarded;
    Block block(bytes_for<uint16_t>(limits(), capacities), kind);
    Extractor16 extractor;
    require_ok(extractor.start(limits(), capacities, 1, block.memory(),
                               sink_to(receiver, plan_.takes_fragments)));
    const std::vector<uint8_t>& on = volume_.on;
    push_all(extractor, std::vector<uint8_t>(on.data(), on.data() + scans_ % on.size()));
    require_ok(extractor.reset());
    receiver.collector = &collector;
    push_all(extractor, on);
    finish_all(extractor);
    return block.is_intact() ? fault_of(collector, may_cut) : "a write outside the arena";
  }

  /// The same of a start that must be refused before anything happens.
  std::string fault_of_refusal(const Capacities& capacities) const {
    Collector collector(plan_.takes_fragments);
    const size_t bytes = bytes_for<uint16_t>(limits(), ample());
    Block block(bytes);
    Block untouched(bytes);
    Extractor16 extractor;
    const Status status =
        extractor.start(limits(), capacities, 1, block.memory(), collector.sink());
    if (status != Status::bad_capacities) return text(status);
    const auto* written = static_cast<const uint8_t*>(block.memory().data);
    const auto* as_it_was = static_cast<const uint8_t*>(untouched.memory().data);
    if (!std::equal(written, written + bytes, as_it_was)) return "the memory was touched";
    return extractor.finish() == Status::not_started ? "" : "something was started";
  }

 private:
  struct Switch {
    Collector* collector;
    Answer take(const Event& event) { return collector->take(event); }
  };

  std::string fault_of(const Collector& collector, bool) const {
    const std::vector<Region>& swept = collector.regions();
    if (collector.split_sides() != 0) return "a straight side in more runs than it needs";
    if (swept.size() < merged_.size()) return "fewer regions than there are";
    return unlike_surface(swept, volume_, closed_);
  }

  BitVolume volume_;
  Plan plan_;
  bool closed_;
  std::vector<Region> merged_;
  mutable uint32_t scans_ = 0;
};

std::vector<BitVolume> small_volumes() {
  std::vector<BitVolume> volumes = {checkerboard({6, 7, 5}),  columns({7, 6, 5}),
                                    tiling_61({7, 8, 6}),     tiling({6, 7, 6}, 105),
                                    tiling({7, 6, 6}, 121),   comb({9, 8, 4}),
                                    spiral({13, 13, 3}),      ball({13, 13, 13}, {12, 12, 12}, 30),
                                    random({9, 1, 9}, 170, 5)};
  for (uint32_t i = 0; i < 9; ++i)
    volumes.push_back(random({1 + i * 7 % 9, 1 + i * 5 % 8, 2 + i * 3 % 6}, 30 + i * 41 % 200, i));
  return volumes;
}

// Calls check(pressed, capture text) for every volume, border and sort of sink.
template <class Check>
void for_each_case(Check check) {
  size_t number = 0;
  for (const BitVolume& volume : small_volumes()) {
    CAPTURE(number);
    for (const Border border : {Border::closed, Border::open})
      for (const bool takes_fragments : {true, false}) {
        CAPTURE(border == Border::closed);
        CAPTURE(takes_fragments);
        check(Pressed(volume, border, takes_fragments), takes_fragments);
      }
    ++number;
  }
}

// Values from `least` to `most`: every one up to 32 above the least, then ever fewer.
template <class Check>
void for_each_room(uint64_t least, uint64_t most, Check check) {
  for (uint64_t room = least; room < most; room += step(23) * (1 + (room - least) / 32)) {
    CAPTURE(room);
    check(room);
  }
}

// Makes one pool small and leaves the others ample.
template <class Index>
void press_pool(uint32_t Capacities::*pool, bool spills_instead) {
  for_each_case([&](const Pressed& pressed, bool takes_fragments) {
    const Capacities ample = pressed.ample();
    for_each_room(minimum_capacities().*pool, ample.*pool, [&](uint64_t room) {
      Capacities capacities = ample;
      capacities.*pool = static_cast<uint32_t>(room);
      CHECK(pressed.fault<Index>(capacities, !(spills_instead && takes_fragments)) == "");
    });
  });
}

}  // namespace

TEST_CASE("a lack of edges cuts and keeps the surface") {
  press_pool<uint16_t>(&Capacities::edges, false);
}

TEST_CASE("a lack of runs cuts and keeps the surface") {
  press_pool<uint16_t>(&Capacities::runs, true);
  press_pool<uint32_t>(&Capacities::runs, true);
}

TEST_CASE("a lack of rings cuts and keeps the surface") {
  press_pool<uint16_t>(&Capacities::rings, false);
}

TEST_CASE("a lack of regions cuts and keeps the surface") {
  press_pool<uint16_t>(&Capacities::regions, false);
}

TEST_CASE("a lack of slots cuts and keeps the surface") {
  press_pool<uint16_t>(&Capacities::slots, false);
}

TEST_CASE("every capacity of every pool from nothing to what is needed is refused or does") {
  constexpr uint32_t Capacities::*pools[] = {&Capacities::edges, &Capacities::runs,
                                             &Capacities::rings, &Capacities::regions,
                                             &Capacities::slots};
  constexpr uint32_t HighWater::*marks[] = {&HighWater::edges, &HighWater::runs, &HighWater::rings,
                                            &HighWater::regions, &HighWater::slots};
  const Capacities least = minimum_capacities();
  for_each_case([&](const Pressed& pressed, bool takes_fragments) {
    const HighWater needed = pressed.needed();
    for (size_t i = 0; i < std::size(pools); ++i) {
      CAPTURE(i);
      const auto pool = pools[i];
      const bool may_cut = !(pool == &Capacities::runs && takes_fragments);
      Capacities capacities = pressed.ample();
      const uint32_t most = needed.*marks[i] + 2 * least.*pool;
      for (capacities.*pool = 0; capacities.*pool < least.*pool; ++(capacities.*pool))
        CHECK(pressed.fault_of_refusal(capacities) == "");
      for (; capacities.*pool <= most; capacities.*pool += step(19))
        CHECK(pressed.fault_after_reset(capacities, may_cut) == "");
    }
  });
}

TEST_CASE("a region whose many edges all become boundary at once finds the runs it needs") {
  // A wall with teeth of many outlines on top, each of which leaves edges that wait for the layer
  // above: without fragments all of them need runs of the pool when their time has come.
  for (const uint32_t width : {24U, 48U})
    for (uint64_t seed = 0; seed < 4; ++seed) {
      BitVolume volume = random({width, 3, 7}, 150, seed);
      for (size_t i = 0; i < size_t{2} * width * 3; ++i) volume.on[i] = 1;
      for (size_t i = 2; i < 7 * 3; ++i)
        for (size_t x = 0; seed < 2 && x < width; ++x)
          volume.on[i * width + x] = i < 6 || x % (3 + i / 6) < 2 ? 1 : 0;
      for (const Border border : {Border::closed, Border::open}) {
        const Pressed pressed(volume, border, false);
        Capacities capacities = pressed.ample();
        const uint32_t least = minimum_capacities().runs;
        for (capacities.runs = least; capacities.runs < least + 1200; capacities.runs += step(29))
          REQUIRE(pressed.fault<uint16_t>(capacities, true) == "");
      }
    }
}

TEST_CASE("any mixture of shortages keeps the surface") {
  uint32_t mixture = 0;
  for_each_case([&](const Pressed& pressed, bool) {
    const Capacities least = minimum_capacities();
    for (uint32_t i = 0; i < 100; i += step(10)) {
      mixture = mixture * 1664525 + 1013904223;
      const Capacities capacities{
          least.edges + (mixture >> 8) % 60, least.runs + (mixture >> 12) % 90,
          least.rings + (mixture >> 16) % 12, least.regions + (mixture >> 20) % 50,
          least.slots + (mixture >> 24) % 80};
      CHECK(pressed.fault<uint16_t>(capacities, true) == "");
    }
  });
}

TEST_CASE("every arena from the minimum to more than enough keeps the surface") {
  for_each_case([](const Pressed& pressed, bool) {
    const uint64_t least = minimum_bytes<uint16_t>(pressed.limits());
    for_each_room(least, least + 12000,
                  [&](uint64_t bytes) { CHECK(pressed.fault<uint16_t>(bytes, true) == ""); });
    const uint64_t wide = minimum_bytes<uint32_t>(pressed.limits());
    for (uint64_t bytes = wide; bytes < wide + 12000; bytes += 797)
      CHECK(pressed.fault<uint32_t>(bytes, true) == "");
  });
}

TEST_CASE("every single byte more than the minimum keeps the surface") {
  const Pressed pressed(random({7, 6, 5}, 120, 3), Border::closed, true);
  const uint64_t least = minimum_bytes<uint16_t>(pressed.limits());
  for (uint64_t bytes = least; bytes < least + 3000; bytes += step(17))
    CHECK(pressed.fault<uint16_t>(bytes, true) == "");
}

TEST_CASE("more memory never makes more regions of a ball, and enough makes as few as there are") {
  const BitVolume volume = ball({31, 31, 31}, {30, 30, 30}, 180);
  const Limits limits = limits_of(volume, Border::closed);
  size_t before = SIZE_MAX;
  for (const uint64_t bytes : {3000U, 4000U, 6000U, 8000U, 16000U, 64000U}) {
    Collector collector;
    scan_into<uint16_t>(collector, volume, {}, minimum_bytes<uint16_t>(limits) + bytes);
    CHECK(collector.regions().size() <= before);
    before = collector.regions().size();
  }
  CHECK(before == merge(volume, true).size());
}

TEST_CASE("a thousand layers need no more memory than the first ones: nothing leaks") {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    // A slice that is all off ends every region; else holes would gather in those that go on.
    BitVolume period = random({7, 8, 10}, 60 + 15 * static_cast<uint32_t>(seed), seed);
    std::fill_n(period.on.begin(), 7 * 8, uint8_t{0});
    BitVolume longer({7, 8, 1000});
    for (size_t i = 0; i < longer.voxels(); ++i) longer.on[i] = period.on[i % period.voxels()];
    BitVolume shorter({7, 8, 40});
    std::copy_n(longer.on.begin(), shorter.voxels(), shorter.on.begin());
    const Limits limits = limits_of(period, Border::closed);
    Capacities capacities = worst_case_capacities(limits);
    // Fewer rings and regions than the worst case asks for: as many as 40 layers use, and reserves.
    Block block(bytes_for<uint32_t>(limits, capacities));
    Collector collector;
    Extractor32 extractor;
    require_ok(extractor.start(limits, capacities, 1, block.memory(), collector.sink()));
    push_all(extractor, shorter.on);
    finish_all(extractor);
    const HighWater marks = extractor.high_water();
    capacities.rings = marks.rings + 3 * CellReserve::rings;
    capacities.regions = marks.regions + 2 * CellReserve::regions;
    capacities.runs = marks.runs + 2 * CellReserve::runs;
    Collector second;
    scan_into<uint32_t>(second, longer, {}, capacities);
  }
}

TEST_CASE("the high-water marks lie within the capacities") {
  for (const BitVolume& volume : small_volumes()) {
    const Limits limits = limits_of(volume, Border::closed);
    Block block(minimum_bytes<uint16_t>(limits) + 1500);
    Collector collector;
    Extractor16 extractor;
    require_ok(extractor.start(limits, 1, block.memory(), collector.sink()));
    push_all(extractor, volume.on);
    finish_all(extractor);
    const HighWater marks = extractor.high_water();
    const Capacities& capacities = extractor.capacities();
    CHECK(marks.edges <= capacities.edges);
    CHECK(marks.runs <= capacities.runs);
    CHECK(marks.rings <= capacities.rings);
    CHECK(marks.regions <= capacities.regions);
    CHECK(marks.slots <= capacities.slots);
    CHECK(extractor.bytes_used() <= block.memory().bytes);
  }
}
