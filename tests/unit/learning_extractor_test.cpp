// An extractor for hosts says what any other says, whatever it has learnt, and wherever it hands
// its fragments over.
#include <doctest/doctest.h>

#include <discmc/learning_extractor.hpp>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "oracle/event_log.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// With so many records corners are kept, in the rings of the queues and in half as many at least.
constexpr Capacities much{60000, 100};
constexpr uint32_t least_for_corners = 37120;

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

// The events of an extractor, which may learn.
template <class Extractor>
EventLog scanned(Extractor& extractor, const BitVolume& volume, const Plan& plan,
                 const Capacities& capacities = much, const EventLog::Refuses& refuses = {}) {
  EventLog log(refuses);
  const Limits limits = limits_of(volume, plan.border);
  Block block(bytes_for<uint32_t>(limits, capacities));
  require_ok(
      extractor.start(limits, capacities, 1, block.memory(), sink_to(log, plan.takes_fragments)));
  push_all(extractor, volume.on);
  finish_all(extractor);
  CHECK(block.is_intact());
  return log;
}

// What any other extractor tells with as much memory as it likes.
EventLog expected_of(const BitVolume& volume, const Plan& plan = {}) {
  Extractor32 extractor;
  return scanned(extractor, volume, plan, {1000000, 1000});
}

void check_like_others(size_t bytes, const Capacities& capacities = much,
                       const EventLog::Refuses& refuses = {}) {
  Block learnt(bytes);
  LearningExtractor extractor;
  extractor.learn_in(learnt.memory());
  for (const Border border : {Border::closed, Border::open})
    for (const bool takes_fragments : {true, false})
      for (const BitVolume& volume : volumes()) {
        Plan plan;
        plan.border = border;
        plan.takes_fragments = takes_fragments;
        Extractor32 other;
        const EventLog expected = scanned(other, volume, plan, capacities);
        CHECK(scanned(extractor, volume, plan, capacities, refuses).events == expected.events);
      }
  CHECK(learnt.is_intact());
}

bool refuses_some(uint64_t offer) {
  return offer * 0x9E3779B97F4A7C15 >> 62 == 0;
}

// With so many records in use more than the least have been taken for queues.
template <class Extractor>
bool has_kept_corners(const Extractor& extractor) {
  return extractor.high_water().records >= least_for_corners / 2;
}

// A scan of a volume with few records beyond the least, so that its fragments are handed over on
// the way.
class HandingOver {
 public:
  HandingOver(const BitVolume& volume, Border border) : volume_(volume) {
    plan_.border = border;
    expected_ = expected_of(volume, plan_);
    extractor_.learn_in(learnt_.memory());
  }
  void check(uint32_t records_beyond, const EventLog::Refuses& refuses = {}) {
    CAPTURE(records_beyond);
    const Capacities capacities{least_for_corners + records_beyond, 1000};
    const EventLog log = scanned(extractor_, volume_, plan_, capacities, refuses);
    CHECK(has_kept_corners(extractor_));
    CHECK(log.events == expected_.events);
  }

 private:
  const BitVolume& volume_;
  Plan plan_;
  EventLog expected_;
  Block learnt_{1 << 16};
  LearningExtractor extractor_;
};

// Walls along a diagonal of the slices, with sides of a thousand links and more, and a little
// noise.
BitVolume walls(Size size) {
  BitVolume volume(size);
  const BitVolume noise = random(size, 1, 7);
  for (size_t i = 0; i < volume.on.size(); ++i) {
    const size_t x = i % size.width, y = i / size.width % size.height;
    volume.on[i] =
        static_cast<uint8_t>(((x + y) % 70 < 3 ? 1 : 0) ^ (i % 32 == 0 ? noise.on[i] : 0));
  }
  return volume;
}

}  // namespace

TEST_CASE("an extractor that learns gives the events of one that does not, from scan to scan") {
  for (const size_t bytes :
       {size_t{0}, size_t{95}, size_t{96}, size_t{1000}, size_t{1} << 16, size_t{1} << 21}) {
    CAPTURE(bytes);
    check_like_others(bytes);
  }
}

