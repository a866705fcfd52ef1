// The extractor's statuses, counters and memory: misuse, long scans, and several at a time.
#include <discmc/encoder.hpp>

#include <new>

#include "oracle/agreement.hpp"
#include "oracle/bench.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// Ignores events, and counts the regions.
struct Counter {
  uint64_t regions = 0;
  uint64_t layers = 0;
  int32_t top = INT32_MIN;
  SinkResult accept(const Event& event) {
    regions += event.kind == Event::Kind::region_end;
    layers += event.kind == Event::Kind::layer;
    if (event.kind == Event::Kind::ring) top = std::max(top, event.start.z);
    return SinkResult::accepted;
  }
};

// Whether an object constructed in zeroed memory leaves the memory zero.
template <class Object>
bool begins_as_zero() {
  std::vector<uint64_t> place(sizeof(Object) / sizeof(uint64_t) + 1);
  static_assert(alignof(Object) <= alignof(uint64_t), "it fits there");
  new (place.data()) Object;
  return std::all_of(place.begin(), place.end(), [](uint64_t word) { return word == 0; });
}

EventLog events_of(const BitVolume& volume) {
  EventLog log;
  scan_into<uint32_t>(log, volume, {}, ample);
  return log;
}

template <class Index>
void check_refused_starts() {
  EventLog log;
  const Sink sink = make_sink(log);
  Block block(1 << 16);
  const Memory memory = block.memory();
  const Limits good{8, 8};
  Extractor<Index> extractor;
  CHECK(extractor.start({0, 8}, 1, memory, sink) == Status::bad_limits);
  CHECK(extractor.start({8, 0}, 1, memory, sink) == Status::bad_limits);
  CHECK(extractor.start({32767, 1}, 1, memory, sink) == Status::bad_limits);
  CHECK(extractor.start({1, UINT32_MAX}, 1, memory, sink) == Status::bad_limits);
  CHECK(extractor.start({8, 8, static_cast<Border>(2)}, 1, memory, sink) == Status::bad_limits);
  CHECK(extractor.start(good, 1, memory, Sink{}) == Status::bad_sink);
  const auto minimum = static_cast<size_t>(Extractor<Index>::minimum_bytes(good));
  CHECK(extractor.start(good, 1, {memory.data, minimum - 1}, sink) == Status::too_little_memory);
  CHECK(extractor.start(good, 1, {memory.data, 0}, sink) == Status::too_little_memory);
  CHECK(extractor.start(good, 1, {nullptr, 1 << 16}, sink) == Status::too_little_memory);
  for (const uint32_t slots : {minimum_capacities().slots - 1, UINT32_MAX})
    CHECK(extractor.start(good, {slots, 0}, 1, memory, sink) == Status::bad_capacities);
  for (const Slab& slab : {Slab{1, false, false}, Slab{0, true, false}})
    CHECK(extractor.start({8, 8, {}, slab}, 1, memory, sink) == Status::bad_limits);
  CHECK(extractor.start({32766, 32766}, 1, memory, sink) == Status::too_little_memory);
  // The memory is unchanged.
  Block untouched(1 << 16);
  const auto* bytes = static_cast<const uint8_t*>(memory.data);
  CHECK(std::equal(bytes, bytes + (1 << 16), static_cast<uint8_t*>(untouched.memory().data)));
  CHECK(extractor.finish() == Status::not_started);
  CHECK(extractor.start(good, 1, {memory.data, minimum}, sink) == Status::ok);
  CHECK(log.events.size() == 0);
}

}  // namespace

TEST_CASE("an invalid start() is refused and leaves the memory unchanged") {
  check_refused_starts<uint16_t>();
  check_refused_starts<uint32_t>();
}

TEST_CASE("an extractor returns not_started from every call before start()") {
  Extractor16 extractor;
  const uint8_t sample = 1;
  CHECK(extractor.push(&sample, 1).status == Status::not_started);
  CHECK(extractor.push(&sample, 0).status == Status::not_started);
  CHECK(extractor.push_bits(&sample).status == Status::not_started);
  CHECK(extractor.skip_row(Substitute::off).status == Status::not_started);
  CHECK(extractor.resume() == Status::not_started);
  CHECK(extractor.finish() == Status::not_started);
  CHECK(extractor.abandon() == Status::not_started);
  CHECK(extractor.reset() == Status::not_started);
}

