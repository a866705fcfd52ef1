// The ring of rows, compared with a list of the arrived rows. It is tested in one thread, with an
// interrupt after every instruction, and with a second thread.
#include <discmc/front/row_ring.hpp>

#include <thread>

#include "oracle/scan.hpp"
#include "oracle/single_step.hpp"
#include "oracle/stream.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using Next = RowRing::Next;
using reference::Block;

namespace {

constexpr uint32_t row_bytes = 2;

struct Ring : RowRing {
  explicit Ring(uint32_t rows) : block(bytes_for(row_bytes, rows)) {
    REQUIRE(start(row_bytes, rows, block.memory()) == Status::ok);
  }
  Block block;
};

// A sensor: a row enters the ring, with all bytes equal to its number, or is lost.
bool produce(RowRing& ring, uint32_t ahead = 0) {
  void* const row = ring.free_row(ahead);
  if (row == nullptr) {
    ring.drop();
    return false;
  }
  std::memset(row, static_cast<int>(ring.produced() & 0xFF), row_bytes);
  ring.commit();
  return true;
}

bool is_row(const RowRing& ring, uint32_t number) {
  const auto* const bytes = static_cast<const uint8_t*>(ring.row());
  for (uint32_t i = 0; i < row_bytes; ++i)
    if (bytes[i] != (number & 0xFF)) return false;
  return true;
}

// The rows that a task has read: one character per row, in order.
struct Task {
  std::string seen;
  bool is_right = true;
  bool has_ended = false;

  // Reads the available rows, at most `limit`. Returns their number.
  uint32_t read(RowRing& ring, uint32_t limit) {
    for (uint32_t rows_read = 0; rows_read < limit; ++rows_read) {
      const Next next = ring.peek();
      if (next == Next::none || next == Next::end) {
        has_ended = next == Next::end;
        return rows_read;
      }
      is_right = is_right && !has_ended && ring.consumed() == seen.size() &&
                 (next == Next::lost || is_row(ring, ring.consumed()));
      seen += next == Next::ready ? 'r' : 'l';
      ring.pop();
    }
    return limit;
  }
};

}  // namespace

TEST_CASE("a row ring delivers rows in order and marks lost rows in their place") {
  Ring ring(2);
  Task task;
  CHECK(ring.peek() == Next::none);
  CHECK(produce(ring));
  CHECK(produce(ring));
  CHECK_FALSE(produce(ring));  // the ring is full
  task.read(ring, 1);
  CHECK(produce(ring));
  ring.drop(2);
  task.read(ring, 100);
  CHECK(task.seen == "rrlrll");
  CHECK(ring.peek() == Next::none);
  CHECK(ring.lost() == 3);
  CHECK(ring.produced() == 6);
  CHECK(ring.consumed() == 6);
  ring.drop();
  ring.end();
  CHECK_FALSE(task.has_ended);
  task.read(ring, 100);
  CHECK(task.seen == "rrlrlll");
  CHECK(task.has_ended);
  CHECK(task.is_right);
  CHECK(ring.block.is_intact());
}

TEST_CASE("free_row(ahead) returns a row only if that row of the ring is free") {
  for (const uint32_t rows : {1U, 2U, 3U, 7U}) {
    Ring ring(rows);
    Task task;
    // From every position in the ring.
    for (uint32_t round = 0; round < 2 * rows + 1; ++round) {
      for (uint32_t full = 0; full <= rows; ++full) {
        INFO("rows ", rows, ", full ", full);
        for (uint32_t ahead = 0; ahead < rows + 2; ++ahead)
          CHECK((ring.free_row(ahead) != nullptr) == (full + ahead < rows));
        if (full + 1 < rows) {
          // The next row will be the row that is filled ahead.
          void* const then = ring.free_row(1);
          CHECK(produce(ring));
          CHECK(ring.free_row() == then);
        } else {
          CHECK(produce(ring) == (full < rows));
        }
      }
      task.read(ring, 100);
      CHECK(produce(ring));  // so the next round begins one position later
      task.read(ring, 100);
    }
    CHECK(task.is_right);
    CHECK(ring.block.is_intact());
  }
}

TEST_CASE("rows of a ring are contiguous and begin at aligned addresses") {
  alignas(32) static uint8_t memory[RowRing::bytes_for(64, 3)];
  RowRing ring;
  REQUIRE(ring.start(64, 3, memory_of(memory)) == Status::ok);
  for (uint32_t ahead = 0; ahead < 3; ++ahead) CHECK(ring.free_row(ahead) == memory + 64 * ahead);
}

TEST_CASE(
    "a ring refuses zero rows, empty rows and too little memory, and the refusal changes nothing") {
  Ring ring(3);
  CHECK(produce(ring));
  Block block(RowRing::bytes_for(row_bytes, 3) - 1);
  CHECK(ring.start(row_bytes, 3, block.memory()) == Status::too_little_memory);
  CHECK(ring.start(row_bytes, 3, {}) == Status::too_little_memory);
  CHECK(ring.start(0, 3, block.memory()) == Status::bad_capacities);
  CHECK(ring.start(row_bytes, 0, block.memory()) == Status::bad_capacities);
  CHECK(ring.start(UINT32_MAX, UINT32_MAX, {block.memory().data, SIZE_MAX}) ==
        Status::bad_capacities);
  CHECK(ring.peek() == Next::ready);
  CHECK(is_row(ring, 0));
  CHECK(ring.free_row(1) != nullptr);
  CHECK(ring.free_row(2) == nullptr);
}