TEST_CASE("it does with too few records to keep corners, down to those for little") {
  for (const uint32_t records : {60U, 200U, 1100U, 3000U, least_for_corners - 1})
    check_like_others(1 << 16, {records, 10});
  LearningExtractor extractor;
  (void)scanned(extractor, plate(), {}, {least_for_corners - 1, 10});
  CHECK(!has_kept_corners(extractor));
  (void)scanned(extractor, plate(), {}, {least_for_corners, 10});
  CHECK(has_kept_corners(extractor));
}

TEST_CASE("it does wherever the sink says not now") {
  for (const Capacities& capacities : {much, Capacities{1200, 10}}) {
    check_like_others(1 << 16, capacities, refuses_first);
    check_like_others(1 << 16, capacities, refuses_some);
  }
}

TEST_CASE("it does where one ring alone is refused, whole or behind any of its events") {
  // Two plates, one with a hole: rings with and without holes on their plane.
  BitVolume plates = box({9, 5, 5}, {0, 0, 1}, {8, 4, 1});
  plates.on[plates.index(2, 2, 1)] = 0;
  for (int64_t x = 0; x < 4; ++x) plates.on[plates.index(x, 3, 3)] = 1;
  const EventLog expected = expected_of(plates);
  LearningExtractor extractor;
  for (uint64_t refused = 0; refused < expected.events.size(); ++refused) {
    const auto refuses = [refused](uint64_t offer) { return offer == refused; };
    const EventLog log = scanned(extractor, plates, {}, {least_for_corners, 10}, refuses);
    CHECK(log.events == expected.events);
    CHECK(log.refusals() == 1);
  }
}

TEST_CASE("it does wherever the fragments are handed over") {
  const BitVolume noise = random({150, 110, 4}, 60, 8);
  HandingOver closed(noise, Border::closed), open(noise, Border::open);
  for (uint32_t beyond = 0; beyond < 24000; beyond += 2000) {
    closed.check(beyond);
    open.check(beyond, refuses_some);
  }
}

TEST_CASE("long sides are handed over, too") {
  const BitVolume volume = walls({1400, 900, 2});
  HandingOver scan(volume, Border::closed);
  for (const uint32_t beyond : {0U, 2000U, 5000U, 10000U}) scan.check(beyond);
}

TEST_CASE("the fragments are handed over where slices are too many for a corner's place") {
  const BitVolume column = box({2, 1, 33000}, {0, 0, 0}, {0, 0, 32999});
  for (const Border border : {Border::closed, Border::open}) HandingOver(column, border).check(0);
}

TEST_CASE("a slab is scanned as by any other") {
  const BitVolume volume = random({20, 20, 9}, 100, 3);
  Limits limits = limits_of(volume, Border::closed);
  limits.slab = {3, true, true};
  const auto scanned_slab = [&](auto& extractor) {
    EventLog log;
    Block block(bytes_for<uint32_t>(limits, much));
    require_ok(extractor.start(limits, much, 1, block.memory(), sink_to(log)));
    push_all(extractor, volume.on);
    finish_all(extractor);
    return log.events;
  };
  Extractor32 other;
  LearningExtractor extractor;
  CHECK(scanned_slab(extractor) == scanned_slab(other));
}

TEST_CASE("an extractor learns in memory with any alignment, and may begin anew in other memory") {
  const BitVolume volume = random({20, 20, 9}, 100, 3);
  const EventLog expected = expected_of(volume);
  LearningExtractor extractor;
  for (size_t offset = 0; offset < 5; ++offset) {
    Block learnt(5000);
    const Memory all = learnt.memory();
    auto* const data = static_cast<uint8_t*>(all.data);
    const std::vector<uint8_t> before(data, data + all.bytes);
    extractor.learn_in({data + offset, all.bytes - offset});
    CHECK(scanned(extractor, volume, {}).events == expected.events);
    CHECK_FALSE(std::equal(before.begin(), before.end(), data));
    CHECK(learnt.is_intact());
  }
  extractor.learn_in({nullptr, 0});
  CHECK(scanned(extractor, volume, {}).events == expected.events);
}

