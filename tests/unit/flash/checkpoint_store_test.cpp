// Checkpoints in flash: whenever the power fails, the newest complete one is found.
#include <discmc/checkpoint_store.hpp>
#include <discmc/stream/crc32.hpp>

#include "oracle/checkpointed_device.hpp"
#include "oracle/simulated_flash.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::SimulatedFlash;
using reference::step;

namespace {

using Kind = SimulatedFlash::Kind;

struct Memories {
  const char* name;
  FlashGeometry geometry;
  Kind kind = Kind::flash;
};

/// For checkpoints of 1,200 bytes.
constexpr Memories memories[] = {
    {"two slots of five blocks", {64, 256, 10}},
    {"three slots of two blocks, and a block to spare", {32, 1024, 7}},
    {"a slot a block", {256, 2048, 2}},
    {"three slots a block", {16, 4096, 2}},
    {"no erasing", {16, 1536, 3}, Kind::fram},
};
constexpr uint32_t max_bytes = 1200;

/// A store and its buffer.
struct Keeper {
  CheckpointStore store{};
  std::vector<uint8_t> buffer;

  explicit Keeper(SimulatedFlash& flash, uint32_t most = max_bytes)
      : buffer(flash.device().geometry.program_bytes) {
    status = start(flash.device(), most);
  }

  Status start(const FlashDevice& device, uint32_t most = max_bytes) {
    return store.start(device, most, {buffer.data(), buffer.size()});
  }

  Status finish(Status last) {
    while (last == Status::suspended) last = store.resume();
    return last;
  }
  Status save(const std::vector<Memory>& parts) {
    return finish(store.save(parts.data(), static_cast<uint32_t>(parts.size())));
  }
  Status restore(const std::vector<Memory>& parts) {
    return store.restore(parts.data(), static_cast<uint32_t>(parts.size()));
  }

  Status status;
};

/// Calls check(flash, store, kind) for each kind of memory. Checks that the rules of its use hold.
template <class Check>
void for_each_memory(Check check) {
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    SimulatedFlash flash(memory.geometry, 1, memory.kind);
    Keeper keeper(flash);
    check(flash, keeper, memory);
    CHECK_FALSE(flash.has_broken_rules);
  }
}

/// The saved parts: three, of which the last grows.
class Contents {
 public:
  explicit Contents(uint32_t number = 0) : bytes_(400 + 173 * number % 700, 0xFF) {
    for (size_t i = 0; i < bytes_.size(); i += 1 + i % 3)
      bytes_[i] = static_cast<uint8_t>(i * (number + 1) + number);
  }
  std::vector<Memory> parts() {
    return {{bytes_.data(), 24}, {bytes_.data() + 24, 101}, {bytes_.data() + 125, left()}};
  }
  /// The parts as stored in flash: lengths, then bytes.
  std::vector<uint8_t> stored() {
    std::vector<uint8_t> bytes(StorePlan::max_parts * sizeof(uint32_t));
    for (size_t i = 0; i < parts().size(); ++i) {
      const auto length = static_cast<uint32_t>(parts()[i].bytes);
      std::memcpy(&bytes[4 * i], &length, sizeof length);
    }
    bytes.insert(bytes.end(), bytes_.begin(), bytes_.end());
    return bytes;
  }
  uint32_t bytes() const { return static_cast<uint32_t>(bytes_.size()); }
  bool operator==(const Contents& other) const { return bytes_ == other.bytes_; }

  static Contents of(Keeper& keeper) {
    Contents read;
    read.bytes_.assign(max_bytes, 0xA5);
    REQUIRE(keeper.restore(read.parts()) == Status::ok);
    CHECK(std::all_of(read.bytes_.begin() + keeper.store.bytes(), read.bytes_.end(),
                      [](uint8_t byte) { return byte == 0xA5; }));
    read.bytes_.resize(keeper.store.bytes());
    return read;
  }

 private:
  size_t left() const { return bytes_.size() - 125; }
  std::vector<uint8_t> bytes_;
};

Status save(Keeper& keeper, uint32_t number) {
  return keeper.save(Contents(number).parts());
}

// Saves the numbers below `end`.
void save_all(Keeper& keeper, uint32_t end) {
  for (uint32_t number = 0; number < end; ++number) REQUIRE(save(keeper, number) == Status::ok);
}

