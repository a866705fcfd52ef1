// A scan in C continues from flash after a power failure, and the store works as in C++.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <discmc/checkpoint_store.hpp>
#include <vector>

#include "oracle/c_events.hpp"
#include "oracle/simulated_flash.hpp"
#include "oracle/stream.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::Line;

namespace {

constexpr uint32_t size = 8;
constexpr FlashGeometry geometry{64, 1024, 10};

// A device that is all C. Its memories lie anyhow.
struct Device {
  Block encoder_memory{DISCMC_ENCODER_BYTES};
  Block extractor_memory{DISCMC_EXTRACTOR_BYTES(size, size, 50)};
  Block store_memory{DISCMC_STORE_BYTES(64)};
  discmc_encoder* encoder = nullptr;
  discmc_extractor* extractor = nullptr;
  discmc_store* store = nullptr;
  Line line;

  static discmc_memory in_c(Block& block) { return {block.memory().data, block.memory().bytes}; }
  discmc_encoder_config stream() {
    const ByteOutput output = line.output();
    return {&discmc_regions,
            {size, {0, 0, 0}, 0, 0},
            in_c(encoder_memory),
            {output.context, output.write, output.unsent, output.max_frame}};
  }
  discmc_extractor_config scan() {
    discmc_extractor_config config{};
    config.kind = &discmc_plain_u8;
    config.limits = {size, size, DISCMC_CLOSED};
    config.threshold = 1;
    config.memory = in_c(extractor_memory);
    config.sink = {encoder, discmc_encoder_accept};
    return config;
  }
  discmc_store_config flash(SimulatedFlash& simulated) {
    const FlashDevice device = simulated.device();
    return {device.context,
            device.read,
            device.program,
            device.erase,
            device.sync,
            device.geometry.program_bytes,
            device.geometry.block_bytes,
            device.geometry.blocks,
            static_cast<uint32_t>(encoder_memory.memory().bytes + extractor_memory.memory().bytes),
            in_c(store_memory)};
  }

  void start() {
    const discmc_encoder_config stream_config = stream();
    REQUIRE(discmc_encoder_start(&encoder, &stream_config) == DISCMC_OK);
    const discmc_extractor_config scan_config = scan();
    REQUIRE(discmc_extractor_start(&extractor, &scan_config) == DISCMC_OK);
  }
  void restore() {
    const discmc_memory parts[] = {in_c(encoder_memory), in_c(extractor_memory)};
    REQUIRE(discmc_store_restore(store, parts, 2) == DISCMC_OK);
    const discmc_encoder_config stream_config = stream();
    REQUIRE(discmc_encoder_restore(&encoder, &stream_config) == DISCMC_OK);
    const discmc_extractor_config scan_config = scan();
    REQUIRE(discmc_extractor_restore(&extractor, &scan_config) == DISCMC_OK);
  }
  uint32_t row() const {
    const discmc_extractor_info info = discmc_extractor_get_info(extractor);
    return info.slices * size + info.rows;
  }
  void scan_to(const BitVolume& volume, uint32_t end) {
    for (uint32_t i = row(); i < end; ++i)
      REQUIRE(discmc_extractor_push(extractor, DISCMC_U8, &volume.on[size_t{i} * size], size, 1)
                  .status == DISCMC_OK);
  }
  discmc_status save() {
    discmc_memory parts[2];
    REQUIRE(discmc_encoder_save(encoder, &parts[0]) == DISCMC_OK);
    REQUIRE(discmc_extractor_save(extractor, &parts[1]) == DISCMC_OK);
    return completed(discmc_store_save(store, parts, 2),
                     [this] { return discmc_store_resume(store); });
  }
};

}  // namespace

TEST_CASE("a scan in C continues from a checkpoint in flash with the same bytes") {
  const BitVolume volume = random({size, size, size}, 128, 1);
  Device whole;
  whole.start();
  whole.scan_to(volume, size * size);
  REQUIRE(discmc_extractor_finish(whole.extractor) == DISCMC_OK);

  SimulatedFlash flash(geometry);
  Device first;
  const discmc_store_config config = first.flash(flash);
  REQUIRE(discmc_store_start(&first.store, &config) == DISCMC_OK);
  CHECK(discmc_store_get_info(first.store).has_checkpoint == 0);
  first.start();
  first.scan_to(volume, 21);
  REQUIRE(first.save() == DISCMC_OK);
  first.scan_to(volume, 37);
  CHECK(discmc_store_erase_ahead(first.store, config.max_bytes) == DISCMC_SUSPENDED);
  REQUIRE(first.save() == DISCMC_OK);
  first.scan_to(volume, 50);
  flash.cut_after(1500);
  CHECK(first.save() == DISCMC_DEVICE_ERROR);
  flash.power_on();

  Device second;
  const discmc_store_config again = second.flash(flash);
  REQUIRE(discmc_store_start(&second.store, &again) == DISCMC_OK);
  const discmc_store_info info = discmc_store_get_info(second.store);
  CHECK(info.has_checkpoint == 1);
  CHECK(info.sequence == 2);
  CHECK(info.bytes <= config.max_bytes);
  second.restore();
  CHECK(second.row() == 37);
  test::Bytes stream = first.line.bytes;
  stream.resize(discmc_encoder_stream_bytes(second.encoder));
  second.scan_to(volume, size * size);
  REQUIRE(discmc_extractor_finish(second.extractor) == DISCMC_OK);
  stream.insert(stream.end(), second.line.bytes.begin(), second.line.bytes.end());
  CHECK(stream == whole.line.bytes);
  CHECK((second.encoder_memory.is_intact() && second.extractor_memory.is_intact() &&
         second.store_memory.is_intact()));
  CHECK(!flash.has_broken_rules);
}

TEST_CASE("the info of a store in C contains the plan of the C++ store") {
  for (const FlashGeometry& any : {geometry, FlashGeometry{256, 131072, 4}}) {
    SimulatedFlash flash(any);
    std::vector<uint8_t> memory(DISCMC_STORE_BYTES(any.program_bytes));
    Device device;
    discmc_store_config config = device.flash(flash);
    config.max_bytes = 3000;
    config.memory = {memory.data(), memory.size()};
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

TEST_CASE("errors of stores in C") {
  SimulatedFlash flash(geometry);
  Device device;
  discmc_store_config config = device.flash(flash);
  const discmc_memory parts[DISCMC_MAX_PARTS + 1] = {};
  --config.memory.bytes;
  CHECK(discmc_store_start(&device.store, &config) == DISCMC_TOO_LITTLE_MEMORY);
  ++config.memory.bytes;
  discmc_store_config without_memory = config;
  without_memory.memory.data = nullptr;
  CHECK(discmc_store_start(&device.store, &without_memory) == DISCMC_TOO_LITTLE_MEMORY);
  config.blocks = 1;
  CHECK(discmc_store_start(&device.store, &config) == DISCMC_BAD_DEVICE);
  CHECK(device.store == nullptr);
  config.blocks = geometry.blocks;
  flash.fail_call(0);
  CHECK(discmc_store_start(&device.store, &config) == DISCMC_DEVICE_ERROR);
  REQUIRE(device.store != nullptr);
  CHECK(discmc_store_restore(device.store, parts, 1) == DISCMC_BAD_CHECKPOINT);
  CHECK(discmc_store_restore(device.store, parts, DISCMC_MAX_PARTS + 1) == DISCMC_BAD_CHECKPOINT);
  CHECK(discmc_store_save(device.store, parts, DISCMC_MAX_PARTS + 1) == DISCMC_TOO_LITTLE_MEMORY);
}