TEST_CASE("after finish() push() returns finished, and a second finish() has no effect") {
  for (const bool abandon : {false, true}) {
    const uint8_t samples[9] = {0, 0, 0, 0, 1, 0, 0, 0, 0};
    Bench<uint16_t> bench({3, 3});
    CHECK(bench.extractor.push(samples, 9).status == Status::ok);
    CHECK((abandon ? bench.extractor.abandon() : bench.extractor.finish()) == Status::ok);
    const uint64_t events = bench.log.events.size();
    for (const PushResult result :
         {bench.extractor.push(samples, 9), bench.extractor.push(samples, 0),
          bench.extractor.push_bits(samples), bench.extractor.skip_row(Substitute::previous_row)}) {
      CHECK(result.status == Status::finished);
      CHECK(result.samples == 0);
    }
    CHECK(bench.extractor.finish() == Status::ok);
    CHECK(bench.extractor.abandon() == Status::ok);
    CHECK(bench.extractor.resume() == Status::ok);
    CHECK(bench.log.events.size() == events);
    CHECK(collected(bench.log.events).was_abandoned() == abandon);
    CHECK(bench.extractor.statistics().regions == 8);
  }
}

TEST_CASE("a start() with too little memory ends the previous scan") {
  Bench<uint16_t> bench({3, 3});
  Block block(1 << 14);
  CHECK(bench.extractor.start({3000, 3000}, 1, block.memory(), make_sink(bench.log)) ==
        Status::too_little_memory);
  CHECK(bench.extractor.finish() == Status::not_started);
  CHECK(bench.extractor.reset() == Status::not_started);
}

TEST_CASE(
    "start() with an unstarted sink ends the previous scan, and other errors preserve the scan") {
  const BitVolume volume = random({3, 3, 2}, 128, 4);
  EventLog log;
  Block block(1 << 14), other(1 << 14);
  const Memory memory = other.memory();
  struct Closed {
    SinkResult accept(const Event&) { return SinkResult::not_started; }
  } closed;
  Extractor16 extractor;
  require_ok(extractor.start({3, 3}, 1, block.memory(), make_sink(log)));
  require_ok(extractor.push(volume.on.data(), 4).status);
  CHECK(extractor.start({0, 3}, 1, memory, make_sink(closed)) == Status::bad_limits);
  CHECK(extractor.start({4, 4}, {0, 0}, 1, memory, make_sink(closed)) == Status::bad_capacities);
  CHECK(extractor.start({4, 4}, 1, memory, Sink{}) == Status::bad_sink);
  require_ok(extractor.push(volume.on.data() + 4, 14).status);
  require_ok(extractor.finish());
  CHECK(log.events == events_of(volume).events);
  require_ok(extractor.reset());
  const auto* const bytes = static_cast<const uint8_t*>(memory.data);
  const std::vector<uint8_t> untouched(bytes, bytes + memory.bytes);
  CHECK(extractor.start({4, 4}, 1, memory, make_sink(closed)) == Status::bad_sink);
  CHECK(std::equal(untouched.begin(), untouched.end(), bytes));
  CHECK(extractor.finish() == Status::not_started);
}

TEST_CASE("reset() has no effect if the sink is not started") {
  const BitVolume volume = random({3, 3, 2}, 128, 4);
  struct Once {
    SinkResult accept(const Event& event) {
      const bool is_start = event.kind == Event::Kind::start;
      return is_start && starts++ > 0 ? SinkResult::not_started : log.accept(event);
    }
    int starts = 0;
    EventLog log{};
  } sink;
  Block block(1 << 14);
  Extractor16 extractor;
  require_ok(extractor.start({3, 3}, 1, block.memory(), make_sink(sink)));
  require_ok(extractor.push(volume.on.data(), 13).status);
  CHECK(extractor.reset() == Status::bad_sink);
  require_ok(extractor.push(volume.on.data() + 13, 5).status);
  require_ok(extractor.finish());
  CHECK(sink.log.events == events_of(volume).events);
}

TEST_CASE("finish() in the middle of a slice is refused and has no effect") {
  const BitVolume volume = random({3, 3, 2}, 128, 4);
  Bench<uint16_t> bench({3, 3});
  for (uint32_t i = 0; i < 18; ++i) {
    CHECK(bench.extractor.finish() == (i == 0 || i == 9 ? Status::ok : Status::slice_in_progress));
    if (i == 0 || i == 9) {
      // The scan ended here: begins again with the same samples.
      REQUIRE(collected(bench.log.events).is_finished());
      bench.log = EventLog();
      require_ok(bench.extractor.reset());
      CHECK(bench.extractor.push(volume.on.data(), i).samples == i);
    }
    CHECK(bench.extractor.push(volume.on.data() + i, 1).samples == 1);
    CHECK(bench.extractor.rows() == (i + 1) % 9 / 3);
    CHECK(bench.extractor.slices() == (i + 1) / 9);
  }
  require_ok(bench.extractor.finish());
  CHECK(bench.log.events == events_of(volume).events);
}