TEST_CASE("an unstarted ring has no free row and no rows to read") {
  RowRing ring;
  CHECK(ring.free_row() == nullptr);
  CHECK(ring.peek() == Next::none);
}

TEST_CASE("a restarted ring has no rows") {
  Ring ring(3);
  for (int row = 0; row < 2; ++row) CHECK(produce(ring));
  ring.drop();
  ring.end();
  Task before;
  before.read(ring, 1);
  REQUIRE(ring.start(row_bytes, 3, ring.block.memory()) == Status::ok);
  CHECK(ring.peek() == Next::none);
  Task task;
  for (int row = 0; row < 3; ++row) CHECK(produce(ring));
  task.read(ring, 100);
  CHECK(task.seen == "rrr");
  CHECK(task.is_right);
}

TEST_CASE("rows are unchanged for any interleaving of writer and reader") {
  test::Chance chance(7);
  for (const uint32_t rows : {1U, 2U, 3U, 5U, 8U}) {
    Ring ring(rows);
    Task task;
    std::string came;
    for (int step = 0; step < 20000; ++step) {
      if (chance.below(2) == 0) {
        task.read(ring, 1 + chance.below(rows + 2));
      } else if (chance.below(8) == 0) {
        const uint32_t lost = chance.below(4);
        ring.drop(lost);
        came.append(lost, 'l');
      } else {
        came += produce(ring) ? 'r' : 'l';
      }
    }
    ring.end();
    task.read(ring, UINT32_MAX);
    CHECK(task.has_ended);
    CHECK(task.seen == came);
    CHECK(task.is_right);
    CHECK(ring.block.is_intact());
  }
}

// ---- interrupts ----

namespace {

// The state of a ring of two rows: the numbers of arrived and passed rows.
struct State {
  uint32_t came, passed;
};
constexpr State states[] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}, {3, 2}};

struct Situation {
  Ring ring{2};
  Task task;
  std::string came;

  explicit Situation(const State& state) {
    // No memory is allocated after this.
    came.reserve(16);
    task.seen.reserve(16);
    for (uint32_t i = 0; i < state.came; ++i) come();
    task.read(ring, state.passed);
  }
  void come() { came += produce(ring) ? 'r' : 'l'; }
};

void check(Situation& situation) {
  situation.ring.end();
  situation.task.read(situation.ring, 100);
  CHECK(situation.task.has_ended);
  CHECK(situation.task.seen == situation.came);
  CHECK(situation.task.is_right);
}

}  // namespace

TEST_CASE("rows of an interrupt after any instruction of the task are delivered") {
  if (!reference::can_single_step) return;
  for (const State& state : states)
    for (const uint32_t rows : {1U, 3U})
      for (uint64_t at = 1;; at += reference::step(3)) {
        Situation situation(state);
        const bool came = reference::interrupted(
            at, [&] { situation.task.read(situation.ring, 2); },
            [&] {
              for (uint32_t row = 0; row < rows; ++row) situation.come();
              if (rows > 1) situation.ring.end();
            });
        check(situation);
        if (!came) break;
      }
}

TEST_CASE("a task after any instruction of the interrupt reads all complete rows") {
  if (!reference::can_single_step) return;
  for (const State& state : states)
    for (uint64_t at = 1;; ++at) {
      Situation situation(state);
      const bool came = reference::interrupted(
          at,
          [&] {
            situation.come();
            situation.ring.drop();
            situation.came += 'l';
          },
          [&] { situation.task.read(situation.ring, 3); });
      check(situation);
      if (!came) break;
    }
}

// ---- threads: also run by the thread sanitizer ----

TEST_CASE("rows are unchanged if a second thread writes faster or slower than the reader") {
  constexpr uint32_t all = 5000;
  for (const uint32_t rows : {1U, 2U, 5U}) {
    Ring ring(rows);
    std::string came;
    std::thread sensor([&ring, &came] {
      test::Chance chance(3);
      for (uint32_t row = 0; row < all; ++row) {
        came += produce(ring) ? 'r' : 'l';
        // Alternates between bursts and single rows.
        if (row % 64 >= 16 && chance.below(2) == 0)
          while (ring.free_row() == nullptr) std::this_thread::yield();
      }
      ring.end();
    });
    Task task;
    while (!task.has_ended)
      if (task.read(ring, 100) == 0) std::this_thread::yield();
    sensor.join();
    CHECK(task.seen == came);
    CHECK(task.is_right);
    CHECK(ring.lost() == static_cast<uint32_t>(std::count(came.begin(), came.end(), 'l')));
    CHECK(came.find('r') != std::string::npos);
  }
}
