// The ring of rows and the unpackers behave the same in C and in C++.
#include <discmc/front.h>

#include <discmc/front/packed_samples.hpp>

#include "oracle/scan.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using discmc::reference::Block;

TEST_CASE("a ring in C delivers rows in order and marks lost rows in their place") {
  constexpr uint32_t row_bytes = 37, rows = 3;
  Block block(DISCMC_ROW_RING_BYTES(row_bytes, rows));
  const discmc_row_ring_config config = {
      row_bytes, rows, {block.memory().data, block.memory().bytes}};
  discmc_row_ring* ring = nullptr;
  REQUIRE(discmc_row_ring_start(&ring, &config) == DISCMC_OK);
  CHECK(discmc_row_ring_peek(ring).kind == DISCMC_ROW_NONE);
  CHECK(static_cast<uint8_t*>(discmc_row_ring_free_row(ring, 0)) -
            static_cast<uint8_t*>(config.memory.data) <
        4);
  for (int lap = 0; lap < 3; ++lap) {
    for (uint8_t i = 0; i < rows; ++i) {
      CHECK((discmc_row_ring_free_row(ring, rows - 1 - i) != nullptr));
      CHECK(discmc_row_ring_free_row(ring, rows - i) == nullptr);
      std::memset(discmc_row_ring_free_row(ring, 0), i, row_bytes);
      if (i == 1) discmc_row_ring_drop(ring, 2);
      discmc_row_ring_commit(ring);
    }
    CHECK(discmc_row_ring_drop(ring, 0) == static_cast<uint32_t>(5 * lap + 5));
    for (uint8_t i = 0; i < 5; ++i) {
      const discmc_row row = discmc_row_ring_peek(ring);
      CHECK(row.number == static_cast<uint32_t>(5 * lap + i));
      CHECK(row.kind == (i == 1 || i == 2 ? DISCMC_ROW_LOST : DISCMC_ROW_READY));
      if (row.kind == DISCMC_ROW_READY)
        CHECK(static_cast<uint8_t*>(row.samples)[row_bytes - 1] == (i == 0 ? 0 : i - 2));
      discmc_row_ring_pop(ring);
    }
  }
  discmc_row_ring_end(ring);
  CHECK(discmc_row_ring_peek(ring).kind == DISCMC_ROW_END);
  CHECK(block.is_intact());
}

TEST_CASE("invalid calls of rings in C return their status") {
  Block block(DISCMC_ROW_RING_BYTES(10, 3));
  discmc_row_ring* ring = nullptr;
  discmc_row_ring_config config = {10, 0, {block.memory().data, block.memory().bytes}};
  CHECK(discmc_row_ring_start(&ring, &config) == DISCMC_BAD_CAPACITIES);
  config = {0, 3, config.memory};
  CHECK(discmc_row_ring_start(&ring, &config) == DISCMC_BAD_CAPACITIES);
  config = {10, 4, config.memory};
  CHECK(discmc_row_ring_start(&ring, &config) == DISCMC_TOO_LITTLE_MEMORY);
  config.rows = 3;
  --config.memory.bytes;
  CHECK(discmc_row_ring_start(&ring, &config) == DISCMC_TOO_LITTLE_MEMORY);
  const size_t enough = ++config.memory.bytes;
  config.memory.bytes = 20;
  CHECK(discmc_row_ring_start(&ring, &config) == DISCMC_TOO_LITTLE_MEMORY);
  config.memory = {nullptr, enough};
  CHECK(discmc_row_ring_start(&ring, &config) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(ring == nullptr);
  config.memory.data = block.memory().data;
  CHECK(discmc_row_ring_start(&ring, &config) == DISCMC_OK);
}

TEST_CASE("samples are unpacked in C in the same way as in C++") {
  std::vector<uint8_t> packed(200);
  test::Chance chance(1);
  for (uint8_t& byte : packed) byte = chance.byte();
  for (uint8_t packing = DISCMC_RAW10; packing <= DISCMC_MONO12_PACKED; ++packing)
    for (uint32_t count = 0; count < 40; ++count) {
      const auto in_cpp = static_cast<Packing>(packing);
      CHECK(discmc_packed_bytes(packing, count) == packed_bytes(in_cpp, count));
      std::vector<uint16_t> samples(40), expected(40);
      discmc_unpack(packing, packed.data(), count, samples.data());
      unpack(in_cpp, packed.data(), count, expected.data());
      CHECK(samples == expected);
    }
}
