// Capacities: constants at compile time, sufficient as promised, and refused if impossible.
#include <discmc/capacities.hpp>
#include <discmc/normal_extractor.hpp>

#include "oracle/scan.hpp"
#include "test.hpp"

using namespace discmc;

namespace {

// As in firmware, the size of the memory is a constant.
constexpr Limits small{64, 48};
uint8_t default_memory[Extractor16::minimum_bytes(small) + 16384];
uint8_t worst_memory[Extractor32::bytes_for({8, 8, Border::open},
                                            worst_case_capacities({8, 8, Border::open}, 8))];
uint8_t explicit_memory[Extractor16::bytes_for(small, {100, 20})];

constexpr uint32_t extents[] = {1,   2,   3,   7,    8,    9,    30,    31,    32,   33,  34,
                                62,  63,  64,  65,   100,  127,  128,   129,   255,  256, 257,
                                511, 512, 513, 1000, 2048, 4095, 10000, 32765, 32766};

bool at_most(const Capacities& a, const Capacities& b) {
  return a.slots <= b.slots && a.holes <= b.holes;
}

template <class Check>
void for_each_limits(Check check) {
  for (const uint32_t width : extents)
    for (const uint32_t height : extents)
      for (const Border border : {Border::closed, Border::open}) {
        INFO("width ", width, ", height ", height);
        check(Limits{width, height, border});
      }
}

template <class Index, class Normals = detail::trace::BitIntake>
void check_defaults(const Limits& limits, uint64_t bytes) {
  const Capacities capacities = detail::sizing::default_capacities<Index, Normals>(limits, bytes);
  CAPTURE(bytes);
  REQUIRE(detail::sizing::bytes_for<Index, Normals>(limits, capacities) <= bytes);
  REQUIRE(detail::sizing::is_valid<Index>(capacities));
  REQUIRE(at_most(minimum_capacities(), capacities));
}

// Increasing sizes, up to the end of 64 bits.
template <class Index>
void check_defaults_of_many_sizes(const Limits& limits) {
  const uint64_t minimum = Extractor<Index>::minimum_bytes(limits);
  Capacities before = minimum_capacities();
  for (uint64_t extra = 0; extra < uint64_t{1} << 40; extra = extra * 3 / 2 + 7) {
    check_defaults<Index>(limits, minimum + extra);
    const Capacities capacities = Extractor<Index>::default_capacities(limits, minimum + extra);
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
  return status;
}

}  // namespace

TEST_CASE("memory of bytes computed at compile time suffices to start a scan") {
  reference::Collector collector;
  const Sink sink = collector.sink();
  Extractor16 extractor;
  Extractor32 wide;
  CHECK(extractor.start(small, 1, memory_of(default_memory), sink) == Status::ok);
  CHECK(extractor.start(small, {100, 20}, 1, memory_of(explicit_memory), sink) == Status::ok);
  constexpr Limits open{8, 8, Border::open};
  CHECK(wide.start(open, worst_case_capacities(open, 8), 1, memory_of(worst_memory), sink) ==
        Status::ok);
}

TEST_CASE("the default capacities fit in the given number of bytes for any limits") {
  for_each_limits([](const Limits& limits) {
    check_defaults_of_many_sizes<uint16_t>(limits);
    check_defaults_of_many_sizes<uint32_t>(limits);
  });
}

TEST_CASE("the default capacities fit in memory of any size from the minimum") {
  for (const uint32_t width : {1U, 2U, 31U, 100U})
    for (uint64_t extra = 0; extra < 5000; ++extra) {
      const Limits limits{width, 5, extra % 2 == 0 ? Border::closed : Border::open};
      check_defaults<uint16_t>(limits, Extractor16::minimum_bytes(limits) + extra);
      check_defaults<uint32_t>(limits, Extractor32::minimum_bytes(limits) + extra);
      using Normals = detail::trace::GradientIntake<uint16_t>;
      check_defaults<uint16_t, Normals>(
          limits, detail::sizing::minimum_bytes<uint16_t, Normals>(limits) + extra);
    }
}

TEST_CASE("the default capacities leave only a few bytes unused") {
  for (uint64_t extra = 0; extra < 5000; ++extra) {
    const uint64_t bytes = Extractor16::minimum_bytes(small) + extra;
    const Capacities capacities = Extractor16::default_capacities(small, bytes);
    const uint64_t left = bytes - Extractor16::bytes_for(small, capacities);
    CHECK(left < 8 + Arena::alignment);
    CHECK(capacities.holes == capacities.slots / 16);
  }
}

TEST_CASE("memory below the minimum yields the minimum capacities") {
  const Capacities minimum = minimum_capacities();
  for (const uint64_t bytes : {uint64_t{0}, uint64_t{1}, Extractor16::minimum_bytes(small)}) {
    CHECK(at_most(Extractor16::default_capacities(small, bytes), minimum));
    CHECK(at_most(minimum, Extractor16::default_capacities(small, bytes)));
  }
}

TEST_CASE("exactly bytes_for() bytes start a scan at any address, and one byte less is refused") {
  for (const uint32_t width : {1U, 2U, 31U, 32U, 64U})
    for (const uint32_t height : {1U, 2U, 9U})
      for (const Border border : {Border::closed, Border::open}) {
        const Limits limits{width, height, border};
        const Capacities odd{35, 13};
        for (const Capacities& capacities : {minimum_capacities(), reference::ample, odd}) {
          const uint64_t narrow = Extractor16::bytes_for(limits, capacities);
          CHECK(start_with<uint16_t>(limits, capacities, narrow) == Status::ok);
          CHECK(start_with<uint16_t>(limits, capacities, narrow - 1) == Status::too_little_memory);
          const uint64_t wide = Extractor32::bytes_for(limits, capacities);
          CHECK(start_with<uint32_t>(limits, capacities, wide) == Status::ok);
          CHECK(start_with<uint32_t>(limits, capacities, wide - 1) == Status::too_little_memory);
        }
      }
}

TEST_CASE("fewer slots than the minimum, or more slots than an index counts, are refused") {
  const Capacities minimum = minimum_capacities();
  CHECK(detail::sizing::is_valid<uint16_t>(minimum));
  CHECK(detail::sizing::is_valid<uint32_t>(minimum));
  CHECK_FALSE(detail::sizing::is_valid<uint16_t>({minimum.slots - 1, 0}));
  CHECK_FALSE(detail::sizing::is_valid<uint32_t>({minimum.slots - 1, 0}));
  CHECK(detail::sizing::is_valid<uint16_t>({32759, 0}));
  CHECK_FALSE(detail::sizing::is_valid<uint16_t>({32760, 0}));
  CHECK(detail::sizing::is_valid<uint32_t>({0x7FFFFFF7, 0}));
  CHECK_FALSE(detail::sizing::is_valid<uint32_t>({0x7FFFFFF8, 0}));
  CHECK(detail::sizing::is_valid<uint16_t>({32759, UINT32_MAX}));
  CHECK(start_with<uint16_t>(small, {32760, 0}, 1 << 20) == Status::bad_capacities);
  CHECK(start_with<uint16_t>(small, {minimum.slots - 1, 0}, 1 << 20) == Status::bad_capacities);
}

TEST_CASE("the minimum lies below the worst case and does not grow with the number of slices") {
  for_each_limits([](const Limits& limits) {
    const Capacities one = worst_case_capacities(limits, 1);
    CHECK(at_most(minimum_capacities(), one));
    CHECK(at_most(one, worst_case_capacities(limits, 2)));
    CHECK(at_most(worst_case_capacities(limits, 2), worst_case_capacities(limits, UINT32_MAX)));
    CHECK(Extractor16::minimum_bytes(limits) <= Extractor32::minimum_bytes(limits));
    CHECK(Extractor16::minimum_bytes(limits) <=
          Extractor16::bytes_for(limits, worst_case_capacities(limits, 1)));
  });
}

TEST_CASE("worst-case capacities never shrink with more slices, and saturate at the maximum") {
  constexpr Limits limits{1, 1};
  constexpr uint32_t slices =
      UINT32_MAX / detail::sizing::slots_per_cell / 4;  // of four cells each
  Capacities before = worst_case_capacities(limits, slices - 3);
  for (uint32_t more = slices - 2; more < slices + 3; ++more) {
    const Capacities now = worst_case_capacities(limits, more);
    CHECK(at_most(before, now));
    before = now;
  }
  CHECK(at_most(worst_case_capacities(limits, UINT32_MAX), before));
}

TEST_CASE("scans of 256 x 256 and 64 x 64 voxels fit in 20 KiB and 2.5 KiB") {
  CHECK(Extractor16::minimum_bytes({256, 256}) <= 20 * 1024);
  CHECK(Extractor16::minimum_bytes({64, 64}) <= 2560);
}
