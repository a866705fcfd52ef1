// Extractors of every kind deliver the same events in C and in C++.
#include <discmc/discmc.h>

#include <discmc/c/extractor_kind.hpp>

#include "oracle/c_events.hpp"
#include "oracle/normal_events.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::uneven_spacing;

namespace {

constexpr uint32_t width = 21, height = 17, depth = 13;
constexpr int32_t threshold = 100;
constexpr uint32_t lost_row = 40;  // of all rows

// Walls with noise: the volume has holes, and needs more than little memory.
template <class Sample>
std::vector<Sample> make_samples() {
  std::vector<Sample> samples(size_t{width} * height * depth);
  test::Chance chance(7);
  for (size_t i = 0; i < samples.size(); ++i) {
    const size_t x = i % width, y = i / width % height;
    const bool is_wall = x > 4 && x < 17 && y > 3 && y < 14;
    samples[i] = static_cast<Sample>((is_wall ? 90 : 20) + chance.below(32));
  }
  return samples;
}

// ---- a scan in C ----

struct Scan {
  Scan(const discmc_extractor_kind& kind, uint64_t bytes, EventLog& log, uint32_t slots = 0)
      : memory(bytes) {
    config.kind = &kind;
    config.limits = {width, height, DISCMC_CLOSED};
    config.threshold = threshold;
    std::copy_n(uneven_spacing, 3, config.spacing_nm);
    config.slots = slots;
    config.memory = {memory.memory().data, bytes};
    config.sink = c_sink_to(log);
  }

  void start() { REQUIRE(discmc_extractor_start(&extractor, &config) == DISCMC_OK); }
  discmc_status done(discmc_status status) {
    return completed(status, [this] { return discmc_extractor_resume(extractor); });
  }
  template <class Sample>
  void push_rows(discmc_sample_type type, const std::vector<Sample>& rows, uint32_t first,
                 uint32_t end) {
    const size_t row_samples = rows.size() / (height * depth);
    for (uint32_t row = first; row < end; ++row) {
      const discmc_push_result result =
          row == lost_row
              ? discmc_extractor_skip_row(extractor, DISCMC_SUBSTITUTE_PREVIOUS_ROW)
              : discmc_extractor_push(extractor, type, &rows[row * row_samples], width, 1);
      REQUIRE(result.accepted == width);
      REQUIRE(done(result.status) == DISCMC_OK);
    }
  }
  discmc_extractor_info info() const { return discmc_extractor_get_info(extractor); }

