// The C functions between a sensor and the extractor do what the C++ functions do.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <discmc/discmc.hpp>

#include <cstring>
#include <vector>

#include "oracle/scan.hpp"
#include "oracle/stream.hpp"

using namespace discmc;
using reference::Block;

namespace {

constexpr uint32_t width = 37, height = 5, depth = 6;
constexpr Limits limits{width, height, Border::open};
constexpr discmc_limits limits_in_c = {width, height, DISCMC_OPEN, {}};

discmc_memory in_c(const Memory& memory) {
  return {memory.data, memory.bytes};
}

template <class Sample>
std::vector<Sample> some_samples() {
  test::Chance chance(5);
  std::vector<Sample> samples;
  for (uint32_t i = 0; i < width * height * depth; ++i)
    samples.push_back(static_cast<Sample>(chance.next()));
  return samples;
}

using Bytes = std::vector<uint8_t>;

void append(Bytes& bytes, const void* row, size_t count) {
  const auto* const first = static_cast<const uint8_t*>(row);
  bytes.insert(bytes.end(), first, first + (row == nullptr ? 0 : count));
}

}  // namespace

TEST_CASE("a ring through C hands on the rows that came, and those that were lost") {
  CHECK(discmc_row_ring_bytes_for(6, 2) == RowRing::bytes_for(6, 2));
  Block block(discmc_row_ring_bytes_for(6, 2));
  discmc_row_ring ring = {};
  CHECK(discmc_row_ring_free_row(&ring, 0) == nullptr);
  CHECK(discmc_row_ring_start(&ring, 0, 2, in_c(block.memory())) == DISCMC_BAD_CAPACITIES);
  CHECK(discmc_row_ring_start(&ring, 6, 2, {nullptr, 0}) == DISCMC_TOO_LITTLE_MEMORY);
  REQUIRE(discmc_row_ring_start(&ring, 6, 2, in_c(block.memory())) == DISCMC_OK);
  CHECK(discmc_row_ring_next(&ring) == DISCMC_NEXT_NOTHING);
  std::memcpy(discmc_row_ring_free_row(&ring, 0), "first", 6);
  std::memcpy(discmc_row_ring_free_row(&ring, 1), "third", 6);
  CHECK(discmc_row_ring_free_row(&ring, 2) == nullptr);
  discmc_row_ring_fill(&ring);
  discmc_row_ring_lose(&ring, 1);
  discmc_row_ring_fill(&ring);
  discmc_row_ring_end(&ring);
  CHECK(discmc_row_ring_came(&ring) == 3);

  CHECK(discmc_row_ring_next(&ring) == DISCMC_NEXT_ROW);
  CHECK(std::strcmp(static_cast<const char*>(discmc_row_ring_row(&ring)), "first") == 0);
  discmc_row_ring_pass(&ring);
  CHECK(discmc_row_ring_next(&ring) == DISCMC_NEXT_LOST);
  CHECK(discmc_row_ring_passed(&ring) == 1);
  discmc_row_ring_pass(&ring);
  CHECK(discmc_row_ring_lost(&ring) == 1);
  CHECK(discmc_row_ring_next(&ring) == DISCMC_NEXT_ROW);
  CHECK(std::strcmp(static_cast<const char*>(discmc_row_ring_row(&ring)), "third") == 0);
  discmc_row_ring_pass(&ring);
  CHECK(discmc_row_ring_next(&ring) == DISCMC_NEXT_END);
  CHECK(discmc_row_ring_passed(&ring) == 3);
}

