// What stands in for instructions that a processor or a compiler lacks.
#include <doctest/doctest.h>
#include <discmc/compiler.hpp>

using namespace discmc;

TEST_CASE("the zeros below the lowest bit are counted alike by the processor and by the table") {
  for (uint32_t bit = 0; bit < 32; ++bit)
    for (const uint32_t above : {0U, 1U, 0x5A5A5A5AU, ~0U}) {
      const uint32_t bits = (above << 1 | 1) << bit;
      CHECK(trailing_zeros(bits) == bit);
      CHECK(trailing_zeros_by_table(bits) == bit);
    }
}