  Block memory;
  discmc_extractor_config config{};
  discmc_extractor* extractor = nullptr;
};

// ---- the same scan in C++ ----

template <class Scanner, class Sample>
void scan_in_cpp(Scanner& scanner, const Limits& limits, const Capacities& capacities,
                 EventLog& log) {
  const auto samples = make_samples<Sample>();
  static std::vector<uint8_t> memory(size_t{8} << 20);
  require_ok(
      scanner.start(limits, capacities, threshold, {memory.data(), memory.size()}, make_sink(log)));
  for (uint32_t row = 0; row < height * depth; ++row) {
    const PushResult result = row == lost_row ? scanner.skip_row(Substitute::previous_row)
                                              : scanner.push(&samples[size_t{row} * width], width);
    Status status = result.status;
    while (status == Status::suspended) status = scanner.resume();
    require_ok(status);
  }
  finish_all(scanner);
}

template <class Scanner>
std::unique_ptr<Scanner> make_scanner() {
  auto scanner = std::make_unique<Scanner>();
  if constexpr (!std::is_same_v<Scanner, Extractor16>) scanner->set_spacing(uneven_spacing);
  return scanner;
}

// Scans in C, with a power failure in between, and compares with C++.
template <class Scanner, class Sample, class Row = Sample>
void compare(const discmc_extractor_kind& kind, discmc_sample_type type,
             const std::vector<Row>& rows, uint64_t spare) {
  EventLog log(refuses_first);
  Scan first(kind, 0, log);
  const uint64_t bytes = discmc_extractor_bytes(&first.config) + spare;
  Scan scan(kind, bytes, log);
  scan.start();
  scan.push_rows(type, rows, 0, 60);
  discmc_memory part;
  REQUIRE(discmc_extractor_save(scan.extractor, &part) == DISCMC_OK);
  CHECK(part.data == scan.config.memory.data);
  CHECK(part.bytes == scan.info().bytes_used);

  Scan later(kind, bytes, log);
  CHECK(discmc_extractor_restore(&later.extractor, &later.config) == DISCMC_BAD_CHECKPOINT);
  auto* const copy = static_cast<uint8_t*>(later.config.memory.data);
  std::copy_n(static_cast<uint8_t*>(part.data), part.bytes, copy);
  auto* const object = copy + (reinterpret_cast<uint8_t*>(scan.extractor) -
                               static_cast<uint8_t*>(scan.config.memory.data));
  std::fill(object + sizeof(uint32_t), object + sizeof(KindObject), uint8_t{0});  // its addresses
  REQUIRE(discmc_extractor_restore(&later.extractor, &later.config) == DISCMC_OK);
  CHECK(later.info().bytes_used == part.bytes);
  std::fill_n(static_cast<uint8_t*>(part.data), bytes, uint8_t{0xFF});
  CHECK(later.info().slices == 60 / height);
  CHECK(later.info().rows == 60 % height);
  later.push_rows(type, rows, 60, height * depth);
  CHECK(discmc_extractor_finish(later.extractor) == DISCMC_SUSPENDED);
  REQUIRE(later.done(DISCMC_SUSPENDED) == DISCMC_OK);
  CHECK((scan.memory.is_intact() && later.memory.is_intact()));

  const auto scanner = make_scanner<Scanner>();
  const discmc_extractor_info info = later.info();
  EventLog expected;
  scan_in_cpp<Scanner, Sample>(*scanner, {width, height}, {info.slots, info.holes}, expected);
  CHECK(log.events == expected.events);
  CHECK(are_equal(log.starts.back(), expected.starts.back()));
  CHECK(counts(from_c(info.statistics)) == counts(scanner->statistics()));
  CHECK(info.statistics.skipped_rows == 1);
  CHECK(info.slices == depth);
  CHECK(info.peak_slots == scanner->peaks().slots);
  CHECK(info.peak_holes == scanner->peaks().holes);
}

template <class Sample>
void compare_normals(const discmc_extractor_kind& kind, discmc_sample_type type) {
  using Scanner = NormalExtractor16<Sample>;
  compare<Scanner, Sample>(kind, type, make_samples<Sample>(), 0);
  compare<Scanner, Sample>(kind, type, make_samples<Sample>(), 20000);
}

}  // namespace

TEST_CASE("plain extractors in C deliver the events of an Extractor16") {
  for (const uint64_t spare : {uint64_t{0}, uint64_t{20000}}) {
    compare<Extractor16, uint8_t>(discmc_plain_u8, DISCMC_U8, make_samples<uint8_t>(), spare);
    compare<Extractor16, uint16_t>(discmc_plain_u16, DISCMC_U16, make_samples<uint16_t>(), spare);
    compare<Extractor16, int16_t>(discmc_plain_i16, DISCMC_I16, make_samples<int16_t>(), spare);
    compare<Extractor16, uint8_t>(discmc_plain_bits, DISCMC_BITS,
                                  bits_of(make_samples<uint8_t>(), width, {threshold}), spare);
  }
}

TEST_CASE("extractors with normals in C deliver the events of extractors with normals in C++") {
  compare_normals<uint8_t>(discmc_normals_u8, DISCMC_U8);
  compare_normals<uint16_t>(discmc_normals_u16, DISCMC_U16);
  compare_normals<int16_t>(discmc_normals_i16, DISCMC_I16);
}