/// Returns the number whose contents the store finds; UINT32_MAX if it finds none.
uint32_t number_found(SimulatedFlash& flash, uint32_t limit) {
  Keeper keeper(flash);
  REQUIRE(keeper.status == Status::ok);
  if (!keeper.store.has_checkpoint()) return UINT32_MAX;
  const Contents found = Contents::of(keeper);
  for (uint32_t number = 0; number < limit; ++number)
    if (found == Contents(number)) return number;
  FAIL("contents that were never saved");
  return UINT32_MAX;
}

/// Returns the flash slot of a checkpoint, as its bytes in a flash.
uint8_t* slot(SimulatedFlash& flash, const StorePlan& plan, uint32_t number) {
  const uint32_t block = number / plan.slots_per_block * plan.blocks_per_slot;
  return flash.bytes.data() + size_t{block} * plan.geometry.block_bytes +
         size_t{number % plan.slots_per_block} * plan.slot_units * plan.geometry.program_bytes;
}

/// Writes a flash slot by hand, in the format that the header describes.
void put_slot(uint8_t* bytes, uint32_t sequence, Contents contents,
              uint32_t format = StoredHead::current_format) {
  StoredHead head{format, sequence, contents.bytes(), 0};
  const auto* const in_memory = reinterpret_cast<const uint8_t*>(&head);
  head.checksum = crc32(in_memory, 12);
  std::copy_n(in_memory, sizeof head, bytes);
  const std::vector<uint8_t> data = contents.stored();
  std::copy(data.begin(), data.end(), bytes + sizeof head);
  const uint32_t checksum = crc32(data.data(), data.size(), head.checksum);
  std::memcpy(bytes + sizeof head + data.size(), &checksum, sizeof checksum);
}

}  // namespace

TEST_CASE("the newest checkpoint is read back after any number of saves") {
  for_each_memory([&](SimulatedFlash& flash, Keeper& keeper, const Memories&) {
    REQUIRE(keeper.status == Status::ok);
    CHECK_FALSE(keeper.store.has_checkpoint());
    CHECK(keeper.store.bytes() == 0);
    for (uint32_t number = 0; number < 20; ++number) {
      REQUIRE(save(keeper, number) == Status::ok);
      CHECK(keeper.store.sequence() == number + 1);
      CHECK(keeper.store.bytes() == Contents(number).bytes());
      CHECK(Contents::of(keeper) == Contents(number));
      CHECK(number_found(flash, 20) == number);
    }
  });
}

TEST_CASE("an erased, zeroed or random flash has no checkpoint") {
  for (const Memories& memory : memories) {
    SimulatedFlash flash(memory.geometry);
    CHECK(number_found(flash, 1) == UINT32_MAX);
    for (const uint8_t filling : {uint8_t{0x00}, uint8_t{0xFF}}) {
      std::fill(flash.bytes.begin(), flash.bytes.end(), filling);
      CHECK(number_found(flash, 1) == UINT32_MAX);
    }
  }
}

TEST_CASE("after a power failure the newest or the previous checkpoint is found") {
  constexpr uint32_t saves = 4;
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    // The steps after which each save is complete.
    std::vector<uint64_t> complete;
    SimulatedFlash whole(memory.geometry, 1, memory.kind);
    Keeper never_cut(whole);
    for (uint32_t number = 0; number < saves; ++number) {
      REQUIRE(save(never_cut, number) == Status::ok);
      complete.push_back(whole.steps);
    }
    for (uint64_t cut = 1; cut <= whole.steps; cut += step(29)) {
      CAPTURE(cut);
      SimulatedFlash flash(memory.geometry, static_cast<uint32_t>(cut), memory.kind);
      flash.cut_after(cut);
      Keeper keeper(flash);
      uint32_t saved = 0;
      while (saved < saves && save(keeper, saved) == Status::ok) ++saved;
      REQUIRE(saved < saves);
      REQUIRE(saved == std::count_if(complete.begin(), complete.end(),
                                     [cut](uint64_t steps) { return steps < cut; }));
      flash.power_on();
      // If only 1 bits were left to program, the interrupted checkpoint is complete.
      const uint32_t found = number_found(flash, saves);
      REQUIRE((found == saved || found + 1 == saved));
      REQUIRE_FALSE(flash.has_broken_rules);
    }
  }
}

