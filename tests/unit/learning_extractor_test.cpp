// An extractor that remembers neighbourhoods says what any other says, whatever it has forgotten.
#include <doctest/doctest.h>

#include <discmc/learning_extractor.hpp>

#include <algorithm>
#include <tuple>
#include <vector>

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

// Nine rows of 40 voxels: there are crossings in both words of the middle one.
struct Rows {
  uint32_t words[9][2] = {};

  Rows() {
    const BitVolume volume = random({40, 3, 3}, 80, 5);
    for (int row = 0; row < 9; ++row)
      for (uint32_t word = 0; word < 2; ++word)
        for (uint32_t bit = 0; bit < 32; ++bit) {
          const uint32_t x = trace::column_of(word, bit);
          if (x < 40 && volume.on[static_cast<size_t>(row) * 40 + x] != 0)
            words[row][word] |= 1U << bit;
        }
  }
  trace::SweptRow swept() const {
    trace::SweptRow row{};
    for (int i = 0; i < 9; ++i) row.rows.row[i / 3][i % 3] = words[i];
    row.words = 2;
    row.width = 40;
    row.has_y = row.has_z = true;
    return row;
  }
};

using FoundPass = std::tuple<int32_t, int32_t, int32_t, int, int, int>;

template <class Passes>
std::vector<FoundPass> passes_found(Passes& passes, const trace::SweptRow& row) {
  std::vector<FoundPass> found;
  trace::CellCounts counts;
  while (passes.find(row, counts))
    for (; passes.has_next(); passes.advance())
      found.emplace_back(passes.vertex().x, passes.vertex().y, passes.vertex().z,
                         passes.pass().incidence, passes.pass().in, passes.pass().out);
  return found;
}

TEST_CASE("the same passes are found with memory of any size, wherever it lies, again and again") {
  const Rows rows;
  trace::SweptRow row = rows.swept();
  std::vector<uint8_t> memory(2000);
  for (const bool is_missing_cells : {false, true}) {
    row.has_open_ends = is_missing_cells;
    row.missing[1] = is_missing_cells ? 9 : 0;
    trace::DerivedPasses derived;
    const std::vector<FoundPass> expected = passes_found(derived, row);
    REQUIRE(expected.size() > 40);
    for (size_t bytes = 0; bytes < memory.size(); bytes += 37) {
      trace::LearntPasses learnt;
      learnt.learn_in({memory.data() + bytes % 8, bytes - bytes % 8});
      CHECK(passes_found(learnt, row) == expected);
      CHECK(passes_found(learnt, row) == expected);
    }
  }
}

TEST_CASE("passes are remembered from room for two neighbourhoods on") {
  const Rows rows;
  constexpr size_t entry = 40, most_lost = 2 * (Arena::alignment - 1);
  for (size_t bytes = 0; bytes < 4 * entry; ++bytes) {
    std::vector<uint8_t> memory(bytes + 1, 0xA5);
    trace::LearntPasses passes;
    passes.learn_in({memory.data(), bytes});
    (void)passes_found(passes, rows.swept());
    const auto is_written = [](uint8_t byte) { return byte != 0xA5; };
    CHECK(std::any_of(memory.begin(), memory.end(), is_written) ==
          (bytes >= 2 * entry + most_lost));
    CHECK(memory.back() == 0xA5);
  }
}