TEST_CASE("push_bits() and skip_row() in the middle of a row are refused and have no effect") {
  const BitVolume volume = random({5, 3, 2}, 128, 4);
  Bench<uint16_t> bench({5, 3});
  const uint8_t bits = 0x1F;
  for (uint32_t i = 0; i < 30; ++i) {
    if (i % 5 != 0) {
      CHECK(bench.extractor.push_bits(&bits).status == Status::row_in_progress);
      CHECK(bench.extractor.push_bits(&bits).samples == 0);
      CHECK(bench.extractor.skip_row(Substitute::off).status == Status::row_in_progress);
      CHECK(bench.extractor.skip_row(Substitute::previous_row).samples == 0);
    }
    CHECK(bench.extractor.push(volume.on.data() + i, 1).samples == 1);
    CHECK(bench.extractor.resume() == Status::ok);
    CHECK(bench.extractor.push(volume.on.data(), 0).status == Status::ok);
  }
  finish_all(bench.extractor);
  CHECK(bench.log.events == events_of(volume).events);
}

TEST_CASE("a scan without slices yields an empty surface") {
  for (const Border border : {Border::closed, Border::open})
    for (const Size size : {Size{1, 1, 0}, Size{5, 3, 0}}) {
      Bench<uint16_t> bench({size.width, size.height, border});
      finish_all(bench.extractor);
      REQUIRE(bench.log.events.size() == 1);
      CHECK(bench.log.events[0].is(Event::Kind::finish));
    }
}

TEST_CASE("a single voxel, row, column or slice with an open border has no surface") {
  for (const Size size : {Size{1, 1, 1}, Size{1, 1, 6}, Size{1, 6, 1}, Size{6, 1, 1}, Size{1, 5, 6},
                          Size{5, 1, 6}, Size{5, 6, 1}}) {
    const BitVolume volume = random(size, 128, 3);
    const Collector collector = scan<uint16_t>(volume, {Border::open, 1});
    CHECK(collector.regions().empty());
    CHECK(collector.layers().size() == size.depth);
    CHECK(collector.statistics().cells == 0);
  }
}

TEST_CASE("each period of a scan of 100,000 thin slices yields the same number of regions") {
  for (const Border border : {Border::closed, Border::open})
    for (const Limits limits : {Limits{1, 1, border}, Limits{2, 2, border}, Limits{3, 1, border}}) {
      const uint32_t slice = limits.width * limits.height;
      // An even number of slices is a period, so every period has the same number of regions.
      std::vector<uint8_t> period(slice * 4, 0);
      std::fill_n(period.begin() + slice, 2 * slice - 1, uint8_t{1});
      Counter counter;
      Block block(Extractor16::minimum_bytes(limits) + 8000);
      Extractor16 extractor;
      require_ok(extractor.start(limits, 1, block.memory(), make_sink(counter)));
      std::vector<uint64_t> regions;
      for (uint32_t i = 0; i < 25000; ++i) {
        require_ok(extractor.push(period.data(), 4 * slice).status);
        if (i % 1000 == 0) regions.push_back(counter.regions);
      }
      finish_all(extractor);
      CHECK(extractor.slices() == 100000);
      CHECK(counter.layers == 100000);
      for (size_t i = 2; i < regions.size(); ++i)
        CHECK(regions[i] - regions[i - 1] == regions[2] - regions[1]);
      if (border == Border::closed) CHECK(counter.top > 2 * 99990);
    }
}

TEST_CASE("a surface across 100,000 slices needs only a few bytes of memory") {
  Bench<uint16_t> bench({3, 3}, 1, 8000);
  const std::vector<uint8_t> slice(9, 1);
  for (uint32_t i = 0; i < 100000; ++i) require_ok(bench.extractor.push(slice.data(), 9).status);
  finish_all(bench.extractor);
  CHECK(collected(bench.log.events).regions().size() == 26);
}