TEST_CASE("after repeated power failures the newest or the interrupted checkpoint is found") {
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    SimulatedFlash flash(memory.geometry, 5, memory.kind);
    std::minstd_rand random(7);
    uint32_t next = 0, newest = UINT32_MAX;
    for (uint32_t failure = 0; failure < 200 / step(10); ++failure) {
      CAPTURE(failure);
      flash.power_on();
      const uint32_t found = number_found(flash, next + 1);
      REQUIRE((found == newest || found == next));
      if (found == next && found != newest) newest = next++;
      flash.cut_after(1 + random() % 6000);
      Keeper keeper(flash);
      for (;;) {
        for (Status status = Status::suspended; status == Status::suspended && random() % 4 != 0;)
          status = keeper.store.erase_ahead(Contents(next).bytes());
        if (save(keeper, next) != Status::ok) break;
        newest = next++;
      }
    }
    CHECK(next > 50 / step(10));
    CHECK_FALSE(flash.has_broken_rules);
  }
}

TEST_CASE("a flipped bit in one checkpoint leaves other checkpoints readable") {
  SimulatedFlash flash(memories[2].geometry);
  Keeper keeper(flash);
  save_all(keeper, 2);
  for (const uint32_t flipped : {0U, 1U}) {
    const size_t bytes = StorePlan::head_bytes + Contents(flipped).bytes() + StorePlan::tail_bytes;
    for (size_t bit = 0; bit < 8 * bytes; bit += step(13)) {
      CAPTURE(bit);
      uint8_t& byte = slot(flash, keeper.store.plan(), flipped)[bit / 8];
      byte = static_cast<uint8_t>(byte ^ 1 << bit % 8);
      REQUIRE(number_found(flash, 2) == 1 - flipped);
      byte = static_cast<uint8_t>(byte ^ 1 << bit % 8);
    }
  }
  CHECK(number_found(flash, 2) == 1);
}

TEST_CASE("each call of save() or resume() erases one block or programs one unit") {
  for_each_memory([&](SimulatedFlash& flash, Keeper& keeper, const Memories&) {
    for (uint32_t number = 0; number < 7; ++number) {
      Contents contents(number);
      const auto parts = contents.parts();
      uint64_t before = 0, saved = flash.units;
      const auto did = [&] {
        return flash.units + std::accumulate(flash.erasures.begin(), flash.erasures.end(), 0U);
      };
      before = did();
      Status status = keeper.store.save(parts.data(), 3);
      for (; status == Status::suspended; status = keeper.store.resume()) {
        CHECK(did() <= before + 1);
        before = did();
      }
      REQUIRE(status == Status::ok);
      CHECK(did() == before + 1);
      CHECK(flash.units - saved == keeper.store.plan().units(contents.bytes()));
      CHECK(keeper.store.resume() == Status::ok);
      CHECK(did() == before + 1);
    }
  });
}

TEST_CASE("only blocks in use are erased, and all blocks wear equally") {
  const FlashGeometry geometry{64, 256, 10};
  SimulatedFlash flash(geometry);
  Keeper keeper(flash);
  Contents small(0);  // 400 bytes: two of the five blocks
  REQUIRE(keeper.save(small.parts()) == Status::ok);
  CHECK(keeper.store.plan().blocks(small.bytes()) == 2);
  CHECK(flash.erasures == std::vector<uint32_t>{1, 1, 0, 0, 0, 0, 0, 0, 0, 0});

  for (const Memories& memory : memories) {
    if (memory.kind == Kind::fram) continue;
    CAPTURE(memory.name);
    SimulatedFlash worn(memory.geometry);
    Keeper wearing(worn);
    std::vector<uint8_t> all(max_bytes);
    const StorePlan& plan = wearing.store.plan();
    for (uint64_t i = 0; i < 3 * plan.slots; ++i)
      REQUIRE(wearing.save({{all.data(), all.size()}}) == Status::ok);
    const uint32_t used = plan.slots / plan.slots_per_block * plan.blocks_per_slot;
    for (uint32_t block = 0; block < memory.geometry.blocks; ++block)
      CHECK(worn.erasures[block] == (block < used ? 3 : 0));
  }
}

