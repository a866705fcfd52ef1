// The substitutes for instructions that a processor or a compiler lacks.
#include <doctest/doctest.h>
#include <discmc/base/compiler.hpp>
#include <discmc/trace/threshold.hpp>

using namespace discmc;

namespace {
constexpr uint32_t patterns[] = {0, 1, 0x5A5A5A5A, 0xFFFFFFFF};
}

TEST_CASE("trailing_zeros() and trailing_zeros_by_table() return the number of trailing zeros") {
  for (uint32_t bit = 0; bit < 32; ++bit)
    for (const uint32_t above : patterns) {
      const uint32_t bits = (above << 1 | 1) << bit;
      CHECK(trailing_zeros(bits) == bit);
      CHECK(trailing_zeros_by_table(bits) == bit);
    }
}

TEST_CASE("bit_width() returns the number of bits up to the highest set bit") {
  CHECK(bit_width(uint64_t{0}) == 0);
  CHECK(bit_width(uint32_t{0}) == 0);
  for (uint32_t bit = 0; bit < 32; ++bit) {
    CHECK(bit_width(uint32_t{1} << bit) == bit + 1);
    CHECK(bit_width(~uint32_t{0} >> bit) == 32 - bit);
  }
  for (uint32_t bit = 0; bit < 64; ++bit) {
    CHECK(bit_width(uint64_t{1} << bit) == bit + 1);
    CHECK(bit_width(~uint64_t{0} >> bit) == 64 - bit);
  }
}

TEST_CASE("copy_bytes() copies from any address, and aligned_word() reads an aligned word") {
  alignas(4) const uint8_t bytes[] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  uint8_t copy[8] = {};
  copy_bytes(copy, bytes + 1, sizeof copy);
  for (uint8_t i = 0; i < 8; ++i) CHECK(copy[i] == i + 2);
  if (is_little_endian) CHECK(aligned_word(bytes + 4) == 0x08070605);
}

TEST_CASE("select_lanes() compares each lane as an unsigned number") {
  CHECK(select_lanes<8>(0x80010000, 0x7F020001, 0xAABBCCDD, 0x11223344) == 0xAA22CC44);
  CHECK(select_lanes<16>(0x80000001, 0x7FFF0002, 0xAABBCCDD, 0x11223344) == 0xAABB3344);
}

TEST_CASE("both ways of comparing lanes with a threshold yield the same bits") {
  constexpr uint32_t levels[] = {0, 1, 127, 128, 129, 255, 256};
  for (const uint32_t level : levels) {
    const detail::trace::LaneThreshold<8, true> selecting(level);
    const detail::trace::LaneThreshold<8, false> adding(level);
    for (uint32_t lane = 0; lane < 256; ++lane) {
      const uint32_t word = lane | (255 - lane) << 8 | (lane ^ 128) << 16 | lane << 24;
      CHECK(selecting.reached(word) == adding.reached(word));
      CHECK((adding.reached(word) >> 31 != 0) == (lane >= level));
    }
  }
}
