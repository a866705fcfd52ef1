// The pool: it allocates every slot once, in an order that depends only on the calls.
#include <discmc/base/pool.hpp>

#include "test.hpp"

using namespace discmc;

namespace {

template <class Index>
struct PooledSlot {
  Index next;
  uint32_t payload;
};

// A pool with slots of its own, all unused.
template <class Index>
class StartedPool : public Pool<PooledSlot<Index>, Index> {
 public:
  explicit StartedPool(uint32_t capacity) : slots_(capacity) {
    this->start(slots_.data(), capacity);
    this->clear();
  }

 private:
  std::vector<PooledSlot<Index>> slots_;
};

template <class Index>
void check_random_operations(uint32_t capacity, uint32_t seed) {
  StartedPool<Index> pool(capacity);
  std::vector<Index> allocated;
  uint32_t peak = 0;
  for (uint32_t i = 0; i < 20000; ++i) {
    seed = seed * 1664525 + 1013904223;
    // Alternates between growth and shrinking.
    const bool takes = (seed >> 20) % 100 < (i / 1000 % 2 == 0 ? 70U : 30U);
    if (takes) {
      const Index index = pool.allocate();
      CHECK((index == no_slot) == (allocated.size() == capacity));
      if (index == no_slot) continue;
      REQUIRE(index >= 1);
      REQUIRE(index <= capacity);
      pool[index].payload = index * 3U;
      allocated.push_back(index);
    } else if (!allocated.empty()) {
      const size_t place = (seed >> 8) % allocated.size();
      CHECK(pool[allocated[place]].payload == allocated[place] * 3U);
      pool.release(allocated[place]);
      allocated.erase(allocated.begin() + static_cast<std::ptrdiff_t>(place));
    }
    peak = allocated.size() > peak ? static_cast<uint32_t>(allocated.size()) : peak;
    REQUIRE(pool.in_use() == allocated.size());
    REQUIRE(pool.available() == capacity - allocated.size());
    REQUIRE(pool.peak() == peak);
  }
  CHECK(std::set<Index>(allocated.begin(), allocated.end()).size() == allocated.size());
}

}  // namespace

TEST_CASE("a pool provides each slot once, then returns no_slot") {
  StartedPool<uint16_t> pool(5);
  std::set<uint16_t> allocated;
  for (int i = 0; i < 5; ++i) allocated.insert(pool.allocate());
  CHECK(allocated == std::set<uint16_t>{1, 2, 3, 4, 5});
  CHECK(pool.allocate() == no_slot);
  CHECK(pool.allocate() == no_slot);
  CHECK(pool.in_use() == 5);
  CHECK(pool.available() == 0);
  pool.release(3);
  CHECK(pool.allocate() == 3);
  CHECK(pool.allocate() == no_slot);
}

TEST_CASE("the last released slot is reused first") {
  StartedPool<uint32_t> pool(8);
  for (uint32_t i = 1; i <= 6; ++i) CHECK(pool.allocate() == i);
  pool.release(1);
  pool.release(4);
  CHECK(pool.allocate() == 4);
  CHECK(pool.allocate() == 1);
  CHECK(pool.allocate() == 7);
}

TEST_CASE("clear() releases all slots and resets the peak") {
  StartedPool<uint16_t> pool(4);
  for (int i = 0; i < 4; ++i) pool.allocate();
  pool.release(2);
  CHECK(pool.peak() == 4);
  pool.clear();
  CHECK(pool.in_use() == 0);
  CHECK(pool.peak() == 0);
  for (uint16_t i = 1; i <= 4; ++i) CHECK(pool.allocate() == i);
  CHECK(pool.allocate() == no_slot);
}

TEST_CASE("a pool without slots returns no_slot") {
  Pool<PooledSlot<uint16_t>, uint16_t> pool;
  CHECK(pool.allocate() == no_slot);
  pool.start(nullptr, 0);
  pool.clear();
  CHECK(pool.allocate() == no_slot);
  CHECK(pool.capacity() == 0);
  CHECK(pool.peak() == 0);
}

TEST_CASE("index 0 means no slot, and all other indices are used") {
  // The maximum number of slots with 16-bit indices.
  StartedPool<uint16_t> pool(65535);
  for (uint32_t i = 1; i <= 65535; ++i) REQUIRE(pool.allocate() == i);
  CHECK(pool.allocate() == no_slot);
}

TEST_CASE("random operations never assign a slot twice or lose one") {
  for (const uint32_t capacity : {1U, 2U, 7U, 100U, 1000U}) {
    check_random_operations<uint16_t>(capacity, capacity);
    check_random_operations<uint32_t>(capacity, capacity + 1);
  }
}

TEST_CASE("a pool continues in a larger array with the slots in use") {
  StartedPool<uint16_t> pool(3);
  for (uint32_t i = 1; i <= 3; ++i) REQUIRE(pool.allocate() == i);
  pool.release(2);
  std::vector<PooledSlot<uint16_t>> larger(5);
  pool.unpoison_free();
  std::copy_n(&pool[1], 3, larger.begin());
  pool.move_to(larger.data(), 5);
  CHECK(pool.available() == 3);
  CHECK(pool.in_use() == 2);
  CHECK(pool.allocate() == 2);
  CHECK(pool.allocate() == 4);
  CHECK(pool.allocate() == 5);
  CHECK(pool.allocate() == no_slot);
  CHECK(&pool[5] == &larger[4]);
}