TEST_CASE("blocks erased ahead are not erased a second time") {
  for_each_memory([&](SimulatedFlash& flash, Keeper& keeper, const Memories& memory) {
    if (memory.kind == Kind::fram) return;
    const auto erasures = [&flash] {
      return std::accumulate(flash.erasures.begin(), flash.erasures.end(), 0U);
    };
    for (uint32_t number = 0; number < 8; ++number) {
      const uint32_t bytes = Contents(number).bytes();
      const uint32_t before = erasures();
      const bool is_first = number % keeper.store.plan().slots_per_block == 0;
      const uint32_t blocks = is_first ? keeper.store.plan().blocks(bytes) : 0;
      for (uint32_t block = 1; block < blocks; ++block)
        REQUIRE(keeper.store.erase_ahead(bytes) == Status::suspended);
      REQUIRE(keeper.store.erase_ahead(bytes) == Status::ok);
      REQUIRE(keeper.store.erase_ahead(bytes) == Status::ok);
      CHECK(erasures() == before + blocks);
      if (number > 0) CHECK(number_found(flash, 8) == number - 1);
      REQUIRE(save(keeper, number) == Status::ok);
      CHECK(erasures() == before + blocks);
    }
  });
}

TEST_CASE("blocks wear equally even if every checkpoint follows a start") {
  SimulatedFlash flash(memories[1].geometry);
  std::vector<uint8_t> all(max_bytes);
  for (uint32_t number = 0; number < 6; ++number)
    REQUIRE(Keeper(flash).save({{all.data(), all.size()}}) == Status::ok);
  CHECK(flash.erasures == std::vector<uint32_t>{2, 2, 2, 2, 2, 2, 0});
}

TEST_CASE("the rest of the last programmed unit is filled with ones") {
  SimulatedFlash flash(memories[2].geometry);
  Keeper keeper(flash);
  uint8_t bytes[300] = {};
  REQUIRE(keeper.save({memory_of(bytes)}) == Status::ok);
  const uint8_t* const first = slot(flash, keeper.store.plan(), 0);
  CHECK(std::all_of(first + StorePlan::head_bytes + 300 + StorePlan::tail_bytes, first + 512,
                    [](uint8_t byte) { return byte == 0xFF; }));
}

TEST_CASE("a store restarted with another flash forgets the first flash") {
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    SimulatedFlash first(memory.geometry, 1, memory.kind), other(memory.geometry, 2, memory.kind);
    Keeper keeper(first);
    save_all(keeper, 3);
    first.fail_call(0);
    REQUIRE(keeper.restore(Contents(2).parts()) == Status::device_error);
    Contents contents(3);
    const auto parts = contents.parts();
    REQUIRE(keeper.store.save(parts.data(), 3) == Status::suspended);
    REQUIRE(keeper.start(other.device()) == Status::ok);
    CHECK_FALSE(keeper.store.has_checkpoint());
    CHECK(keeper.store.bytes() == 0);
    CHECK(keeper.store.sequence() == 0);
    CHECK(keeper.restore(Contents(2).parts()) == Status::bad_checkpoint);
    CHECK(keeper.store.resume() == Status::ok);
    CHECK(other.units == 0);
    REQUIRE(save(keeper, 4) == Status::ok);
    CHECK(keeper.store.sequence() == 1);
    if (memory.kind == Kind::flash) CHECK(other.erasures[0] == 1);
    CHECK(number_found(other, 5) == 4);
    CHECK_FALSE(other.has_broken_rules);
  }
}

TEST_CASE("the first checkpoint after a start goes to an unused slot") {
  SimulatedFlash flash(memories[3].geometry);
  for (uint32_t number = 0; number < 6; ++number) {
    Keeper keeper(flash);
    REQUIRE(save(keeper, number) == Status::ok);
    CHECK(number_found(flash, 6) == number);
  }
  CHECK(flash.erasures == std::vector<uint32_t>{3, 3});
  CHECK_FALSE(flash.has_broken_rules);
}

