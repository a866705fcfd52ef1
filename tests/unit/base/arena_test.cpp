// The bump arena: aligned arrays, one after the other, within the memory.
#include <discmc/base/arena.hpp>

#include "test.hpp"

using namespace discmc;

namespace {

struct Six {
  uint16_t part[3];
};

bool is_aligned(const void* place) {
  return reinterpret_cast<uintptr_t>(place) % Arena::alignment == 0;
}

}  // namespace

TEST_CASE("arrays are contiguous and aligned for any start of the memory") {
  alignas(8) uint8_t bytes[64 + 3 * red_zone_bytes] = {};
  for (size_t offset = 0; offset < 4; ++offset) {
    Arena arena({bytes + offset, sizeof bytes - offset});
    const size_t skipped = (4 - offset) % 4;
    const auto* first = arena.allocate<uint8_t>(5);
    const auto* second = arena.allocate<Six>(3);
    const auto* third = arena.allocate<uint32_t>(2);
    CHECK(first == bytes + offset + skipped);
    CHECK(reinterpret_cast<const uint8_t*>(second) == first + Arena::bytes_of(5, 1));
    CHECK(reinterpret_cast<const uint8_t*>(third) ==
          first + Arena::bytes_of(5, 1) + Arena::bytes_of(3, 6));
    CHECK(is_aligned(first));
    CHECK(is_aligned(second));
    CHECK(is_aligned(third));
  }
}

TEST_CASE(
    "an arena allocates an exact fit plus three reserved bytes, for any start of the memory") {
  constexpr size_t needed = 16 + 3 * red_zone_bytes;
  alignas(4) uint8_t bytes[needed + 8] = {};
  for (size_t offset = 0; offset < 4; ++offset) {
    Arena enough({bytes + offset, needed + 3});
    CHECK(enough.allocate<uint32_t>(3) != nullptr);
    CHECK(enough.allocate<uint32_t>(1) != nullptr);
    CHECK(enough.allocate<uint8_t>(0) != nullptr);
    CHECK_FALSE(enough.is_exhausted());
    Arena short_of_one({bytes + offset, needed - red_zone_bytes + 2});
    CHECK(short_of_one.allocate<uint32_t>(3) != nullptr);
    CHECK(short_of_one.allocate<uint32_t>(1) == nullptr);
    CHECK(short_of_one.is_exhausted());
  }
}

TEST_CASE("after a failed allocation every further allocation fails") {
  alignas(4) uint8_t bytes[32 + red_zone_bytes] = {};
  for (const uint32_t count : {30U, UINT32_MAX}) {
    Arena arena(memory_of(bytes));
    CHECK(arena.allocate<uint32_t>(1) != nullptr);
    CHECK(arena.allocate<uint8_t>(count) == nullptr);
    CHECK(arena.allocate<uint8_t>(1) == nullptr);
    CHECK(arena.allocate<uint8_t>(0) == nullptr);
    CHECK(arena.is_exhausted());
  }
}

TEST_CASE("an array of an odd number of bytes is padded to the alignment") {
  alignas(4) uint8_t bytes[12 + 2 * red_zone_bytes] = {};
  Arena arena({bytes, 7 + 3 + 2 * red_zone_bytes});
  CHECK(arena.allocate<uint8_t>(4) != nullptr);
  CHECK(arena.allocate<uint8_t>(3) == nullptr);
}

TEST_CASE("memory that is null or too small to align provides no array") {
  uint8_t bytes[8] = {};
  for (size_t size = 0; size < 3; ++size) {
    Arena arena({bytes + 1, size});
    CHECK(arena.is_exhausted());
    CHECK(arena.allocate<uint8_t>(0) == nullptr);
  }
  Arena none({nullptr, 1000});
  CHECK(none.is_exhausted());
  CHECK(none.allocate<uint8_t>(1) == nullptr);
}

TEST_CASE("an arena of only the three reserved bytes allocates no array") {
  alignas(4) uint8_t bytes[4 + red_zone_bytes] = {};
  for (const size_t count : {3U, 4U}) {
    Arena arena({bytes, count + red_zone_bytes});
    CHECK_FALSE(arena.is_exhausted());
    CHECK(arena.allocate<uint8_t>(0) != nullptr);
    CHECK(arena.allocate<uint8_t>(1) == nullptr);
  }
  CHECK(Arena({bytes, 2}).is_exhausted());
}

TEST_CASE("the size of an array is rounded up to the alignment without overflow") {
  CHECK(Arena::bytes_of(0, 12) == red_zone_bytes);
  CHECK(Arena::bytes_of(1, 1) == 4 + red_zone_bytes);
  CHECK(Arena::bytes_of(4, 1) == 4 + red_zone_bytes);
  CHECK(Arena::bytes_of(5, 1) == 8 + red_zone_bytes);
  CHECK(Arena::bytes_of(3, 6) == 20 + red_zone_bytes);
  CHECK(Arena::bytes_of(UINT32_MAX, 24) == uint64_t{UINT32_MAX} * 24 + red_zone_bytes);
  static_assert(Arena::bytes_of(7, 2) == 16 + red_zone_bytes, "known at compile time");
}

TEST_CASE("arrays do not overlap and stay within the memory for any sequence of sizes") {
  uint32_t state = 1;
  const auto next = [&state](uint32_t limit) {
    state = state * 1664525 + 1013904223;
    return (state >> 16) % limit;
  };
  for (int round = 0; round < 500; ++round) {
    const uint32_t size = next(300);
    std::vector<uint8_t> memory(size + 3);
    const uint32_t offset = next(4);
    const size_t bytes = offset <= size ? size - offset : 0;
    Arena arena({memory.data() + offset, bytes});
    for (int i = 0; i < 40; ++i) {
      const uint32_t count = next(9);
      auto* records = arena.allocate<Six>(count);
      if (records == nullptr) continue;
      // Address sanitizers detect a byte beyond. A byte allocated twice is no longer zero.
      const auto* raw = reinterpret_cast<const uint8_t*>(records);
      CHECK(std::all_of(raw, raw + count * sizeof(Six), [](uint8_t byte) { return byte == 0; }));
      if (count > 0) std::memset(records, 0xFF, count * sizeof(Six));
    }
  }
}
