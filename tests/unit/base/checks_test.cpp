// With an address sanitizer: poisoned parts of the caller's memory, and traps.
#include <discmc/base/checks.hpp>
#include <discmc/extractor.hpp>
#include <discmc/joiner.hpp>

#include "oracle/scan.hpp"
#include "test.hpp"

#if defined(DISCMC_HAS_ADDRESS_SANITIZER)
#include <sanitizer/asan_interface.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#endif

using namespace discmc;
using namespace discmc::reference;

namespace {

struct Item {
  uint32_t next;
  uint32_t payload;
};
using Items = Pool<Item, uint32_t>;

// Reads every byte, as a caller does to copy the memory.
uint32_t sum_of(const void* data, size_t bytes) {
  const auto* const first = static_cast<const uint8_t*>(data);
  return std::accumulate(first, first + bytes, 0U);
}

constexpr Capacities some{2000, 100};

}  // namespace

TEST_CASE("arrays of an arena are separated only by a red zone") {
  CHECK(Arena::bytes_of(5, 1) == 8 + red_zone_bytes);
  const std::unique_ptr<uint32_t[]> memory(new uint32_t[100]());
  Arena arena({memory.get(), 400});
  const auto* const first = arena.allocate<uint8_t>(5);
  const auto* const second = arena.allocate<uint8_t>(5);
  CHECK(second == first + 8 + red_zone_bytes);
  CHECK(sum_of(first, 5) + sum_of(second, 5) == 0);
}

TEST_CASE("the memory of a scan may be copied for a checkpoint, and is reusable after the end") {
  const BitVolume volume = random({30, 20, 8}, 128, 3);
  const Limits limits = limits_of(volume, Border::closed);
  const std::vector<uint8_t> half(volume.on.begin(), volume.on.begin() + 4 * 600);
  std::vector<uint8_t> memory(Extractor32::bytes_for(limits, some));
  EventLog log;
  Extractor32 extractor;
  require_ok(
      extractor.start(limits, some, 1, Memory{memory.data(), memory.size()}, make_sink(log)));
  push_all(extractor, half);
  CHECK(sum_of(memory.data(), extractor.bytes_used()) > 0);
  push_all(extractor, half);
  finish_all(extractor);
  std::fill(memory.begin(), memory.end(), uint8_t{0});
}

TEST_CASE("the memory of a joiner is reusable after the end") {
  const BitVolume volume = random({30, 20, 8}, 128, 3);
  std::vector<uint8_t> memory(1000000);
  EventLog log;
  Joiner joiner;
  require_ok(joiner.start(Memory{memory.data(), memory.size()}, make_sink(log), InputOrder::sweep));
  scan_into<uint16_t>(joiner, volume, {}, Capacities{60, 10});
  require_ok(joiner.finish());
  CHECK(joiner.report().received > 0);
  // Red zones stay poisoned.
  if (red_zone_bytes == 0) std::fill(memory.begin(), memory.end(), uint8_t{0});
}

TEST_CASE("memory on the stack is never poisoned") {
  Item items[40] = {};
  Items pool;
  pool.start(items, 40);
  pool.clear();
  pool.release(pool.allocate());
  CHECK(sum_of(items, sizeof items) == 0);
}

#if defined(DISCMC_HAS_ADDRESS_SANITIZER)

namespace {

bool is_poisoned(const void* byte) {
  return __asan_address_is_poisoned(byte) != 0;
}

// Whether a trap or a report ends a process that runs this function.
template <class Action>
bool is_fatal(Action action) {
  const pid_t child = fork();
  if (child == 0) {
    (void)close(STDERR_FILENO);
    (void)signal(SIGILL, SIG_DFL);
    action();
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return !WIFEXITED(status) || WEXITSTATUS(status) != 0;
}

struct HeapItems {
  explicit HeapItems(uint32_t capacity) : items(new Item[capacity]()) {
    pool.start(items.get(), capacity);
    pool.clear();
  }
  bool is_free(uint32_t index) const { return is_poisoned(&items[index - 1].payload); }

  std::unique_ptr<Item[]> items;
  Items pool;
};

}  // namespace

TEST_CASE("free slots are poisoned, both unused and released ones") {
  HeapItems heap(8);
  CHECK(heap.is_free(1));
  CHECK(heap.is_free(8));
  CHECK(heap.pool.allocate() == 1);
  for (uint32_t i = 2; i <= 4; ++i) CHECK(heap.pool.allocate() == i);
  for (uint32_t i = 1; i <= 4; ++i) CHECK(!heap.is_free(i));
  CHECK(heap.is_free(5));
  heap.pool.release(3);
  CHECK(heap.is_free(3));
  CHECK(!heap.is_free(4));
  CHECK(heap.pool.allocate() == 3);
  CHECK(!heap.is_free(3));
  heap.pool.clear();
  CHECK(heap.is_free(3));
  heap.pool.unpoison_free();
  CHECK(!heap.is_free(8));
}

TEST_CASE("an arena can reuse memory that a previous scan left poisoned") {
  std::vector<uint8_t> memory(1000);
  poison(memory.data(), memory.size());
  Arena arena(Memory{memory.data(), memory.size()});
  CHECK(sum_of(arena.allocate<uint8_t>(500), 500) == 0);
}

TEST_CASE("a checked build poisons the red zone of an array") {
  std::vector<uint8_t> memory(1000);
  Arena arena(Memory{memory.data(), memory.size()});
  const auto* const first = arena.allocate<uint8_t>(16);
  (void)arena.allocate<uint8_t>(16);
  if (red_zone_bytes > 0) CHECK(is_fatal([first] { return sum_of(first, 16 + 8); }));
}

TEST_CASE("misuse of a pool aborts: releasing a slot twice, or reading a free slot") {
  HeapItems heap(8);
  Items& pool = heap.pool;
  for (int i = 0; i < 5; ++i) (void)pool.allocate();
  pool.release(2);
  CHECK(is_fatal([&] { pool.release(2); }));        // already released
  CHECK(is_fatal([&] { pool.release(6); }));        // never allocated
  CHECK(is_fatal([&] { pool.release(no_slot); }));  // no slot
  CHECK(is_fatal([&] { pool[2].payload = 1; }));
  CHECK(is_fatal([&] { pool[6].payload = 1; }));
  CHECK(is_fatal([&] { pool[no_slot].payload = 1; }));
  CHECK(is_fatal([&] { pool.reserve(5); }));
  CHECK(is_fatal([&] { pool.unreserve(5); }));
  CHECK(!is_fatal([&] {
    pool.reserve(4);
    pool.unreserve(4);
    pool.release(1);
    pool[5].payload = 1;
  }));
}

#endif
