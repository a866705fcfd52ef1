// The store works in C as in C++; properties/power_failure_test saves scans in C.
#include <discmc/discmc.h>

#include <discmc/checkpoint_store.hpp>

#include "oracle/c_events.hpp"
#include "oracle/scan.hpp"
#include "oracle/simulated_flash.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr FlashGeometry geometry{64, 1024, 10};

discmc_store_config config_of(SimulatedFlash& simulated, Block& memory, uint32_t max_bytes) {
  const FlashDevice device = simulated.device();
  return {device.context,
          device.read,
          device.program,
          device.erase,
          device.sync,
          device.geometry.program_bytes,
          device.geometry.block_bytes,
          device.geometry.blocks,
          max_bytes,
          {memory.memory().data, memory.memory().bytes}};
}

// Saves two parts, each filled with one byte value.
discmc_status save(discmc_store* store, uint8_t byte) {
  std::vector<uint8_t> first(900, byte), second(300, byte);
  const discmc_memory parts[] = {{first.data(), first.size()}, {second.data(), second.size()}};
  return completed(discmc_store_save(store, parts, 2),
                   [store] { return discmc_store_resume(store); });
}

}  // namespace

TEST_CASE("a store in C restores the newest whole checkpoint after a power failure") {
  SimulatedFlash flash(geometry);
  Block memory(DISCMC_STORE_BYTES(64));
  const discmc_store_config config = config_of(flash, memory, 1200);
  discmc_store* store = nullptr;
  REQUIRE(discmc_store_start(&store, &config) == DISCMC_OK);
  CHECK(discmc_store_get_info(store).has_checkpoint == 0);
  REQUIRE(save(store, 1) == DISCMC_OK);
  CHECK(discmc_store_erase_ahead(store, config.max_bytes) == DISCMC_SUSPENDED);
  REQUIRE(save(store, 2) == DISCMC_OK);
  flash.cut_after(500);
  CHECK(save(store, 3) == DISCMC_DEVICE_ERROR);
  flash.power_on();

  REQUIRE(discmc_store_start(&store, &config) == DISCMC_OK);
  const discmc_store_info info = discmc_store_get_info(store);
  CHECK(info.has_checkpoint == 1);
  CHECK(info.sequence == 2);
  CHECK(info.bytes == 1200);
  std::vector<uint8_t> first(900), second(300);
  const discmc_memory parts[] = {{first.data(), first.size()}, {second.data(), second.size()}};
  REQUIRE(discmc_store_restore(store, parts, 2) == DISCMC_OK);
  CHECK(first == std::vector<uint8_t>(900, 2));
  CHECK(second == std::vector<uint8_t>(300, 2));
  const discmc_status discarded =
      completed(discmc_store_discard(store), [store] { return discmc_store_resume(store); });
  CHECK(discarded == DISCMC_OK);
  CHECK(discmc_store_get_info(store).has_checkpoint == 0);
  CHECK(memory.is_intact());
  CHECK(!flash.has_broken_rules);
}

TEST_CASE("the info of a store in C contains the plan of the C++ store") {
  for (const FlashGeometry& any : {geometry, FlashGeometry{256, 131072, 4}}) {
    SimulatedFlash flash(any);
    Block memory(DISCMC_STORE_BYTES(any.program_bytes));
    const discmc_store_config config = config_of(flash, memory, 3000);
    discmc_store* store = nullptr;
    REQUIRE(discmc_store_start(&store, &config) == DISCMC_OK);
    const StorePlan plan = store_plan(any, 3000);
    const discmc_store_info info = discmc_store_get_info(store);
    CHECK(info.slots == plan.slots);
    CHECK(info.slots_per_block == plan.slots_per_block);
    CHECK(info.blocks == plan.blocks(3000));
    CHECK(info.units == plan.units(3000));
  }
}

TEST_CASE("invalid calls of stores in C return their status") {
  SimulatedFlash flash(geometry);
  Block memory(DISCMC_STORE_BYTES(64));
  discmc_store_config config = config_of(flash, memory, 1200);
  discmc_store* store = nullptr;
  const discmc_memory parts[DISCMC_MAX_PARTS + 1] = {};
  --config.memory.bytes;
  CHECK(discmc_store_start(&store, &config) == DISCMC_TOO_LITTLE_MEMORY);
  ++config.memory.bytes;
  discmc_store_config without_memory = config;
  without_memory.memory.data = nullptr;
  CHECK(discmc_store_start(&store, &without_memory) == DISCMC_TOO_LITTLE_MEMORY);
  config.blocks = 1;
  CHECK(discmc_store_start(&store, &config) == DISCMC_BAD_DEVICE);
  CHECK(store == nullptr);
  config.blocks = geometry.blocks;
  flash.fail_call(0);
  CHECK(discmc_store_start(&store, &config) == DISCMC_DEVICE_ERROR);
  REQUIRE(store != nullptr);
  CHECK(discmc_store_restore(store, parts, 1) == DISCMC_BAD_CHECKPOINT);
  CHECK(discmc_store_restore(store, parts, DISCMC_MAX_PARTS + 1) == DISCMC_BAD_CHECKPOINT);
  CHECK(discmc_store_save(store, parts, DISCMC_MAX_PARTS + 1) == DISCMC_TOO_LITTLE_MEMORY);
}