TEST_CASE("samples are unpacked through C alike") {
  const Bytes bytes = some_samples<uint8_t>();
  for (uint8_t packing = 0; packing <= DISCMC_MONO12_PACKED; ++packing) {
    CHECK(discmc_packed_bytes(packing, 39) == packed_bytes(static_cast<Packing>(packing), 39));
    uint16_t in_cpp[39] = {}, through_c[39] = {};
    unpack(static_cast<Packing>(packing), bytes.data(), 39, in_cpp);
    discmc_unpack(packing, bytes.data(), 39, through_c);
    CHECK(std::memcmp(in_cpp, through_c, sizeof in_cpp) == 0);
  }
  uint16_t untouched = 7;
  discmc_unpack(DISCMC_MONO12_PACKED + 1, bytes.data(), 1, &untouched);
  CHECK(untouched == 7);
}

namespace {

template <class Sample, class ThroughC, class LessThroughC>
void check_threshold(int32_t threshold, ThroughC through_c, LessThroughC less_through_c) {
  const std::vector<Sample> samples = some_samples<Sample>();
  const std::vector<int16_t> offsets = some_samples<int16_t>();
  for (const uint32_t stride : {1U, 2U}) {
    Bytes expected(5), bits(5);
    threshold_row(samples.data(), width, threshold, expected.data(), stride);
    through_c(samples.data(), width, threshold, bits.data(), stride);
    CHECK(bits == expected);
  }
  Bytes expected(5), bits(5);
  threshold_row_less(samples.data(), offsets.data(), width, threshold, expected.data());
  less_through_c(samples.data(), offsets.data(), width, threshold, bits.data());
  CHECK(bits == expected);
}

}  // namespace

TEST_CASE("rows are compared with a threshold through C alike") {
  check_threshold<uint8_t>(100, discmc_threshold_row_u8, discmc_threshold_row_less_u8);
  check_threshold<uint16_t>(30000, discmc_threshold_row_u16, discmc_threshold_row_less_u16);
  check_threshold<int16_t>(-100, discmc_threshold_row_i16, discmc_threshold_row_less_i16);
}

TEST_CASE("a picker through C picks the same rows and samples") {
  const discmc_picked_range axes[3] = {{3, 9, 3}, {1, DISCMC_REST, 2}, {2, 2, 1}};
  discmc_row_picker picker = {};
  const discmc_picked_range too_many[3] = {{3, width, 3}, axes[1], axes[2]};
  CHECK(discmc_row_picker_start(&picker, &limits_in_c, too_many) == DISCMC_BAD_LIMITS);
  REQUIRE(discmc_row_picker_start(&picker, &limits_in_c, axes) == DISCMC_OK);
  RowPicker same;
  REQUIRE(same.start(limits, {3, 9, 3}, {1, PickedRange::rest, 2}, {2, 2, 1}) == Status::ok);
  const discmc_limits part = discmc_row_picker_limits(&picker);
  CHECK(part.width == same.limits().width);
  CHECK(part.height == same.limits().height);
  CHECK(part.border == DISCMC_OPEN);
  CHECK(discmc_row_picker_first(&picker) == 3);
  CHECK(discmc_row_picker_count(&picker) == 9);
  CHECK(discmc_row_picker_step(&picker) == 3);
  for (uint32_t row = 0; row < height * depth; ++row) {
    CHECK(discmc_row_picker_next(&picker) == (same.next() ? 1 : 0));
    CHECK(discmc_row_picker_is_done(&picker) == (same.is_done() ? 1 : 0));
  }
  const Bytes bits = some_samples<uint8_t>();
  Bytes expected(2), picked(2);
  same.pick_bits(bits.data(), expected.data());
  discmc_row_picker_pick_bits(&picker, bits.data(), picked.data());
  CHECK(picked == expected);
}