TEST_CASE("a failed device call is reported and preserves older checkpoints") {
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    SimulatedFlash whole(memory.geometry, 3, memory.kind);
    Keeper never_failing(whole);
    save_all(never_failing, 3);
    const uint64_t before = whole.calls;
    REQUIRE(save(never_failing, 3) == Status::ok);
    for (uint64_t call = 0; call < whole.calls - before; ++call) {
      CAPTURE(call);
      SimulatedFlash flash(memory.geometry, 3, memory.kind);
      Keeper keeper(flash);
      save_all(keeper, 3);
      flash.fail_call(call);
      REQUIRE(save(keeper, 3) == Status::device_error);
      CHECK(keeper.store.sequence() == 3);
      const uint32_t found = number_found(flash, 4);
      CHECK((found == 2 || found == 3));  // everything is written when a sync fails
      CHECK(keeper.store.resume() == Status::ok);
      REQUIRE(save(keeper, 4) == Status::ok);
      CHECK(number_found(flash, 5) == 4);
      CHECK_FALSE(flash.has_broken_rules);
    }
    SimulatedFlash flash(memory.geometry, 3, memory.kind);
    if (memory.kind == Kind::fram) continue;
    Keeper keeper(flash);
    save_all(keeper, 3);
    flash.fail_call(0);
    CHECK(keeper.store.erase_ahead(max_bytes) == Status::device_error);
    CHECK(number_found(flash, 3) == 2);
    REQUIRE(save(keeper, 3) == Status::ok);
    CHECK(number_found(flash, 4) == 3);
  }
}

TEST_CASE("after a failed save the newest checkpoint remains until the next save is complete") {
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    for (uint32_t saved = 1; saved <= 6; ++saved) {
      CAPTURE(saved);
      SimulatedFlash flash(memory.geometry, 1, memory.kind);
      Keeper keeper(flash);
      save_all(keeper, saved);
      flash.fail_call(0);
      REQUIRE(save(keeper, saved) == Status::device_error);
      Contents contents(saved + 1);
      const auto parts = contents.parts();
      Status status = keeper.store.save(parts.data(), 3);
      for (; status == Status::suspended; status = keeper.store.resume())
        REQUIRE(number_found(flash, saved) == saved - 1);
      REQUIRE(status == Status::ok);
      CHECK(number_found(flash, saved + 2) == saved + 1);
    }
  }
}

TEST_CASE("an older checkpoint of the same size does not complete an interrupted save") {
  constexpr uint32_t same_size = 700;  // two numbers with this difference
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    for (uint32_t call = 0;; ++call) {
      CAPTURE(call);
      SimulatedFlash flash(memory.geometry, 1, memory.kind);
      Keeper keeper(flash);
      const uint32_t saves = keeper.store.plan().slots;
      for (uint32_t i = 0; i < saves; ++i) REQUIRE(save(keeper, i * same_size) == Status::ok);
      flash.fail_call(call);
      if (save(keeper, saves * same_size) == Status::ok) break;
      Keeper restarted(flash);
      const Contents found = Contents::of(restarted);
      // A save whose last read or sync fails may be complete.
      const bool is_newest = found == Contents(saves * same_size);
      REQUIRE((is_newest || found == Contents((saves - 1) * same_size)));
    }
  }
}

TEST_CASE("an error of the driver is reported even if the data was written") {
  SimulatedFlash flash(memories[2].geometry);
  FlashDevice device = flash.device();
  static const auto program = device.program;
  device.program = [](void* context, uint32_t block, uint32_t offset, const void* buffer,
                      uint32_t count) {
    (void)program(context, block, offset, buffer, count);
    return -1;
  };
  Keeper keeper(flash);
  REQUIRE(keeper.start(device) == Status::ok);
  CHECK(save(keeper, 0) == Status::device_error);
}

TEST_CASE("a unit that fails to program is detected, and other blocks are used instead") {
  const FlashGeometry geometry{64, 512, 9};  // three slots
  SimulatedFlash flash(geometry);
  Keeper keeper(flash);
  REQUIRE(save(keeper, 0) == Status::ok);
  flash.wear_out(3 * 512 / 64 + 2);  // in the second slot
  CHECK(save(keeper, 1) == Status::device_error);
  CHECK(number_found(flash, 2) == 0);
  CHECK(save(keeper, 2) == Status::ok);
  CHECK(number_found(flash, 3) == 2);
  CHECK(save(keeper, 3) == Status::ok);
  CHECK(save(keeper, 4) == Status::device_error);
  CHECK(number_found(flash, 5) == 3);
  CHECK_FALSE(flash.has_broken_rules);
}

