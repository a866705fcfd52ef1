// What stands in for instructions that a processor or a compiler lacks.
#include <doctest/doctest.h>
#include <discmc/compiler.hpp>

using namespace discmc;

namespace {
constexpr uint32_t patterns[] = {0, 1, 0x5A5A5A5A, 0xFFFFFFFF};
}

TEST_CASE("the zeros below the lowest bit are counted alike by the processor and by the table") {
  for (uint32_t bit = 0; bit < 32; ++bit)
    for (const uint32_t above : patterns) {
      const uint32_t bits = (above << 1 | 1) << bit;
      CHECK(trailing_zeros(bits) == bit);
      CHECK(trailing_zeros_by_table(bits) == bit);
    }
}

TEST_CASE("the bits up to the highest one are counted") {
  CHECK(bit_width(0) == 0);
  for (uint32_t bit = 0; bit < 64; ++bit) {
    CHECK(bit_width(uint64_t{1} << bit) == bit + 1);
    CHECK(bit_width(~uint64_t{0} >> bit) == 64 - bit);
  }
}