TEST_CASE("a slab in C delivers the events of a slab in C++") {
  EventLog log, expected;
  Scan scan(discmc_plain_u8, 20000, log);
  scan.config.slab.first = 5;
  scan.config.slab.continues_below = 1;
  scan.config.slab.continues_above = 1;
  scan.start();
  scan.push_rows(DISCMC_U8, make_samples<uint8_t>(), 0, height * depth);
  REQUIRE(discmc_extractor_finish(scan.extractor) == DISCMC_OK);
  Extractor16 scanner;
  scan_in_cpp<Extractor16, uint8_t>(scanner, {width, height, Border::closed, {5, true, true}},
                                    {scan.info().slots, scan.info().holes}, expected);
  CHECK(log.events == expected.events);
  CHECK(scan.info().slices == depth);
}

TEST_CASE("an object in C may be placed in memory at any address") {
  EventLog log;
  Scan scan(discmc_plain_u8, 20000, log);
  auto* const data = static_cast<uint8_t*>(scan.config.memory.data);
  for (size_t offset = 0; offset < object_alignment; ++offset) {
    scan.config.memory = {data + offset, 20000 - offset};
    scan.start();
    const auto* const object = reinterpret_cast<uint8_t*>(scan.extractor);
    CHECK(reinterpret_cast<uintptr_t>(object) % object_alignment == 0);
    CHECK((object >= data + offset && object < data + offset + object_alignment));
  }
}

TEST_CASE("an extractor in C with explicit slots has one hole per 16 slots") {
  EventLog log;
  Scan scan(discmc_plain_u8, 20000, log, 165);
  scan.start();
  CHECK(scan.info().slots == 165);
  CHECK(scan.info().holes == 165 / 16);
}

TEST_CASE("extractors in C accept samples with a stride, in portions of any size") {
  const auto samples = make_samples<uint16_t>();
  std::vector<uint16_t> every_third(3 * samples.size());
  for (size_t i = 0; i < samples.size(); ++i) every_third[3 * i] = samples[i];
  EventLog log, strided_log;
  Scan scan(discmc_plain_u16, 20000, log), strided(discmc_plain_u16, 20000, strided_log);
  scan.start();
  strided.start();
  const auto count = static_cast<uint32_t>(samples.size());
  const discmc_push_result all =
      discmc_extractor_push(scan.extractor, DISCMC_U16, samples.data(), count, 1);
  CHECK(all.status == DISCMC_OK);
  CHECK(all.accepted == count);
  for (uint32_t at = 0; at < count; at += 5)
    CHECK(discmc_extractor_push(strided.extractor, DISCMC_U16, &every_third[3 * at],
                                std::min(5U, count - at), 3)
              .status == DISCMC_OK);
  CHECK(strided_log.events == log.events);
}

TEST_CASE("a scan in C begins even if its sink is busy") {
  EventLog log;
  Scan scan(discmc_plain_u8, 20000, log);
  bool is_busy = true;
  const auto answer = [](void* context, const discmc_event*) {
    return static_cast<discmc_sink_result>(*static_cast<bool*>(context) ? DISCMC_SINK_BUSY
                                                                        : DISCMC_SINK_ACCEPTED);
  };
  scan.config.sink = {&is_busy, answer};
  CHECK(discmc_extractor_start(&scan.extractor, &scan.config) == DISCMC_SUSPENDED);
  REQUIRE(scan.extractor != nullptr);
  CHECK(discmc_extractor_resume(scan.extractor) == DISCMC_SUSPENDED);
  is_busy = false;
  CHECK(discmc_extractor_resume(scan.extractor) == DISCMC_OK);
}

TEST_CASE("an abandoned scan in C closes its regions and is reported as abandoned") {
  EventLog log;
  Scan scan(discmc_plain_u8, 20000, log);
  scan.start();
  scan.push_rows(DISCMC_U8, make_samples<uint8_t>(), 0, 3 * height + 5);
  CHECK(discmc_extractor_finish(scan.extractor) == DISCMC_SLICE_IN_PROGRESS);
  CHECK(discmc_extractor_abandon(scan.extractor) == DISCMC_OK);
  CHECK(collected(log.events).was_abandoned());
}

