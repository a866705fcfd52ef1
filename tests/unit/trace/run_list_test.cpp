// Lists of runs keep their order, and return every slot.
#include <discmc/trace/run_list.hpp>

#include <deque>

#include "test.hpp"

using namespace discmc;

namespace {

using Lists = detail::trace::RunLists<uint16_t, detail::trace::NoNormal>;
using Cursor = detail::trace::RunCursor<uint16_t, detail::trace::NoNormal>;

struct Pooled {
  static constexpr uint32_t capacity = 200;

  std::vector<detail::trace::Slot<uint16_t, detail::trace::NoNormal>> memory{capacity};
  Lists::Slots slots;

  Pooled() {
    slots.start(memory.data(), capacity);
    slots.clear();
  }
};

// A list, and its expected contents.
struct List {
  uint16_t last = no_slot;
  std::deque<detail::trace::ShortRun> runs;

  void append(Pooled& pooled, detail::trace::ShortRun run) {
    Lists::append(pooled.slots, last, entry_of(run));
    runs.push_back(run);
  }
  void prepend(Pooled& pooled, detail::trace::ShortRun run) {
    Lists::prepend(pooled.slots, last, entry_of(run));
    runs.push_front(run);
  }
  void check(const Pooled& pooled) const {
    REQUIRE((last == no_slot) == runs.empty());
    if (runs.empty()) return;
    CHECK(Lists::last_run(pooled.slots, last) == runs.back());
    const Cursor begin(pooled.slots, last);
    Cursor cursor = begin;
    for (const detail::trace::ShortRun run : runs) {
      CHECK(cursor.run(pooled.slots) == run);
      cursor.advance(pooled.slots);
    }
    CHECK(cursor == begin);
  }

 private:
  static Lists::Entry entry_of(detail::trace::ShortRun run) {
    Lists::Entry entry;
    entry.run = run;
    return entry;
  }
};

// Appends and prepends runs.
List list_of(Pooled& pooled, uint32_t appended, uint32_t prepended) {
  List list;
  for (uint32_t i = 1; i <= appended || i <= prepended; ++i) {
    if (i <= appended) list.append(pooled, detail::trace::short_run(1, i));
    if (i <= prepended) list.prepend(pooled, detail::trace::short_run(2, i));
  }
  return list;
}

}  // namespace

TEST_CASE("runs keep their order if prepended, appended or in joined lists") {
  for (uint32_t n = 0; n < 6 * 6 * 6 * 6; ++n) {
    Pooled pooled;
    List list = list_of(pooled, n % 6, n / 6 % 6);
    list.check(pooled);
    const List after = list_of(pooled, n / 36 % 6, n / 216);
    list.last = Lists::concatenate(pooled.slots, list.last, after.last);
    list.runs.insert(list.runs.end(), after.runs.begin(), after.runs.end());
    list.check(pooled);
    list.append(pooled, detail::trace::short_run(3, 1));
    list.prepend(pooled, detail::trace::short_run(3, 2));
    list.check(pooled);
  }
}

TEST_CASE("a slot of a run list stores three consecutive runs") {
  Pooled pooled;
  (void)list_of(pooled, 30, 0);
  CHECK(pooled.slots.in_use() == 10);
  (void)list_of(pooled, 0, 30);
  CHECK(pooled.slots.in_use() == 20);
}

TEST_CASE("releasing a list leaves no slot in use") {
  for (uint32_t runs = 1; runs < 20; ++runs) {
    Pooled pooled;
    const List kept = list_of(pooled, 4, 0);
    const uint32_t in_use = pooled.slots.in_use();
    Lists::release(pooled.slots, list_of(pooled, runs, 0).last);
    CHECK(pooled.slots.in_use() == in_use);
    kept.check(pooled);
  }
}

TEST_CASE("slots of a run list are counted up to a requested number") {
  Pooled pooled;
  CHECK(Lists::slots_up_to(pooled.slots, no_slot, 5) == 0);
  for (const uint32_t slots : {1U, 2U, 7U}) {
    const List list = list_of(pooled, 3 * slots, 0);
    for (uint32_t most = 0; most < 10; ++most) {
      const uint32_t counted = Lists::slots_up_to(pooled.slots, list.last, most);
      CHECK(counted == (slots <= most ? slots : most + 1));
    }
  }
}
