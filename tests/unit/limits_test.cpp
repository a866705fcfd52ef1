// Sizes: known at compile time, what they promise is enough, and what cannot be is refused.
#include <doctest/doctest.h>
#include <discmc/extractor.hpp>
#include <discmc/limits.hpp>

#include "oracle/scan.hpp"

using namespace discmc;

namespace {

// As firmware would write it: the memory's size is a constant.
constexpr Limits small{64, 48};
uint8_t default_memory[minimum_bytes<uint16_t>(small) + 16384];
uint8_t worst_memory[worst_case_bytes<uint32_t>({8, 8, Border::open})];
uint8_t explicit_memory[bytes_for<uint16_t>(small, {100, 150, 20, 60, 128})];

static_assert(sizeof default_memory > 16384 && sizeof worst_memory > 0 &&
                  sizeof explicit_memory > 0,
              "sizes are constants");
static_assert(!Limits{0, 1}.are_valid() && !Limits{1, 0}.are_valid() &&
                  !Limits{Limits::max_extent + 1, 1}.are_valid() &&
                  Limits{Limits::max_extent, Limits::max_extent}.are_valid(),
              "extents are 1 to 32766");

constexpr uint32_t extents[] = {1,   2,   3,   7,    8,    9,    30,    31,    32,   33,  34,
                                62,  63,  64,  65,   100,  127,  128,   129,   255,  256, 257,
                                511, 512, 513, 1000, 2048, 4095, 10000, 32765, 32766};

bool at_most(const Capacities& a, const Capacities& b) {
  return a.edges <= b.edges && a.runs <= b.runs && a.rings <= b.rings && a.regions <= b.regions &&
         a.slots <= b.slots;
}

template <class Check>
void for_each_limits(Check check) {
  for (const uint32_t width : extents)
    for (const uint32_t height : extents)
      for (const Border border : {Border::closed, Border::open}) {
        CAPTURE(width);
        CAPTURE(height);
        check(Limits{width, height, border});
      }
}

template <class Index>
void check_defaults(const Limits& limits, uint64_t bytes) {
  const Capacities capacities = default_capacities<Index>(limits, bytes);
  CAPTURE(bytes);
  REQUIRE(bytes_for<Index>(limits, capacities) <= bytes);
  REQUIRE(are_valid<Index>(capacities));
  REQUIRE(at_most(minimum_capacities(), capacities));
}

// Each more than the last, up to the end of 64 bits.
template <class Index>
void check_defaults_of_many_sizes(const Limits& limits) {
  const uint64_t least = minimum_bytes<Index>(limits);
  Capacities before = minimum_capacities();
  for (uint64_t extra = 0; extra < uint64_t{1} << 40; extra = extra * 3 / 2 + 7) {
    check_defaults<Index>(limits, least + extra);
    const Capacities capacities = default_capacities<Index>(limits, least + extra);
    REQUIRE(at_most(before, capacities));
    before = capacities;
  }
  check_defaults<Index>(limits, UINT64_MAX);
}

template <class Index>
Status start_with(const Limits& limits, const Capacities& capacities, size_t bytes) {
  reference::Collector collector;
  reference::Block block(bytes);
  Extractor<Index> extractor;
  const Status status = extractor.start(limits, capacities, 1, block.memory(), collector.sink());
  CHECK(block.is_intact());
  if (status == Status::ok) CHECK(extractor.bytes_used() == bytes_for<Index>(limits, capacities));
  return status;
}

}  // namespace

TEST_CASE("memory whose size was known at compile time starts a scan") {
  reference::Collector collector;
  const Sink sink = collector.sink();
  Extractor16 extractor;
  Extractor32 wide;
  CHECK(extractor.start(small, 1, memory_of(default_memory), sink) == Status::ok);
  CHECK(extractor.start(small, {100, 150, 20, 60, 128}, 1, memory_of(explicit_memory), sink) ==
        Status::ok);
  constexpr Limits open{8, 8, Border::open};
  CHECK(wide.start(open, worst_case_capacities(open), 1, memory_of(worst_memory), sink) ==
        Status::ok);
}

TEST_CASE("twice a number and some more is the largest number where it would wrap") {
  CHECK(sizing::twice(7, 34) == 48);
  CHECK(sizing::twice((UINT32_MAX - 34) / 2, 34) == UINT32_MAX - 1);
  CHECK(sizing::twice((UINT32_MAX - 34) / 2 + 1, 34) == UINT32_MAX);
  CHECK(sizing::twice(UINT32_MAX, 34) == UINT32_MAX);
}

TEST_CASE("cells, halo and words of a row follow from the limits") {
  for_each_limits([](const Limits& limits) {
    const uint32_t halo = limits.border == Border::closed ? 1 : 0;
    CHECK(limits.columns() == limits.width - 1 + 2 * halo);
    CHECK(limits.cell_rows() == limits.height - 1 + 2 * halo);
    CHECK(limits.row_words() * 32 >= limits.width + 2 * halo);
    CHECK((limits.row_words() - 1) * 32 < limits.width + 2 * halo);
  });
}

