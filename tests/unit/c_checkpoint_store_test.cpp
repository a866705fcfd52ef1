// A scan through C goes on from flash; the C functions do what the C++ functions do.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <discmc/checkpoint_store.hpp>
#include <vector>

#include "oracle/simulated_flash.hpp"
#include "oracle/volume.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr uint32_t size = 8;
constexpr FlashGeometry geometry{64, 1024, 10};

size_t append(void* context, const uint8_t* bytes, size_t count) {
  auto& stream = *static_cast<std::vector<uint8_t>*>(context);
  stream.insert(stream.end(), bytes, bytes + count);
  return count;
}

discmc_flash_device in_c(const FlashDevice& device) {
  return {device.context,
          device.read,
          device.program,
          device.erase,
          device.sync,
          {device.geometry.program_bytes, device.geometry.block_bytes, device.geometry.blocks}};
}

/// A device that is all C.
struct DeviceInC {
  discmc_extractor extractor = {{0}};
  discmc_encoder encoder = {{0}};
  discmc_extractor_checkpoint scan = {};
  discmc_encoder_checkpoint stream = {};
  alignas(4) uint8_t memory[DISCMC_MINIMUM_BYTES(size, size) + 400] = {};
  std::vector<uint8_t> bytes;

  discmc_sink sink() { return {&encoder, discmc_encoder_take}; }
  discmc_byte_output output() { return {&bytes, append}; }

  void start() {
    const discmc_stream_label label = {size, {0, 0, 0}, 0, 0};
    const discmc_limits limits = {size, size, DISCMC_CLOSED, {0, 0, 0}};
    const discmc_sink to = sink();
    REQUIRE(discmc_encoder_start(&encoder, &label, output()) == DISCMC_OK);
    REQUIRE(discmc_extractor_start(&extractor, &limits, nullptr, 1, {memory, sizeof memory}, &to) ==
            DISCMC_OK);
  }
  void scan_to(const BitVolume& volume, uint32_t end) {
    uint32_t row = discmc_extractor_slices(&extractor) * size + discmc_extractor_rows(&extractor);
    for (; row < end; ++row)
      REQUIRE(discmc_extractor_push_u8(&extractor, &volume.on[row * size], size, 1).status ==
              DISCMC_OK);
  }
  discmc_status save(discmc_checkpoint_store& store) {
    REQUIRE(discmc_extractor_save(&extractor, &scan) == DISCMC_OK);
    REQUIRE(discmc_encoder_save(&encoder, &stream) == DISCMC_OK);
    const discmc_memory parts[] = {{&scan, sizeof scan},
                                   {&stream, sizeof stream},
                                   {memory, discmc_extractor_bytes_used(&extractor)}};
    discmc_status status = discmc_checkpoint_store_save(&store, parts, 3);
    while (status == DISCMC_MORE) status = discmc_checkpoint_store_resume(&store);
    return status;
  }
  discmc_status restore(discmc_checkpoint_store& store) {
    const discmc_memory parts[] = {
        {&scan, sizeof scan}, {&stream, sizeof stream}, {memory, sizeof memory}};
    const discmc_sink to = sink();
    REQUIRE(discmc_checkpoint_store_restore(&store, parts, 3) == DISCMC_OK);
    REQUIRE(discmc_encoder_restore(&encoder, &stream, output()) == DISCMC_OK);
    return discmc_extractor_restore(&extractor, &scan, {memory, sizeof memory}, &to);
  }
};

constexpr uint32_t most_bytes = sizeof(discmc_extractor_checkpoint) +
                                sizeof(discmc_encoder_checkpoint) + sizeof DeviceInC::memory;

}  // namespace

TEST_CASE("a scan goes on from flash through C") {
  const BitVolume volume = random({size, size, size}, 128, 1);
  DeviceInC whole;
  whole.start();
  whole.scan_to(volume, size * size);
  REQUIRE(discmc_extractor_finish(&whole.extractor) == DISCMC_OK);

  SimulatedFlash flash(geometry);
  const discmc_flash_device device = in_c(flash.device());
  uint8_t buffer[64];
  discmc_checkpoint_store store = {{0}};
  CHECK(discmc_checkpoint_store_resume(&store) == DISCMC_NOT_STARTED);
  CHECK(discmc_checkpoint_store_start(&store, &device, most_bytes, {buffer, 63}) ==
        DISCMC_TOO_LITTLE_MEMORY);
  REQUIRE(discmc_checkpoint_store_start(&store, &device, most_bytes, {buffer, 64}) == DISCMC_OK);
  CHECK(discmc_checkpoint_store_has_checkpoint(&store) == 0);
  DeviceInC first;
  first.start();
  first.scan_to(volume, 21);
  REQUIRE(first.save(store) == DISCMC_OK);
  first.scan_to(volume, 37);
  CHECK(discmc_checkpoint_store_erase_ahead(&store, most_bytes) == DISCMC_MORE);
  REQUIRE(first.save(store) == DISCMC_OK);
  first.scan_to(volume, 50);
  flash.cut_after(1500);
  CHECK(first.save(store) == DISCMC_DEVICE_ERROR);
  flash.power_on();

  discmc_checkpoint_store found = {{0}};
  REQUIRE(discmc_checkpoint_store_start(&found, &device, most_bytes, {buffer, 64}) == DISCMC_OK);
  CHECK(discmc_checkpoint_store_has_checkpoint(&found) == 1);
  CHECK(discmc_checkpoint_store_sequence(&found) == 2);
  CHECK(discmc_checkpoint_store_bytes(&found) <= most_bytes);
  DeviceInC second;
  REQUIRE(second.restore(found) == DISCMC_OK);
  CHECK(discmc_extractor_slices(&second.extractor) * size +
            discmc_extractor_rows(&second.extractor) ==
        37);
  std::vector<uint8_t> stream = first.bytes;
  stream.resize(discmc_encoder_bytes(&second.encoder));
  second.scan_to(volume, size * size);
  REQUIRE(discmc_extractor_finish(&second.extractor) == DISCMC_OK);
  stream.insert(stream.end(), second.bytes.begin(), second.bytes.end());
  CHECK(stream == whole.bytes);

  const discmc_memory parts[5] = {};
  CHECK(discmc_checkpoint_store_save(&found, parts, 5) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_checkpoint_store_restore(&found, parts, 5) == DISCMC_BAD_CHECKPOINT);
}

TEST_CASE("a plan is the same in C") {
  for (const FlashGeometry& any : {geometry, FlashGeometry{256, 131072, 4}}) {
    const discmc_flash_geometry given = {any.program_bytes, any.block_bytes, any.blocks};
    const StorePlan plan = store_plan(any, 3000);
    const discmc_store_plan in_c = discmc_store_plan_for(&given, 3000);
    CHECK(in_c.slots == plan.slots);
    CHECK(in_c.slots_per_block == plan.slots_per_block);
    CHECK(in_c.blocks == plan.blocks(3000));
    CHECK(in_c.units == plan.units(3000));
  }
  const discmc_flash_geometry small = {64, 1024, 5};
  const discmc_store_plan none = discmc_store_plan_for(&small, 3000);
  CHECK(none.slots + none.slots_per_block + none.blocks + none.units == 0);
}