TEST_CASE("a scan that breaks off where the sink says not now leaves nothing to the next") {
  const BitVolume volume = random({70, 9, 5}, 100, 4);
  for (const Border border : {Border::closed, Border::open}) {
    Plan plan;
    plan.border = border;
    const EventLog expected = expected_of(volume, plan);
    for (const uint64_t last : {0U, 300U, 2000U}) {
      CAPTURE(last);
      bool is_first_scan = true;
      EventLog log([&](uint64_t offer) { return is_first_scan && offer >= last; });
      const Limits limits = limits_of(volume, border);
      Block block(bytes_for<uint32_t>(limits, much));
      LearningExtractor extractor;
      require_ok(extractor.start(limits, much, 1, block.memory(), sink_to(log)));
      const auto samples = static_cast<uint32_t>(volume.voxels());
      CHECK(extractor.push(volume.on.data(), samples).status == Status::more);
      is_first_scan = false;
      for (int scan = 0; scan < 2; ++scan) {
        EventLog next;
        require_ok(extractor.start(limits, much, 1, block.memory(), sink_to(next)));
        push_all(extractor, volume.on);
        finish_all(extractor);
        CHECK(next.events == expected.events);
      }
    }
  }
}

TEST_CASE("a checkpoint has the corners, and nothing of what is learnt") {
  const BitVolume volume = random({30, 30, 8}, 100, 4);
  const Limits limits = limits_of(volume, Border::closed);
  const auto slice = static_cast<uint32_t>(volume.width) * volume.height;
  const EventLog expected = expected_of(volume);
  auto checkpoint = std::make_unique<Checkpoint<LearningExtractor>>();
  for (const uint32_t cut : {slice, 4 * slice + 7 * volume.width, 7 * slice}) {
    EventLog log;
    Block block(bytes_for<uint32_t>(limits, much));
    Block elsewhere(block.memory().bytes);
    {
      Block learnt(1 << 16);
      LearningExtractor before{};
      before.learn_in(learnt.memory());
      require_ok(before.start(limits, much, 1, block.memory(), sink_to(log)));
      require_ok(before.push(volume.on.data(), cut).status);
      require_ok(before.save(*checkpoint));
      const auto* const saved = reinterpret_cast<const uint8_t*>(checkpoint.get());
      for (size_t at = 0; at + sizeof(uintptr_t) <= sizeof *checkpoint; ++at) {
        uintptr_t word;
        std::memcpy(&word, saved + at, sizeof word);
        CHECK(word - reinterpret_cast<uintptr_t>(learnt.memory().data) >= (1 << 16));
      }
      std::copy_n(static_cast<const uint8_t*>(block.memory().data), before.bytes_used(),
                  static_cast<uint8_t*>(elsewhere.memory().data));
    }
    LearningExtractor after;
    require_ok(after.restore(*checkpoint, elsewhere.memory(), sink_to(log)));
    require_ok(after.push(volume.on.data() + cut, 8 * slice - cut).status);
    finish_all(after);
    CHECK(log.events == expected.events);
  }
}

TEST_CASE("a checkpoint of a slab does not tell where the program lies") {
  const BitVolume volume = random({20, 20, 9}, 100, 3);
  Limits limits = limits_of(volume, Border::closed);
  limits.slab = {3, true, true};
  const auto check = [&](auto extractor, auto address) {
    EventLog log;
    Block block(bytes_for<uint32_t>(limits, much));
    require_ok(extractor->start(limits, much, 1, block.memory(), sink_to(log)));
    require_ok(extractor->push(volume.on.data(), 1000).status);
    using Saved = Checkpoint<std::remove_reference_t<decltype(*extractor)>>;
    const auto checkpoint = std::make_unique<Saved>();
    require_ok(extractor->save(*checkpoint));
    const auto* const bytes = reinterpret_cast<const uint8_t*>(checkpoint.get());
    const auto* const searched = reinterpret_cast<const uint8_t*>(&address);
    const uint8_t* const end = bytes + sizeof *checkpoint;
    CHECK(std::search(bytes, end, searched, searched + sizeof address) == end);
  };
  const trace::Fragments<uint32_t, NoNormal>::AtSeam address =
      trace::Fragments<uint32_t, NoNormal>::cut_at_seam;
  check(std::make_unique<Extractor32>(), address);
  check(std::make_unique<LearningExtractor>(), address);
}