TEST_CASE("a slab's finish event counts the slab's own slices, which add up to the depth") {
  const BitVolume volume = random({5, 5, 20}, 128, 3);
  struct Last {
    uint32_t slices = 0;
    SinkResult accept(const Event& event) {
      if (event.kind == Event::Kind::finish) slices = event.slice;
      return SinkResult::accepted;
    }
  };
  const auto slices_of = [&](const Slab& slab, uint32_t from, uint32_t to) {
    const Limits limits{5, 5, {}, slab};
    Last last;
    Block block(Extractor16::minimum_bytes(limits) + 4000);
    Extractor16 extractor;
    require_ok(extractor.start(limits, 1, block.memory(), make_sink(last)));
    for (uint32_t z = from; z < to; ++z)
      require_ok(extractor.push(volume.on.data() + size_t{z} * 25, 25).status);
    finish_all(extractor);
    return last.slices;
  };
  CHECK(slices_of({}, 0, 20) == 20);
  CHECK(slices_of({0, false, true}, 0, 8) == 7);
  CHECK(slices_of({7, true, true}, 6, 13) == 5);
  CHECK(slices_of({12, true, false}, 11, 20) == 8);
  CHECK(slices_of({7, true, true}, 6, 7) == 0);
}

TEST_CASE("the memory of an extractor may begin at any address") {
  const BitVolume volume = random({9, 8, 7}, 100, 1);
  const Limits limits = limits_of(volume, Border::closed);
  const EventLog expected = events_of(volume);
  for (size_t offset = 0; offset < 4; ++offset) {
    const size_t bytes = Extractor16::bytes_for(limits, ample);
    std::vector<uint8_t> memory(bytes + offset + 8, 0x5A);
    EventLog log;
    Extractor16 extractor;
    require_ok(extractor.start(limits, ample, 1, {memory.data() + offset, bytes}, make_sink(log)));
    push_all(extractor, volume.on);
    finish_all(extractor);
    CHECK(log.events == expected.events);
    CHECK(std::count(memory.end() - 8, memory.end(), uint8_t{0x5A}) == 8);
  }
}

TEST_CASE("bytes_used() is the high-water mark, and memory beyond the mark is unchanged") {
  const BitVolume volume = random({9, 8, 7}, 100, 1);
  const Limits limits = limits_of(volume, Border::closed);
  const size_t bytes = Extractor16::bytes_for(limits, ample);
  std::vector<uint8_t> memory(bytes, 0x5A);
  EventLog log;
  Extractor16 extractor;
  CHECK(extractor.bytes_used() == 0);
  require_ok(extractor.start(limits, ample, 1, {memory.data(), bytes}, make_sink(log)));
  size_t used = extractor.bytes_used();
  CHECK(used <= Extractor16::minimum_bytes(limits));
  for (const uint8_t sample : volume.on) {
    require_ok(extractor.push(&sample, 1).status);
    CHECK(extractor.bytes_used() >= used);
    used = extractor.bytes_used();
  }
  finish_all(extractor);
  used = extractor.bytes_used();
  CHECK(used == Extractor16::bytes_for(limits, {extractor.peaks().slots, 0}));
  CHECK(std::count(memory.begin() + static_cast<ptrdiff_t>(used), memory.end(), uint8_t{0x5A}) ==
        static_cast<ptrdiff_t>(bytes - used));
  require_ok(extractor.reset());
  CHECK(extractor.bytes_used() < used);
}

TEST_CASE("peaks are within the capacities and suffice as capacities for the same scan") {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const BitVolume volume = random({12, 9, 7}, 60 + 10 * static_cast<uint32_t>(seed), seed);
    const Limits limits = limits_of(volume, Border::closed);
    const auto scan_in = [&](const Capacities& capacities, EventLog& log) {
      Block block(Extractor16::bytes_for(limits, capacities));
      Extractor16 extractor;
      require_ok(extractor.start(limits, capacities, 1, block.memory(), make_sink(log)));
      push_all(extractor, volume.on);
      finish_all(extractor);
      CHECK(extractor.capacities().slots == capacities.slots);
      CHECK(extractor.peaks().slots <= capacities.slots);
      CHECK(extractor.peaks().holes <= capacities.holes);
      return extractor.peaks();
    };
    EventLog in_ample, in_few;
    const Peaks needed = scan_in(ample, in_ample);
    CHECK(needed.slots > 50);
    (void)scan_in({needed.slots / 2, needed.holes / 2}, in_few);
    CHECK(collected(in_few.events).loose().size() > 0);
  }
}

TEST_CASE("default-constructed objects are all zeros") {
  CHECK(begins_as_zero<Extractor16>());
  CHECK(begins_as_zero<Encoder>());
}
