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

// A plate with holes of many shapes: rings of many runs, and such as touch themselves.
BitVolume plate() {
  const Size size{60, 50, 3};
  const BitVolume noise = random(size, 190, 6);
  BitVolume volume = box(size, {0, 0, 1}, {59, 49, 1});
  for (size_t y = 1; y + 1 < size.height; ++y)
    for (size_t x = 1; x + 1 < size.width; ++x) {
      const size_t i = (size.height + y) * size.width + x;
      volume.on[i] = noise.on[i];
    }
  return volume;
}

std::vector<BitVolume> volumes() {
  return {random({40, 9, 12}, 128, 1),
          random({9, 40, 12}, 20, 2),
          checkerboard({8, 8, 8}),
          ball({30, 30, 30}, {29, 29, 29}, 600),
          box({5, 5, 5}, {1, 1, 1}, {3, 3, 3}),
          box({4200, 3, 3}, {0, 1, 1}, {4199, 1, 1}),
          plate()};
}

constexpr Capacities much{20000, 100};

// The events of an extractor, which may learn.
template <class Extractor>
EventLog scanned(Extractor& extractor, const BitVolume& volume, const Plan& plan,
                 const Capacities& capacities = much, const EventLog::Refuses& refuses = {}) {
  EventLog log(refuses);
  Block block(arena_bytes);
  require_ok(extractor.start(limits_of(volume, plan.border), capacities, 1, block.memory(),
                             sink_to(log, plan.takes_fragments)));
  push_all(extractor, volume.on);
  finish_all(extractor);
  return log;
}