TEST_CASE("an interrupted save leaves the previous checkpoint readable") {
  for_each_memory([&](SimulatedFlash& flash, Keeper& keeper, const Memories&) {
    REQUIRE(save(keeper, 0) == Status::ok);
    for (uint32_t steps = 0; steps < 4; ++steps) {
      CAPTURE(steps);
      Contents contents(3);
      const auto parts = contents.parts();
      Status status = keeper.store.save(parts.data(), 3);
      for (uint32_t i = 0; i < steps; ++i) status = keeper.store.resume();
      REQUIRE(status == Status::suspended);
      CHECK(number_found(flash, 4) == 0);
      if (steps % 2 == 0) {
        CHECK(Contents::of(keeper) == Contents(0));
        CHECK(keeper.store.resume() == Status::ok);
      }
    }
    REQUIRE(save(keeper, 2) == Status::ok);
    CHECK(number_found(flash, 3) == 2);
  });
}

TEST_CASE("the newest checkpoint is found even after sequence numbers wrap to 0") {
  SimulatedFlash flash(memories[1].geometry);
  const StorePlan plan = store_plan(memories[1].geometry, max_bytes);
  put_slot(slot(flash, plan, 1), UINT32_MAX - 1, Contents(1));
  put_slot(slot(flash, plan, 0), UINT32_MAX - 2, Contents(0));
  for (uint32_t number = 2; number < 8; ++number) {
    CHECK(number_found(flash, 8) == number - 1);
    Keeper keeper(flash);
    REQUIRE(save(keeper, number) == Status::ok);
    CHECK(keeper.store.sequence() == UINT32_MAX - 2 + number);
  }
  CHECK(number_found(flash, 8) == 7);
}

TEST_CASE("the sequence number of a damaged checkpoint is not reused") {
  SimulatedFlash flash(memories[1].geometry);
  {
    Keeper keeper(flash);
    save_all(keeper, 3);
    slot(flash, keeper.store.plan(), 2)[100] ^= 1;
  }
  {
    Keeper keeper(flash);
    CHECK(keeper.store.sequence() == 2);
    REQUIRE(save(keeper, 3) == Status::ok);
    CHECK(keeper.store.sequence() == 4);
    slot(flash, keeper.store.plan(), 1)[4] ^= 0x40;  // its number is unreadable
  }
  Keeper keeper(flash);
  CHECK(keeper.store.sequence() == 4);
  REQUIRE(save(keeper, 5) == Status::ok);
  CHECK(keeper.store.sequence() == 5);
}

TEST_CASE("a slot head with a size above the maximum is ignored") {
  SimulatedFlash flash(memories[2].geometry);
  const StorePlan plan = store_plan(memories[2].geometry, max_bytes);
  put_slot(slot(flash, plan, 0), 1, Contents(3));  // 919 bytes
  CHECK(number_found(flash, 4) == 3);
  CHECK_FALSE(Keeper(flash, 918).store.has_checkpoint());
}

TEST_CASE("a slot head of another format is ignored") {
  SimulatedFlash flash(memories[2].geometry);
  const StorePlan plan = store_plan(memories[2].geometry, max_bytes);
  put_slot(slot(flash, plan, 0), 1, Contents(0), StoredHead::current_format + 1);
  CHECK(number_found(flash, 1) == UINT32_MAX);
}

TEST_CASE("start() terminates for any sequence numbers in slot heads") {
  const FlashGeometry geometry{64, 2048, 4};
  SimulatedFlash flash(geometry);
  const StorePlan plan = store_plan(geometry, max_bytes);
  for (uint32_t i = 0; i < 3; ++i) {
    put_slot(slot(flash, plan, i), i * 0x55555555, Contents(i));
    slot(flash, plan, i)[20] ^= 1;
  }
  CHECK(number_found(flash, 3) == UINT32_MAX);
  put_slot(slot(flash, plan, 3), 7, Contents(3));
  (void)number_found(flash, 4);
}

TEST_CASE(
    "unreadable slots are skipped, and device_error is returned if no checkpoint is readable") {
  SimulatedFlash flash(memories[2].geometry);
  {
    Keeper keeper(flash);
    REQUIRE(save(keeper, 0) == Status::ok);
    flash.fail_call(0);
    CHECK(Keeper(flash).status == Status::device_error);
    REQUIRE(save(keeper, 1) == Status::ok);
  }
  flash.fail_call(1);  // the head of the newer one
  Keeper keeper(flash);
  CHECK(keeper.status == Status::ok);
  CHECK(keeper.store.sequence() == 1);
  flash.fail_call(0);
  CHECK(keeper.restore(Contents(0).parts()) == Status::device_error);
  CHECK(Contents::of(keeper) == Contents(0));
}

