// With little memory, fragments are sent loose, and no region is lost. With any capacity, the
// output joins to the reference's rings.
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// A volume with a border, and its expected surface.
class Pressed {
 public:
  Pressed(BitVolume volume, Border border)
      : volume_(std::move(volume)),
        plan_{border},
        closed_(border == Border::closed),
        merged_(canonical(merge(volume_, closed_))) {}

  Limits limits() const { return limits_of(volume_, plan_.border); }

  /// Returns the fault of a scan in this memory, or an empty text. Alternates between blocks whose
  /// end address sanitizers check and blocks between guards.
  template <class Index, class Room>
  std::string fault(const Room& room) const {
    try {
      Collector collector;
      scan_into<Index>(collector, volume_, plan_, room, next_kind());
      return fault_of(collector);
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  /// Returns the peaks of a scan with ample memory.
  Peaks needed() const {
    Collector collector;
    Block block(Extractor16::bytes_for(limits(), ample));
    Extractor16 extractor;
    require_ok(extractor.start(limits(), ample, 1, block.memory(), collector.sink()));
    push_all(extractor, volume_.on);
    finish_all(extractor);
    return extractor.peaks();
  }

  /// Returns the fault of a scan in memory whose last scan was abandoned by reset(), or an empty
  /// text.
  std::string fault_after_reset(const Capacities& capacities) const {
    struct Switch {
      Collector* collector;
      SinkResult accept(const Event& event) { return collector->accept(event); }
    };
    try {
      Collector collector;
      Collector broken_off;
      Switch receiver{&broken_off};
      Block block(Extractor16::bytes_for(limits(), capacities), next_kind());
      Extractor16 extractor;
      require_ok(extractor.start(limits(), capacities, 1, block.memory(), make_sink(receiver)));
      const std::vector<uint8_t>& on = volume_.on;
      push_all(extractor, std::vector<uint8_t>(on.data(), on.data() + scans_ % on.size()));
      require_ok(extractor.reset());
      receiver.collector = &collector;
      push_all(extractor, on);
      finish_all(extractor);
      return block.is_intact() ? fault_of(collector) : "a write outside the arena";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

 private:
  Block::Kind next_kind() const {
    return ++scans_ % 2 == 0 ? Block::Kind::exact : Block::Kind::guarded;
  }

  std::string fault_of(const Collector& collector) const {
    if (collector.split_sides() != 0) return "a straight side in more runs than it needs";
    const std::string miscount = miscounted(collector, volume_, closed_);
    if (!miscount.empty()) return miscount;
    return unlike_joined({collector}, merged_);
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

// Calls check(pressed) for every volume and border.
template <class Check>
void for_each_case(Check check) {
  size_t number = 0;
  for (const BitVolume& volume : small_volumes()) {
    CAPTURE(number);
    for (const Border border : {Border::closed, Border::open}) {
      CAPTURE(border == Border::closed);
      check(Pressed(volume, border));
    }
    ++number;
  }
}

constexpr uint32_t min_slots = minimum_capacities().slots;

}  // namespace

TEST_CASE("the rings of regions do not depend on the number of slots") {
  for_each_case([](const Pressed& pressed) {
    const uint32_t most = pressed.needed().slots + 10;
    for (uint32_t slots = min_slots; slots <= most; slots += step(19)) {
      CAPTURE(slots);
      const Capacities capacities{slots, slots / 16};
      CHECK(pressed.fault<uint16_t>(capacities) == "");
      if (slots % 5 == 0) CHECK(pressed.fault<uint32_t>(capacities) == "");
      if (slots % 3 == 0) CHECK(pressed.fault_after_reset(capacities) == "");
    }
  });
}

TEST_CASE("the rings of regions do not depend on the number of waiting holes") {
  const BitVolume grid = tiling({13, 13, 3}, 15);
  BitVolume sieve({15, 15, 3});
  for (uint32_t y = 0; y < 15; ++y)
    for (uint32_t x = 0; x < 15; ++x) sieve.on[sieve.index(x, y, 1)] = x % 4 != 2 || y % 3 != 1;
  for (const BitVolume& volume : {sieve, grid, random({15, 15, 2}, 235, 3)}) {
    const Pressed pressed(volume, Border::closed);
    for (uint32_t holes = 0; holes < 30; ++holes)
      for (const uint32_t slots : {min_slots, 40U, 200U, ample.slots}) {
        INFO("holes ", holes, ", slots ", slots);
        CHECK(pressed.fault<uint16_t>(Capacities{slots, holes}) == "");
      }
  }
}

TEST_CASE("the rings are the same for any memory from the minimum to plenty") {
  for_each_case([](const Pressed& pressed) {
    const uint64_t narrow = Extractor16::minimum_bytes(pressed.limits());
    for (uint64_t extra = 0; extra < 12000; extra += step(23) * (1 + extra / 32)) {
      CAPTURE(extra);
      CHECK(pressed.fault<uint16_t>(narrow + extra) == "");
    }
    const uint64_t wide = Extractor32::minimum_bytes(pressed.limits());
    for (uint64_t bytes = wide; bytes < wide + 12000; bytes += 797)
      CHECK(pressed.fault<uint32_t>(bytes) == "");
  });
}

TEST_CASE("the rings are the same for each byte of memory added to the minimum") {
  const Pressed pressed(random({7, 6, 5}, 120, 3), Border::closed);
  const uint64_t min_bytes = Extractor16::minimum_bytes(pressed.limits());
  for (uint64_t bytes = min_bytes; bytes < min_bytes + 3000; bytes += step(17))
    CHECK(pressed.fault<uint16_t>(bytes) == "");
}

TEST_CASE("twice the peak of slots plus 64 leaves no loose fragments") {
  for (const BitVolume& volume : small_volumes())
    for (const Border border : {Border::closed, Border::open}) {
      const Peaks needed = Pressed(volume, border).needed();
      // With the peak alone, long fragments would be sent early.
      const Capacities capacities{2 * needed.slots + 64, needed.holes};
      Collector collector;
      scan_into<uint16_t>(collector, volume, {border}, capacities);
      CHECK(collector.loose().empty());
    }
}

TEST_CASE("memory for the worst case leaves no loose fragments") {
  for (uint64_t seed = 0; seed < 200; seed += step(7)) {
    const BitVolume volume = random({1 + static_cast<uint32_t>(seed % 6), 4, 3}, 150, seed);
    for (const Border border : {Border::closed, Border::open}) {
      const Limits limits = limits_of(volume, border);
      const Capacities worst = worst_case_capacities(limits, volume.depth);
      Collector collector;
      scan_into<uint16_t>(collector, volume, {border}, worst);
      CHECK(collector.loose().empty());
      CHECK(unlike_merge(collector.regions(), volume, border == Border::closed) == "");
    }
  }
}

TEST_CASE("slabs of any thickness, in any memory, join to the whole surface") {
  for (uint64_t seed = 0; seed < 120; seed += step(11)) {
    CAPTURE(seed);
    const auto s = static_cast<uint32_t>(seed);
    const BitVolume volume =
        random({1 + s % 9, 1 + s / 2 % 8, 1 + s % 15}, 30 + s * 41 % 200, seed);
    for (const Border border : {Border::closed, Border::open}) {
      const std::vector<Region> merged = merge(volume, border == Border::closed);
      for (const uint32_t slices : {1U, 2U, 3U, 7U})
        for (const uint64_t spare : {0U, 200U, 100000U}) {
          INFO("slices ", slices, ", spare ", spare);
          CHECK(unlike_joined(scan_slabs<uint16_t>(volume, border, slices, spare), merged) == "");
          CHECK(unlike_joined(
                    scan_slabs<uint32_t>(volume, border, slices, spare, reference::refuses_first),
                    merged) == "");
        }
    }
  }
}

TEST_CASE(
    "more memory never yields more loose fragments of a ball, and enough memory yields none") {
  const BitVolume volume = ball({31, 31, 31}, {30, 30, 30}, 180);
  const Limits limits = limits_of(volume, Border::closed);
  size_t before = SIZE_MAX;
  for (const uint64_t bytes : {0U, 500U, 1000U, 2000U, 4000U, 8000U, 16000U}) {
    Collector collector;
    scan_into<uint16_t>(collector, volume, {}, Extractor16::minimum_bytes(limits) + bytes);
    CHECK(collector.loose().size() <= before);
    before = collector.loose().size();
  }
  CHECK(before == 0);
}

TEST_CASE("a thousand layers need no more slots and holes than the first 40 layers") {
  for (uint64_t seed = 0; seed < 12; seed += step(3)) {
    // An off slice ends every region, so that no holes accumulate in open regions.
    BitVolume period = random({7, 8, 10}, 60 + 15 * static_cast<uint32_t>(seed), seed);
    std::fill_n(period.on.begin(), 7 * 8, uint8_t{0});
    BitVolume longer({7, 8, 1000});
    for (size_t i = 0; i < longer.voxels(); ++i) longer.on[i] = period.on[i % period.voxels()];
    BitVolume shorter({7, 8, 40});
    std::copy_n(longer.on.begin(), shorter.voxels(), shorter.on.begin());
    const Peaks of_shorter = Pressed(shorter, Border::closed).needed();
    const Peaks of_longer = Pressed(longer, Border::closed).needed();
    CHECK(of_longer.slots == of_shorter.slots);
    CHECK(of_longer.holes == of_shorter.holes);
  }
}