namespace {

template <class Sample, class Start, class Push, class Drain>
void check_means(Start start, Push push, Drain drain) {
  const std::vector<Sample> samples = some_samples<Sample>();
  constexpr uint32_t extent = 4;
  const uint64_t bytes = discmc_block_means_bytes_for(&limits_in_c, extent, sizeof(Sample));
  REQUIRE(bytes == BlockMeans<Sample>::bytes_for(limits, extent));
  Block block(bytes), block_in_c(bytes);
  BlockMeans<Sample> same;
  REQUIRE(same.start(limits, extent, block.memory()) == Status::ok);
  discmc_block_means means = {};
  CHECK(start(&means, &limits_in_c, 17, in_c(block_in_c.memory())) == DISCMC_BAD_LIMITS);
  REQUIRE(start(&means, &limits_in_c, extent, in_c(block_in_c.memory())) == DISCMC_OK);
  const discmc_limits part = discmc_block_means_limits(&means);
  CHECK(part.width == 10);
  CHECK(part.height == 2);
  CHECK(part.border == DISCMC_OPEN);
  Bytes expected, got;
  for (uint32_t row = 0; row < height * depth; ++row) {
    append(expected, same.push(&samples[size_t{row} * width]), 10 * sizeof(Sample));
    append(got, push(&means, &samples[size_t{row} * width]), 10 * sizeof(Sample));
  }
  for (int row = 0; row < 3; ++row) {
    append(expected, same.drain(), 10 * sizeof(Sample));
    append(got, drain(&means), 10 * sizeof(Sample));
  }
  CHECK(expected.size() == 4 * 10 * sizeof(Sample));
  CHECK(got == expected);
}

}  // namespace

TEST_CASE("blocks become their mean through C alike") {
  check_means<uint8_t>(discmc_block_means_start_u8, discmc_block_means_push_u8,
                       discmc_block_means_drain_u8);
  check_means<uint16_t>(discmc_block_means_start_u16, discmc_block_means_push_u16,
                        discmc_block_means_drain_u16);
  check_means<int16_t>(discmc_block_means_start_i16, discmc_block_means_push_i16,
                       discmc_block_means_drain_i16);
}

TEST_CASE("a majority filter through C filters alike") {
  const Bytes bits = some_samples<uint8_t>();
  const uint64_t bytes = discmc_majority_filter_bytes_for(&limits_in_c);
  REQUIRE(bytes == MajorityFilter::bytes_for(limits));
  Block block(bytes), block_in_c(bytes);
  MajorityFilter same;
  REQUIRE(same.start(limits, block.memory()) == Status::ok);
  discmc_majority_filter filter = {};
  CHECK(discmc_majority_filter_start(&filter, &limits_in_c, {nullptr, 0}) ==
        DISCMC_TOO_LITTLE_MEMORY);
  REQUIRE(discmc_majority_filter_start(&filter, &limits_in_c, in_c(block_in_c.memory())) ==
          DISCMC_OK);
  Bytes expected, got;
  for (uint32_t row = 0; row < height * depth; ++row) {
    append(expected, same.push(&bits[5 * row]), 5);
    append(got, discmc_majority_filter_push(&filter, &bits[5 * row]), 5);
  }
  for (uint32_t row = 0; row < height + 2; ++row) {
    append(expected, same.drain(), 5);
    append(got, discmc_majority_filter_drain(&filter), 5);
  }
  CHECK(expected.size() == 5 * height * depth);
  CHECK(got == expected);
}

TEST_CASE("the constants of sizes.h are what the functions give, for any size") {
  for (const uint32_t w : {1U, 31U, 32U, 33U, 32766U})
    for (const uint32_t h : {1U, 2U, 32766U}) {
      const discmc_limits size = {w, h, DISCMC_CLOSED, {}};
      CHECK(DISCMC_MAJORITY_FILTER_BYTES_FOR(w, h) == discmc_majority_filter_bytes_for(&size));
      CHECK(DISCMC_ROW_RING_BYTES_FOR(w, h) == discmc_row_ring_bytes_for(w, h));
      for (const uint32_t extent : {1U, 2U, 16U})
        for (const uint32_t bytes : {1U, 2U})
          CHECK(DISCMC_BLOCK_MEANS_BYTES_FOR(w, h, extent, bytes) ==
                discmc_block_means_bytes_for(&size, extent, bytes));
    }
}