TEST_CASE("all parts of a checkpoint are restored as saved, or none") {
  SimulatedFlash flash(memories[2].geometry);
  Keeper keeper(flash);
  uint8_t bytes[300] = {}, read[301] = {};
  CHECK(keeper.restore({{read, 300}}) == Status::bad_checkpoint);
  std::iota(bytes, bytes + 300, uint8_t{0});
  REQUIRE(keeper.save({{bytes, 100}, {bytes + 100, 0}, {bytes + 100, 200}}) == Status::ok);
  CHECK(keeper.restore({{read, 300}}) == Status::bad_checkpoint);
  CHECK(keeper.restore({{read, 100}, {read, 0}, {read, 199}}) == Status::bad_checkpoint);
  CHECK(keeper.restore({{read, 99}, {read, 1}, {read, 200}}) == Status::bad_checkpoint);
  CHECK(keeper.restore({}) == Status::bad_checkpoint);
  CHECK(std::all_of(read, read + 301, [](uint8_t byte) { return byte == 0; }));
  CHECK(keeper.restore({{read, 101}, {read + 101, 0}, {read + 100, 201}}) == Status::ok);
  CHECK(std::equal(bytes, bytes + 300, read));
  CHECK(read[300] == 0);
  const Memory none{nullptr, 0};
  const std::vector<Memory> all = {{read, 100}, none, {read + 100, 200}, none, none, none};
  CHECK(keeper.restore(all) == Status::ok);
  CHECK(keeper.restore({all[0], all[1], all[2], none, none, none, none}) == Status::bad_checkpoint);
  CHECK(keeper.save({{bytes, 300}, none, none, none, none, none, none}) ==
        Status::too_little_memory);
  CHECK(keeper.save({{bytes, 300}, none, none, none, none, none}) == Status::ok);
  constexpr size_t lengths = StorePlan::head_bytes - CheckpointStore::max_parts * sizeof(uint32_t);
  for (size_t byte = lengths; byte < StorePlan::head_bytes + 300; ++byte) {
    slot(flash, keeper.store.plan(), 1)[byte] ^= 4;
    CAPTURE(byte);
    CHECK(keeper.restore({{read, 300}}) == Status::bad_checkpoint);
    slot(flash, keeper.store.plan(), 1)[byte] ^= 4;
  }
}

TEST_CASE("a discarded checkpoint is never found again, even after a power failure") {
  for (const Memories& memory : memories) {
    CAPTURE(memory.name);
    uint64_t saved = 0, discarded = 0;
    {
      SimulatedFlash flash(memory.geometry, 1, memory.kind);
      Keeper keeper(flash);
      CHECK(keeper.store.discard() == Status::ok);
      CHECK(flash.units == 0);
      save_all(keeper, 2);
      saved = flash.steps;
      REQUIRE(keeper.finish(keeper.store.discard()) == Status::ok);
      discarded = flash.steps;
      CHECK_FALSE(keeper.store.has_checkpoint());
      CHECK(keeper.restore(Contents(1).parts()) == Status::bad_checkpoint);
      CHECK(keeper.store.discard() == Status::ok);
      CHECK(flash.steps == discarded);
      CHECK(number_found(flash, 2) == UINT32_MAX);
      REQUIRE(save(keeper, 2) == Status::ok);
      CHECK(number_found(flash, 3) == 2);
      CHECK_FALSE(flash.has_broken_rules);
    }
    for (uint64_t cut = saved + 1; cut <= discarded; ++cut) {
      CAPTURE(cut);
      SimulatedFlash flash(memory.geometry, static_cast<uint32_t>(cut), memory.kind);
      flash.cut_after(cut);
      Keeper keeper(flash);
      save_all(keeper, 2);
      const Status status = keeper.finish(keeper.store.discard());
      flash.power_on();
      const uint32_t found = number_found(flash, 2);
      REQUIRE((found == UINT32_MAX || (found == 1 && status != Status::ok)));
      REQUIRE_FALSE(flash.has_broken_rules);
    }
  }
}