template <class Index>
void check_like_others(size_t bytes, const Capacities& capacities = much,
                       const EventLog::Refuses& refuses = {}) {
  Block learnt(bytes);
  LearningExtractor<Index> extractor;
  extractor.learn_in(learnt.memory());
  for (const Border border : {Border::closed, Border::open})
    for (const bool takes_fragments : {true, false})
      for (const BitVolume& volume : volumes()) {
        Plan plan;
        plan.border = border;
        plan.takes_fragments = takes_fragments;
        Extractor<Index> other;
        const EventLog expected = scanned(other, volume, plan, capacities);
        CHECK(scanned(extractor, volume, plan, capacities, refuses).events == expected.events);
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

TEST_CASE("it does with records for everything, for little, and for all but the worst rows") {
  for (const uint32_t records : {60U, 200U, 500U, 1100U, 1200U, 1300U, 1500U, 2000U, 3000U}) {
    CAPTURE(records);
    check_like_others<uint16_t>(1 << 16, {records, 10});
    check_like_others<uint32_t>(1 << 16, {records, 10});
  }
}

TEST_CASE("it does wherever the sink says not now") {
  const auto refuses_some = [](uint64_t offer) { return offer * 0x9E3779B97F4A7C15 >> 62 == 0; };
  for (const Capacities& capacities : {much, Capacities{1200, 10}}) {
    check_like_others<uint32_t>(1 << 16, capacities, refuses_first);
    check_like_others<uint32_t>(1 << 16, capacities, refuses_some);
  }
}

TEST_CASE("it gives the same normals") {
  using Normals = GradientNormals<uint8_t>;
  const Limits limits{20, 30};
  std::vector<uint8_t> samples(20 * 30 * 10);
  for (size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<uint8_t>(i * i >> 7);
  Block learnt(1 << 16), block(arena_bytes);
  LearningExtractor<uint32_t, Normals> learning;
  Extractor<uint32_t, Normals> other;
  learning.learn_in(learnt.memory());
  EventLog log, expected;
  const auto scan_samples = [&](auto& extractor, EventLog& into) {
    require_ok(extractor.start(limits, much, 100, block.memory(), sink_to(into)));
    push_all(extractor, samples);
    finish_all(extractor);
  };
  scan_samples(learning, log);
  scan_samples(other, expected);
  CHECK(expected.events.size() > 1000);
  CHECK(log.events == expected.events);
}

TEST_CASE("an extractor learns in memory with any alignment, and may begin anew in other memory") {
  const BitVolume volume = random({20, 20, 9}, 100, 3);
  EventLog expected;
  scan_into<uint32_t>(expected, volume, {}, much);
  LearningExtractor<uint32_t> extractor;
  for (size_t offset = 0; offset < 5; ++offset) {
    Block learnt(5000);
    const Memory all = learnt.memory();
    extractor.learn_in({static_cast<uint8_t*>(all.data) + offset, all.bytes - offset});
    CHECK(scanned(extractor, volume, {}).events == expected.events);
    CHECK(learnt.is_intact());
  }
  extractor.learn_in({nullptr, 0});
  CHECK(scanned(extractor, volume, {}).events == expected.events);
}

TEST_CASE("what is learnt is no part of a checkpoint") {
  const BitVolume volume = random({16, 16, 8}, 100, 4);
  const auto half = static_cast<uint32_t>(volume.on.size() / 2);
  EventLog log, expected;
  scan_into<uint32_t>(expected, volume, {}, much);
  Block block(arena_bytes);
  auto checkpoint = std::make_unique<Checkpoint<LearningExtractor<uint32_t>>>();
  {
    Block learnt(1 << 16);
    LearningExtractor<uint32_t> before{};
    before.learn_in(learnt.memory());
    require_ok(before.start({16, 16}, much, 1, block.memory(), sink_to(log)));
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
  trace::SweepCounts counts;
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
    const bool has_learnt = std::any_of(memory.begin(), memory.end(), is_written);
    if (bytes < 2 * entry) CHECK(!has_learnt);
    if (bytes >= 2 * entry + most_lost) CHECK(has_learnt);
    CHECK(memory.back() == 0xA5);
  }
}

namespace {

// A chain that begins somewhere and goes on straight at one end, link by link.
class StraightChain {
 public:
  using Chains = trace::Fragments<uint32_t, NoNormal>;

  // along: the chain's links; is_tail: it is the tail that goes on, else the begin.
  StraightChain(Incidence incidence, Link along, bool is_tail)
      : vertex_{0, 0, 0}, is_tail_(is_tail) {
    chains_.start(records_.data(), static_cast<uint32_t>(records_.size()), queues_, true);
    chains_.clear();
    pass_ = {incidence, along, along, along, begins, tails, true, trace::Pass::ahead};
    chains_.take(pass_, vertex_, NoNormals{});
    pass_.in = pass_.out = is_tail ? tails : begins;
    pass_.comes_from_ahead = !is_tail;
    pass_.flags = is_tail ? trace::Pass::ahead : uint8_t{0};
  }
  void go_on(bool amply) {
    move(vertex_, pass_.first, is_tail_ ? 1U : 0U - 1U);
    if (amply)
      chains_.take_amply(pass_, vertex_, NoNormals{});
    else
      chains_.take(pass_, vertex_, NoNormals{});
  }
  uint32_t records() const { return chains_.records().in_use(); }

 private:
  static constexpr uint8_t begins = 0, tails = 1;

  std::vector<trace::Record<uint32_t, NoNormal>> records_{2000};
  trace::Queue<uint32_t> queues_[trace::queue_count];
  Chains chains_;
  trace::Pass pass_;
  Vertex vertex_;
  bool is_tail_;
};

// Voxels in steps that descend along x as z ascends: its sides have some 2,040 links (-1, 0, 1).
// The last slices are alike.
BitVolume stairs() {
  const Size size{1022, 1, 1034};
  BitVolume volume(size);
  for (size_t z = 0; z < size.depth; ++z)
    for (size_t x = 0; x < size.width; ++x) {
      const size_t away = x + std::min<size_t>(z, 1022);
      volume.on[z * size.width + x] = away >= 1021 && away <= 1023 ? 1 : 0;
    }
  return volume;
}

}  // namespace

TEST_CASE("a side is broken off at the same vertex, whatever the supply") {
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    for (Direction i = 0; i < direction_count(incidence); ++i)
      for (const bool is_tail : {false, true}) {
        const Link along = link_of(incidence, i);
        StraightChain ample(incidence, along, is_tail), scarce(incidence, along, is_tail);
        uint32_t unlike = 0;
        for (uint32_t links = 1; links < 10000 && unlike == 0; ++links) {
          ample.go_on(true);
          scarce.go_on(false);
          if (ample.records() != scarce.records()) unlike = links;
        }
        CAPTURE(static_cast<int>(along));
        CAPTURE(is_tail);
        CHECK(unlike == 0);
      }
}

TEST_CASE("sides as long as may be change nothing") {
  const BitVolume volume = stairs();
  Plan plan;
  plan.takes_fragments = false;
  Extractor<uint16_t> other;
  LearningExtractor<uint16_t> extractor;
  Block learnt(1 << 16);
  extractor.learn_in(learnt.memory());
  constexpr Capacities little{703, 10};
  CHECK(scanned(extractor, volume, plan, little).events ==
        scanned(other, volume, plan, little).events);
}
