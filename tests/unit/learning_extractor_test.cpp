// An extractor that remembers neighbourhoods says what any other says, whatever it has forgotten.
#include <doctest/doctest.h>

#include <discmc/learning_extractor.hpp>

#include "oracle/event_log.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr size_t arena_bytes = 1 << 20;

std::vector<BitVolume> volumes() {
  return {random({40, 9, 12}, 128, 1), random({9, 40, 12}, 20, 2), checkerboard({8, 8, 8}),
          ball({30, 30, 30}, {29, 29, 29}, 600), box({5, 5, 5}, {1, 1, 1}, {3, 3, 3})};
}

template <class Index>
EventLog scanned(LearningExtractor<Index>& extractor, const BitVolume& volume, Border border) {
  EventLog log;
  Block block(arena_bytes);
  const Limits limits{volume.width, volume.height, border};
  require_ok(extractor.start(limits, Capacities{20000, 100}, 1, block.memory(), sink_to(log)));
  push_all(extractor, volume.on);
  finish_all(extractor);
  return log;
}

template <class Index>
void check_like_others(size_t bytes) {
  Block learnt(bytes);
  LearningExtractor<Index> extractor;
  extractor.learn_in(learnt.memory());
  for (const Border border : {Border::closed, Border::open})
    for (const BitVolume& volume : volumes()) {
      Plan plan;
      plan.border = border;
      EventLog expected;
      scan_into<Index>(expected, volume, plan, {20000, 100});
      CHECK(scanned(extractor, volume, border).events == expected.events);
    }
  CHECK(learnt.is_intact());
}

}  // namespace

TEST_CASE("an extractor that learns gives the events of one that does not, from scan to scan") {
  for (const size_t bytes :
       {size_t{0}, size_t{79}, size_t{80}, size_t{1000}, size_t{1} << 16, size_t{1} << 21}) {
    CAPTURE(bytes);
    check_like_others<uint16_t>(bytes);
    check_like_others<uint32_t>(bytes);
  }
}

TEST_CASE("an extractor learns in memory with any alignment, and may begin anew in other memory") {
  const BitVolume volume = random({20, 20, 9}, 100, 3);
  EventLog expected;
  scan_into<uint32_t>(expected, volume, {}, {20000, 100});
  LearningExtractor<uint32_t> extractor;
  for (size_t offset = 0; offset < 5; ++offset) {
    Block learnt(5000);
    const Memory all = learnt.memory();
    extractor.learn_in({static_cast<uint8_t*>(all.data) + offset, all.bytes - offset});
    CHECK(scanned(extractor, volume, Border::closed).events == expected.events);
    CHECK(learnt.is_intact());
  }
  extractor.learn_in({nullptr, 0});
  CHECK(scanned(extractor, volume, Border::closed).events == expected.events);
}

TEST_CASE("what is learnt is no part of a checkpoint") {
  const BitVolume volume = random({16, 16, 8}, 100, 4);
  const auto half = static_cast<uint32_t>(volume.on.size() / 2);
  EventLog log, expected;
  scan_into<uint32_t>(expected, volume, {}, {20000, 100});
  Block block(arena_bytes);
  auto checkpoint = std::make_unique<Checkpoint<LearningExtractor<uint32_t>>>();
  {
    Block learnt(1 << 16);
    LearningExtractor<uint32_t> before{};
    before.learn_in(learnt.memory());
    require_ok(before.start({16, 16}, Capacities{20000, 100}, 1, block.memory(), sink_to(log)));
    require_ok(before.push(volume.on.data(), half).status);
    require_ok(before.save(*checkpoint));
  }
  LearningExtractor<uint32_t> after;
  require_ok(after.restore(*checkpoint, block.memory(), sink_to(log)));
  require_ok(after.push(volume.on.data() + half, half).status);
  finish_all(after);
  CHECK(log.events == expected.events);
}

TEST_CASE("passes are remembered from room for one neighbourhood on, wherever the memory lies") {
  const uint32_t on = 0x15, off = 0;
  trace::RowBlock rows;
  for (auto& slice : rows.row)
    for (const uint32_t*& row : slice) row = &off;
  rows.row[1][1] = &on;
  constexpr size_t entry = sizeof(uint32_t) + sizeof(trace::PassList);
  constexpr size_t most_lost = Arena::alignment - 1;
  alignas(8) uint8_t memory[4 * entry + 8];
  trace::PassList scratch;
  for (size_t offset = 0; offset < 4; ++offset) {
    trace::LearntPasses passes;
    for (size_t bytes = 0; bytes < 4 * entry; bytes += 1) {
      passes.learn_in({memory + offset, bytes});
      const bool is_remembered = &passes.at({rows, 0, 2, 0}, 0, scratch) != &scratch;
      CHECK(is_remembered == (bytes >= entry + most_lost));
    }
    CHECK(&passes.at({rows, 0, 2, 0}, 3, scratch) == &scratch);  // cells are absent
  }
}