TEST_CASE("invalid calls of start(), save() and restore() are refused") {
  SimulatedFlash flash(memories[2].geometry);
  CheckpointStore store{};
  uint8_t buffer[256], bytes[max_bytes + 1] = {};
  const Memory one{bytes, 1};
  const Memory parts[8] = {{bytes, max_bytes}, one, one, one, one, one, one, one};
  CHECK(store.save(parts, 1) == Status::not_started);
  CHECK(store.resume() == Status::not_started);
  CHECK(store.erase_ahead(1) == Status::not_started);
  CHECK(store.discard() == Status::not_started);
  CHECK(store.restore(parts, 1) == Status::not_started);

  const FlashDevice device = flash.device();
  FlashDevice other = device;
  other.read = nullptr;
  CHECK(store.start(other, max_bytes, memory_of(buffer)) == Status::bad_device);
  other = device;
  other.program = nullptr;
  CHECK(store.start(other, max_bytes, memory_of(buffer)) == Status::bad_device);
  other = device;
  other.geometry.blocks = 1;
  CHECK(store.start(other, max_bytes, memory_of(buffer)) == Status::bad_device);
  CHECK(store.start(device, max_bytes, {}) == Status::too_little_memory);
  CHECK(store.start(device, max_bytes, {buffer, 255}) == Status::too_little_memory);
  CHECK(store.save(parts, 1) == Status::not_started);
  other = device;
  other.sync = nullptr;
  REQUIRE(store.start(other, max_bytes, memory_of(buffer)) == Status::ok);

  CHECK(store.save(parts, 0) == Status::too_little_memory);
  CHECK(store.save(parts, 2) == Status::too_little_memory);
  CHECK(store.save(parts + 1, 7) == Status::too_little_memory);
  const Memory null{nullptr, 50};
  CHECK(store.save(&null, 1) == Status::too_little_memory);
  const Memory empty{bytes, 0};
  CHECK(store.save(&empty, 1) == Status::too_little_memory);
  CHECK(flash.units == 0);
  Status status = store.save(parts, 1);
  while (status == Status::suspended) status = store.resume();
  CHECK(status == Status::ok);
  CHECK(store.bytes() == max_bytes);
}

TEST_CASE("store_plan() computes slots, blocks and units, and rejects invalid geometries") {
  // 32 KiB of an SPI NOR flash for 33 checkpoints of 30,000 bytes, and four sectors of an STM32F4.
  constexpr FlashGeometry nor{256, 4096, 272}, internal{256, 131072, 4};
  constexpr StorePlan in_nor = store_plan(nor, 30000);
  static_assert(in_nor.is_valid() && in_nor.slots == 34 && in_nor.slots_per_block == 1 &&
                in_nor.blocks_per_slot == 8 && in_nor.units(30000) == 118 &&
                in_nor.blocks(30000) == 8 && in_nor.blocks(4052) == 1 && in_nor.blocks(4053) == 2);
  constexpr StorePlan in_internal = store_plan(internal, 30000);
  static_assert(in_internal.is_valid() && in_internal.slots == 16 &&
                in_internal.slots_per_block == 4 && in_internal.blocks_per_slot == 1 &&
                in_internal.blocks(30000) == 1);

  const auto is_valid = [](const FlashGeometry& geometry, uint32_t bytes) {
    return store_plan(geometry, bytes).is_valid();
  };
  CHECK(is_valid({16, 16, 8}, 20));  // four units per slot
  CHECK_FALSE(is_valid({16, 16, 7}, 20));
  CHECK(is_valid({16, 64, 2}, 20));
  CHECK_FALSE(is_valid({16, 64, 1}, 20));
  CHECK_FALSE(is_valid({16, 128, 1}, 20));  // two slots, but of one block
  CHECK_FALSE(is_valid({15, 30, 100}, 12));
  CHECK_FALSE(is_valid({16, 40, 100}, 12));
  CHECK_FALSE(is_valid({32, 16, 100}, 12));
  CHECK_FALSE(is_valid({0, 0, 100}, 12));
  CHECK_FALSE(is_valid({16, 16, 0}, 12));
  CHECK_FALSE(is_valid({16, 4096, 2}, 0));
  CHECK_FALSE(is_valid({16, 1U << 30, 2}, (1U << 30) + 1));
  CHECK(is_valid({16, 1U << 30, 4}, 1U << 30));
  CHECK_FALSE(is_valid({16, (1U << 30) + 16, 2}, 12));
  CHECK_FALSE(is_valid({16, 1U << 30, 64}, 12));
  CHECK(is_valid({16, 1U << 30, 63}, 12));
}