TEST_CASE("the default capacities fit in the bytes given, whatever those and the limits are") {
  for_each_limits([](const Limits& limits) {
    check_defaults_of_many_sizes<uint16_t>(limits);
    check_defaults_of_many_sizes<uint32_t>(limits);
  });
}

TEST_CASE("the default capacities fit in every single number of bytes") {
  for (const uint32_t width : {1U, 2U, 31U, 100U})
    for (uint64_t extra = 0; extra < 5000; ++extra) {
      const Limits limits{width, 5, extra % 2 == 0 ? Border::closed : Border::open};
      check_defaults<uint16_t>(limits, minimum_bytes<uint16_t>(limits) + extra);
      check_defaults<uint32_t>(limits, minimum_bytes<uint32_t>(limits) + extra);
    }
}

TEST_CASE("fewer bytes than the minimum give the minimum") {
  const Capacities least = minimum_capacities();
  for (const uint64_t bytes : {uint64_t{0}, uint64_t{1}, minimum_bytes<uint16_t>(small)}) {
    CHECK(at_most(default_capacities<uint16_t>(small, bytes), least));
    CHECK(at_most(least, default_capacities<uint16_t>(small, bytes)));
  }
}

TEST_CASE("exactly the bytes asked for are enough, wherever they begin, and one less is refused") {
  for (const uint32_t width : {1U, 2U, 31U, 32U, 64U})
    for (const uint32_t height : {1U, 2U, 9U})
      for (const Border border : {Border::closed, Border::open}) {
        const Limits limits{width, height, border};
        const Capacities odd{3, 35, 13, 7, 5};
        for (const Capacities& capacities :
             {minimum_capacities(), worst_case_capacities(limits), odd}) {
          const uint64_t narrow = bytes_for<uint16_t>(limits, capacities);
          CHECK(start_with<uint16_t>(limits, capacities, narrow) == Status::ok);
          CHECK(start_with<uint16_t>(limits, capacities, narrow - 1) == Status::too_little_memory);
          const uint64_t wide = bytes_for<uint32_t>(limits, capacities);
          CHECK(start_with<uint32_t>(limits, capacities, wide) == Status::ok);
          CHECK(start_with<uint32_t>(limits, capacities, wide - 1) == Status::too_little_memory);
        }
      }
}

TEST_CASE("capacities below the minimum or beyond what an index counts are refused") {
  const Capacities least = minimum_capacities();
  CHECK(are_valid<uint16_t>(least));
  CHECK(are_valid<uint32_t>(least));
  uint32_t Capacities::*const pools[] = {&Capacities::edges, &Capacities::runs, &Capacities::rings,
                                         &Capacities::regions, &Capacities::slots};
  for (const auto pool : pools) {
    Capacities capacities = least;
    capacities.*pool -= 1;
    CHECK_FALSE(are_valid<uint16_t>(capacities));
    CHECK_FALSE(are_valid<uint32_t>(capacities));
    capacities.*pool = UINT32_MAX;
    CHECK_FALSE(are_valid<uint32_t>(capacities));
    const bool is_slots = pool == &Capacities::slots;
    capacities.*pool = 65535;
    CHECK(are_valid<uint16_t>(capacities) == is_slots);
    CHECK(are_valid<uint32_t>(capacities));
  }
  // References to a region are counted in one index.
  CHECK(are_valid<uint16_t>({40000, 34, 11, 25534, 1}));
  CHECK_FALSE(are_valid<uint16_t>({40000, 34, 11, 25535, 1}));
  CHECK(are_valid<uint16_t>({2, 65534, 65534, 5, 0x7FFFFFFF}));
  CHECK_FALSE(are_valid<uint16_t>({2, 65534, 65534, 5, 0x80000000}));
}

TEST_CASE("the minimum lies below the worst case, and more room never needs fewer bytes") {
  for_each_limits([](const Limits& limits) {
    CHECK(minimum_bytes<uint16_t>(limits) <= worst_case_bytes<uint16_t>(limits));
    CHECK(minimum_bytes<uint16_t>(limits) <= minimum_bytes<uint32_t>(limits));
    CHECK(worst_case_bytes<uint16_t>(limits) <= worst_case_bytes<uint32_t>(limits));
    CHECK(at_most(minimum_capacities(), worst_case_capacities(limits)));
  });
}

TEST_CASE("the worst case of any slice up to 4096 voxels a side can be started on a host") {
  for_each_limits([](const Limits& limits) {
    if (limits.width > 4096 || limits.height > 4096) return;
    CHECK(are_valid<uint32_t>(worst_case_capacities(limits)));
  });
}