TEST_CASE("reset() in C begins a new scan at any point of the previous scan") {
  EventLog log, again;
  Scan scan(discmc_plain_u8, 20000, log);
  scan.start();
  scan.push_rows(DISCMC_U8, make_samples<uint8_t>(), 0, 100);
  log.events.clear();
  scan.start();
  CHECK(log.starts.size() == 2);
  scan.push_rows(DISCMC_U8, make_samples<uint8_t>(), 0, height * depth);
  Scan other(discmc_plain_u8, 20000, again);
  other.start();
  other.push_rows(DISCMC_U8, make_samples<uint8_t>(), 0, height * depth);
  CHECK(log.events == again.events);
}

TEST_CASE("invalid calls of extractors in C return their status") {
  EventLog log;
  const uint8_t samples[width] = {};
  Scan scan(discmc_plain_u8, 20000, log);
  const discmc_extractor_config good = scan.config;
  const auto status_of = [&](auto change) {
    scan.config = good;
    change(scan.config);
    return discmc_extractor_start(&scan.extractor, &scan.config);
  };
  using Config = discmc_extractor_config;
  CHECK(status_of([](Config& c) { c.limits.width = 0; }) == DISCMC_BAD_LIMITS);
  CHECK(status_of([](Config& c) { c.limits.border = 2; }) == DISCMC_BAD_LIMITS);
  CHECK(status_of([](Config& c) { c.slab.first = 3; }) == DISCMC_BAD_LIMITS);
  CHECK(status_of([](Config& c) { c.slots = 3; }) == DISCMC_BAD_CAPACITIES);
  CHECK(status_of([](Config& c) { c.slots = 32760; }) == DISCMC_BAD_CAPACITIES);
  CHECK(status_of([](Config& c) { c.memory.data = nullptr; }) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(status_of([](Config& c) { c.memory.bytes = 100; }) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(status_of([](Config& c) { c.memory.bytes = discmc_extractor_bytes(&c) - 1; }) ==
        DISCMC_TOO_LITTLE_MEMORY);
  CHECK(status_of([](Config& c) { c.sink.accept = nullptr; }) == DISCMC_BAD_SINK);
  CHECK(status_of([](Config& c) {
          c.sink.accept = [](void*, const discmc_event*) {
            return static_cast<discmc_sink_result>(DISCMC_SINK_NOT_STARTED);
          };
        }) == DISCMC_BAD_SINK);
  CHECK(scan.extractor == nullptr);
  CHECK(status_of([](Config&) {}) == DISCMC_OK);
  CHECK(status_of([](Config& c) { c.memory.bytes = discmc_extractor_bytes(&c); }) == DISCMC_OK);

  for (const uint8_t other :
       {uint8_t{DISCMC_BITS}, uint8_t{DISCMC_U16}, uint8_t{DISCMC_I16}, uint8_t{4}}) {
    const discmc_push_result result =
        discmc_extractor_push(scan.extractor, other, samples, width, 1);
    CHECK(result.status == DISCMC_BAD_SAMPLES);
    CHECK(result.accepted == 0);
  }
  CHECK(discmc_extractor_push(scan.extractor, DISCMC_U8, samples, 5, 1).status == DISCMC_OK);
  CHECK(discmc_extractor_skip_row(scan.extractor, DISCMC_SUBSTITUTE_OFF).status ==
        DISCMC_ROW_IN_PROGRESS);
  CHECK(discmc_extractor_abandon(scan.extractor) == DISCMC_OK);
  CHECK(discmc_extractor_push(scan.extractor, DISCMC_U8, samples, 5, 1).status == DISCMC_FINISHED);

  Scan bits(discmc_plain_bits, 20000, log);
  bits.start();
  for (const uint32_t count : {width - 1, width + 1})
    CHECK(discmc_extractor_push(bits.extractor, DISCMC_BITS, samples, count, 1).status ==
          DISCMC_BAD_SAMPLES);
}

TEST_CASE("a checkpoint in C is restored completely and only by an extractor of the same kind") {
  EventLog log;
  Scan scan(discmc_plain_u8, 20000, log);
  scan.start();
  scan.push_rows(DISCMC_U8, make_samples<uint8_t>(), 0, 60);
  discmc_memory part;
  REQUIRE(discmc_extractor_save(scan.extractor, &part) == DISCMC_OK);
  const auto* const saved = static_cast<const uint8_t*>(part.data);

  discmc_extractor* restored = nullptr;
  const auto status_of = [&](size_t offset, auto change) {
    std::vector<uint8_t> bytes(20000 + 16);
    uint8_t* const begin =
        bytes.data() +
        (reinterpret_cast<uintptr_t>(saved) - reinterpret_cast<uintptr_t>(bytes.data())) % 8 +
        offset;
    std::copy_n(saved, part.bytes, begin);
    discmc_extractor_config config = scan.config;
    config.memory = {begin, 20000};
    change(config, begin);
    return discmc_extractor_restore(&restored, &config);
  };
  using Config = discmc_extractor_config;
  const auto changed_at = [&](size_t byte) {
    return status_of(0, [byte](Config&, uint8_t* bytes) { bytes[byte] ^= 1; });
  };
  const size_t object = static_cast<size_t>(reinterpret_cast<uint8_t*>(scan.extractor) - saved);
  CHECK(changed_at(object) == DISCMC_BAD_CHECKPOINT);  // the layout
  CHECK(changed_at(object + sizeof(KindObject) + 40) == DISCMC_BAD_CHECKPOINT);
  CHECK(changed_at(part.bytes - 1) == DISCMC_BAD_CHECKPOINT);
  restored = nullptr;
  CHECK(status_of(1, [](Config&, uint8_t*) {}) == DISCMC_BAD_CHECKPOINT);
  for (const discmc_extractor_kind* other : {&discmc_normals_u8, &discmc_plain_i16})
    CHECK(status_of(0, [&](Config& c, uint8_t*) { c.kind = other; }) == DISCMC_BAD_CHECKPOINT);
  CHECK(status_of(0, [&](Config& c, uint8_t*) { c.memory.bytes = part.bytes - 1; }) ==
        DISCMC_BAD_CHECKPOINT);
  CHECK(status_of(0, [&](Config& c, uint8_t*) { c.memory.bytes = part.bytes + 8; }) ==
        DISCMC_TOO_LITTLE_MEMORY);
  CHECK(status_of(0, [](Config& c, uint8_t*) { c.memory.bytes = 10; }) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(status_of(0, [](Config& c, uint8_t*) { c.sink.accept = nullptr; }) == DISCMC_BAD_SINK);
  CHECK(restored == nullptr);
  CHECK(status_of(0, [](Config&, uint8_t*) {}) == DISCMC_OK);
  CHECK(status_of(8, [](Config&, uint8_t*) {}) == DISCMC_OK);
}

TEST_CASE("saving a suspended extractor in C is refused") {
  bool is_busy = false;
  EventLog log([&](uint64_t) { return is_busy; });
  Scan scan(discmc_plain_u8, 20000, log);
  scan.start();
  scan.push_rows(DISCMC_U8, make_samples<uint8_t>(), 0, 2 * height);
  is_busy = true;
  const auto samples = make_samples<uint8_t>();
  CHECK(
      discmc_extractor_push(scan.extractor, DISCMC_U8, samples.data(), width * height, 1).status ==
      DISCMC_SUSPENDED);
  discmc_memory part{};
  CHECK(discmc_extractor_save(scan.extractor, &part) == DISCMC_SUSPENDED);
  CHECK(part.data == nullptr);
  is_busy = false;
  CHECK(discmc_extractor_save(scan.extractor, &part) == DISCMC_SUSPENDED);
  CHECK(discmc_extractor_resume(scan.extractor) == DISCMC_OK);
  CHECK(discmc_extractor_save(scan.extractor, &part) == DISCMC_OK);
}
