// Extractors with normals and the one that learns do through C what they do in C++, event for
// event.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <cstring>
#include <discmc/gradient_normals.hpp>
#include <discmc/learning_extractor.hpp>
#include <memory>
#include <new>
#include <vector>

#include "oracle/c_events.hpp"
#include "oracle/normal_events.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::uneven_spacing;

namespace {

constexpr uint32_t width = 21, height = 17, depth = 13;
constexpr int32_t threshold = 100;
constexpr Limits closed{width, height};
constexpr uint32_t never_came = 40;  // of all rows
constexpr uint32_t saved_row = 60;   // before it the scan moves to another object and memory

// Walls with noise, so that there are holes, and too much for little memory.
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

// ---- the extractors of C, each with its functions under one name ----

template <const discmc_normal_kind& kind, class ExtractorInCpp, class SampleType>
struct Normals {
  using InCpp = ExtractorInCpp;
  using Sample = SampleType;
  using Checkpoint = discmc_normal_extractor_checkpoint;
  discmc_normal_extractor object = {};

  static uint64_t minimum_bytes(const discmc_limits& limits) {
    return discmc_normal_extractor_minimum_bytes(&kind, &limits);
  }
  void prepare() { discmc_normal_extractor_set_spacing(&object, &kind, uneven_spacing); }
  static void prepare(InCpp& in_cpp) { in_cpp.set_spacing(uneven_spacing); }
  discmc_status start(const discmc_limits& limits, const discmc_capacities* capacities,
                      discmc_memory memory, const discmc_sink& sink) {
    return discmc_normal_extractor_start(&object, &kind, &limits, capacities, threshold, memory,
                                         &sink);
  }
  discmc_push_result push(const uint8_t* samples, uint32_t count) {
    return discmc_normal_extractor_push_u8(&object, samples, count, 1);
  }
  discmc_push_result push(const uint16_t* samples, uint32_t count) {
    return discmc_normal_extractor_push_u16(&object, samples, count, 1);
  }
  discmc_push_result push(const int16_t* samples, uint32_t count) {
    return discmc_normal_extractor_push_i16(&object, samples, count, 1);
  }
  discmc_push_result skip_row() {
    return discmc_normal_extractor_skip_row(&object, DISCMC_PREVIOUS_ROW);
  }
  discmc_status reset() { return discmc_normal_extractor_reset(&object); }
  discmc_status resume() { return discmc_normal_extractor_resume(&object); }
  discmc_status finish() { return discmc_normal_extractor_finish(&object); }
  discmc_status abandon() { return discmc_normal_extractor_abandon(&object); }
  discmc_status save(Checkpoint& checkpoint) const {
    return discmc_normal_extractor_save(&object, &checkpoint);
  }
  discmc_status restore(const Checkpoint& checkpoint, discmc_memory memory,
                        const discmc_sink& sink) {
    return discmc_normal_extractor_restore(&object, &kind, &checkpoint, memory, &sink);
  }
  discmc_statistics statistics() const { return discmc_normal_extractor_statistics(&object); }
  discmc_limits limits() const { return discmc_normal_extractor_limits(&object); }
  discmc_capacities capacities() const { return discmc_normal_extractor_capacities(&object); }
  discmc_high_water high_water() const { return discmc_normal_extractor_high_water(&object); }
  size_t bytes_used() const { return discmc_normal_extractor_bytes_used(&object); }
  uint32_t slices() const { return discmc_normal_extractor_slices(&object); }
  uint32_t rows() const { return discmc_normal_extractor_rows(&object); }
};

template <class SampleType>
struct Learning {
  using InCpp = LearningExtractor;
  using Sample = SampleType;
  using Checkpoint = discmc_learning_extractor_checkpoint;
  discmc_learning_extractor object = {};
  std::vector<uint8_t> learnt = std::vector<uint8_t>(1 << 16);

  static uint64_t minimum_bytes(const discmc_limits& limits) {
    return discmc_learning_extractor_minimum_bytes(&limits);
  }
  void prepare() { discmc_learning_extractor_learn_in(&object, {learnt.data(), learnt.size()}); }
  static void prepare(InCpp&) {}  // the events are the same without
  discmc_status start(const discmc_limits& limits, const discmc_capacities* capacities,
                      discmc_memory memory, const discmc_sink& sink) {
    return discmc_learning_extractor_start(&object, &limits, capacities, threshold, memory, &sink);
  }
  discmc_push_result push(const uint8_t* samples, uint32_t count) {
    return discmc_learning_extractor_push_u8(&object, samples, count, 1);
  }
  discmc_push_result push(const uint16_t* samples, uint32_t count) {
    return discmc_learning_extractor_push_u16(&object, samples, count, 1);
  }
  discmc_push_result push(const int16_t* samples, uint32_t count) {
    return discmc_learning_extractor_push_i16(&object, samples, count, 1);
  }
  discmc_push_result skip_row() {
    return discmc_learning_extractor_skip_row(&object, DISCMC_PREVIOUS_ROW);
  }
  discmc_status reset() { return discmc_learning_extractor_reset(&object); }
  discmc_status resume() { return discmc_learning_extractor_resume(&object); }
  discmc_status finish() { return discmc_learning_extractor_finish(&object); }
  discmc_status abandon() { return discmc_learning_extractor_abandon(&object); }
  discmc_status save(Checkpoint& checkpoint) const {
    return discmc_learning_extractor_save(&object, &checkpoint);
  }
  discmc_status restore(const Checkpoint& checkpoint, discmc_memory memory,
                        const discmc_sink& sink) {
    return discmc_learning_extractor_restore(&object, &checkpoint, memory, &sink);
  }
  discmc_statistics statistics() const { return discmc_learning_extractor_statistics(&object); }
  discmc_limits limits() const { return discmc_learning_extractor_limits(&object); }
  discmc_capacities capacities() const { return discmc_learning_extractor_capacities(&object); }
  discmc_high_water high_water() const { return discmc_learning_extractor_high_water(&object); }
  size_t bytes_used() const { return discmc_learning_extractor_bytes_used(&object); }
  uint32_t slices() const { return discmc_learning_extractor_slices(&object); }
  uint32_t rows() const { return discmc_learning_extractor_rows(&object); }
};

template <class Index, class Sample>
using WithNormals = NormalExtractor<Index, Sample>;

#define ALL_EXTRACTORS                                                             \
  Normals<discmc_normals_u8, WithNormals<uint16_t, uint8_t>, uint8_t>,             \
      Normals<discmc_normals_u16, WithNormals<uint16_t, uint16_t>, uint16_t>,      \
      Normals<discmc_normals_i16, WithNormals<uint16_t, int16_t>, int16_t>,        \
      Normals<discmc_host_normals_u8, WithNormals<uint32_t, uint8_t>, uint8_t>,    \
      Normals<discmc_host_normals_u16, WithNormals<uint32_t, uint16_t>, uint16_t>, \
      Normals<discmc_host_normals_i16, WithNormals<uint32_t, int16_t>, int16_t>,   \
      Learning<uint8_t>, Learning<uint16_t>, Learning<int16_t>

// ---- scans ----

template <class InC>
bool succeeds(InC& extractor, discmc_status status) {
  while (status == DISCMC_MORE) status = extractor.resume();
  return status == DISCMC_OK;
}

template <class InC>
void scan_rows(InC& extractor, uint32_t first, uint32_t end) {
  const auto samples = make_samples<typename InC::Sample>();
  for (uint32_t row = first; row < end; ++row) {
    const discmc_push_result result =
        row == never_came ? extractor.skip_row()
                          : extractor.push(samples.data() + size_t{row} * width, width);
    REQUIRE(result.samples == width);
    REQUIRE(succeeds(extractor, result.status));
  }
}

// On the heap: some are too large for a stack.
template <class InC>
std::unique_ptr<InC> scan_in_c(size_t bytes, const discmc_sink& sink) {
  auto first = std::make_unique<InC>(), second = std::make_unique<InC>();
  std::vector<uint8_t> memory(bytes), other_memory(bytes);
  const discmc_memory other = {other_memory.data(), bytes};
  first->prepare();
  REQUIRE(succeeds(*first, first->start(to_c(closed), nullptr, {memory.data(), bytes}, sink)));
  scan_rows(*first, 0, saved_row);
  auto checkpoint = std::make_unique<typename InC::Checkpoint>();
  REQUIRE(first->save(*checkpoint) == DISCMC_OK);
  CHECK(second->restore(*checkpoint, other, sink) == DISCMC_BAD_CHECKPOINT);
  other_memory = memory;
  REQUIRE(second->restore(*checkpoint, other, sink) == DISCMC_OK);
  CHECK(second->slices() == saved_row / height);
  CHECK(second->rows() == saved_row % height);
  std::fill(memory.begin(), memory.end(), uint8_t{0xFF});
  scan_rows(*second, saved_row, height * depth);
  REQUIRE(succeeds(*second, second->finish()));
  return second;
}

// The same, from a checkpoint in the same memory, as that of corners takes more.
template <class InC>
std::unique_ptr<typename InC::InCpp> scan_in_cpp(size_t bytes, const Sink& sink) {
  using InCpp = typename InC::InCpp;
  const auto samples = make_samples<typename InC::Sample>();
  auto first = std::make_unique<InCpp>(), second = std::make_unique<InCpp>();
  std::vector<uint8_t> storage(bytes);
  const Memory memory = {storage.data(), bytes};
  InC::prepare(*first);
  require_ok(first->start(closed, threshold, memory, sink));
  for (uint32_t row = 0; row < height * depth; ++row) {
    if (row == saved_row) {
      auto checkpoint = std::make_unique<Checkpoint<InCpp>>();
      require_ok(first->save(*checkpoint));
      require_ok(second->restore(*checkpoint, memory, sink));
    }
    InCpp& extractor = row < saved_row ? *first : *second;
    Status status =
        (row == never_came ? extractor.skip_row(Substitute::previous_row)
                           : extractor.push(samples.data() + size_t{row} * width, width))
            .status;
    while (status == Status::more) status = extractor.resume();
    require_ok(status);
  }
  finish_all(*second);
  return second;
}

}  // namespace

TEST_CASE_TEMPLATE("a scan through C makes the same events, and goes on from a checkpoint", InC,
                   ALL_EXTRACTORS) {
  const size_t least = InC::minimum_bytes(to_c(closed));
  for (const size_t bytes : {least, least + 700, least + 1000000}) {
    CAPTURE(bytes);
    const auto refuses = [](uint64_t offer) { return offer % 3 == 2; };
    EventLog in_c(refuses), in_cpp(refuses);
    const auto c = scan_in_c<InC>(bytes, c_sink_to(in_c));
    const auto cpp = scan_in_cpp<InC>(bytes, sink_to(in_cpp));
    CHECK(in_c.events.size() > 100);
    CHECK(in_c.events == in_cpp.events);
    CHECK(in_c.starts[0].spacing_nm[1] == in_cpp.starts[0].spacing_nm[1]);
    CHECK(counts(from_c(c->statistics())) == counts(cpp->statistics()));
    CHECK(c->limits().width == width);
    CHECK(c->limits().height == height);
    CHECK(c->capacities().records == cpp->capacities().records);
    CHECK(c->high_water().records == cpp->high_water().records);
    CHECK(c->high_water().holes == cpp->high_water().holes);
    CHECK(c->bytes_used() == cpp->bytes_used());
    CHECK(c->slices() == depth);
    CHECK(c->rows() == 0);
  }
}

TEST_CASE_TEMPLATE("an extractor of zeros is not started, and is one after a start", InC,
                   ALL_EXTRACTORS) {
  auto extractor = std::make_unique<InC>();
  typename InC::Sample samples[9] = {};
  auto checkpoint = std::make_unique<typename InC::Checkpoint>();
  CHECK(extractor->push(samples, 9).status == DISCMC_NOT_STARTED);
  CHECK(extractor->skip_row().status == DISCMC_NOT_STARTED);
  CHECK(extractor->resume() == DISCMC_NOT_STARTED);
  CHECK(extractor->finish() == DISCMC_NOT_STARTED);
  CHECK(extractor->abandon() == DISCMC_NOT_STARTED);
  CHECK(extractor->reset() == DISCMC_NOT_STARTED);
  CHECK(extractor->save(*checkpoint) == DISCMC_NOT_STARTED);
  CHECK(extractor->statistics().regions == 0);
  CHECK(extractor->limits().width == 0);
  CHECK(extractor->capacities().records == 0);
  CHECK(extractor->high_water().records == 0);
  CHECK(extractor->bytes_used() == 0);
  CHECK(extractor->slices() == 0);
  CHECK(extractor->rows() == 0);

  EventLog log;
  const discmc_sink sink = c_sink_to(log), none = {};
  const discmc_limits good = {9, 9, DISCMC_CLOSED, {}}, bad = {0, 9, DISCMC_CLOSED, {}};
  std::vector<uint8_t> memory(InC::minimum_bytes(good));
  const discmc_memory all = {memory.data(), memory.size()};
  const discmc_memory little = {memory.data(), memory.size() - 1};
  const discmc_capacities too_few = {1, 0}, too_many = {1000, 0};
  CHECK(extractor->start(bad, nullptr, all, sink) == DISCMC_BAD_LIMITS);
  CHECK(extractor->start(good, nullptr, all, none) == DISCMC_BAD_SINK);
  CHECK(extractor->start(good, nullptr, little, sink) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(extractor->start(good, &too_few, all, sink) == DISCMC_BAD_CAPACITIES);
  CHECK(extractor->start(good, &too_many, all, sink) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(extractor->resume() == DISCMC_NOT_STARTED);
  REQUIRE(extractor->start(good, nullptr, all, sink) == DISCMC_OK);
  CHECK(extractor->push(samples, 4).samples == 4);
  CHECK(extractor->skip_row().status == DISCMC_ROW_IN_PROGRESS);
  CHECK(extractor->finish() == DISCMC_SLICE_IN_PROGRESS);
  CHECK(extractor->abandon() == DISCMC_OK);
  CHECK(extractor->push(samples, 9).status == DISCMC_FINISHED);
  CHECK(extractor->reset() == DISCMC_OK);
  CHECK(extractor->finish() == DISCMC_OK);
}

namespace {

// Storage of zeros, and such in which an object begins, are alike after a function has been called.
template <class Object, class Function>
void check_zeros(Function function) {
  struct Storage {
    alignas(Object) unsigned char bytes[sizeof(Object)];
  };
  const auto zeros = std::make_unique<Storage>(), begun = std::make_unique<Storage>();
  function(reinterpret_cast<Object&>(*zeros));
  function(*new (begun->bytes) Object);
  CHECK(std::memcmp(zeros->bytes, begun->bytes, sizeof(Object)) == 0);
}

}  // namespace

TEST_CASE(
    "storage of zeros is an extractor as it begins, of one with normals but for the weights") {
  check_zeros<LearningExtractor>([](LearningExtractor&) {});
  const auto set_spacing = [](auto& extractor) { extractor.set_spacing(uneven_spacing); };
  check_zeros<WithNormals<uint16_t, uint8_t>>(set_spacing);
  check_zeros<WithNormals<uint32_t, int16_t>>(set_spacing);
}

// ---- of extractors with normals ----

namespace {

using OfBytes = Normals<discmc_normals_u8, WithNormals<uint16_t, uint8_t>, uint8_t>;
using OfWords = Normals<discmc_host_normals_i16, WithNormals<uint32_t, int16_t>, int16_t>;

// The spacing that the start of a scan tells.
int32_t spacing_told(const EventLog& log) {
  return log.starts.back().spacing_nm[2];
}

}  // namespace

TEST_CASE("the spacing is told until another is, and not to another kind") {
  EventLog log;
  const discmc_sink sink = c_sink_to(log);
  discmc_normal_extractor extractor = {};
  std::vector<uint8_t> memory(100000);
  const discmc_limits limits = to_c(closed);
  const auto start = [&](const discmc_normal_kind& kind) {
    REQUIRE(discmc_normal_extractor_start(&extractor, &kind, &limits, nullptr, threshold,
                                          {memory.data(), memory.size()}, &sink) == DISCMC_OK);
    return spacing_told(log);
  };
  CHECK(start(discmc_normals_u8) == 0);
  discmc_normal_extractor_set_spacing(&extractor, &discmc_normals_u8, uneven_spacing);
  CHECK(start(discmc_normals_u8) == uneven_spacing[2]);
  CHECK(start(discmc_normals_u8) == uneven_spacing[2]);
  CHECK(start(discmc_host_normals_u8) == 0);
  CHECK(start(discmc_normals_u8) == 0);
}

TEST_CASE("samples of another type than the kind's are not taken, nor is its checkpoint") {
  EventLog log;
  OfBytes bytes;
  std::vector<uint8_t> memory(100000);
  const discmc_memory all = {memory.data(), memory.size()};
  REQUIRE(bytes.start(to_c(closed), nullptr, all, c_sink_to(log)) == DISCMC_OK);
  const int16_t words[9] = {};
  const uint16_t others[9] = {};
  CHECK(bytes.push(words, 9).status == DISCMC_NOT_STARTED);
  CHECK(bytes.push(others, 9).samples == 0);
  const uint8_t samples[9] = {};
  CHECK(bytes.push(samples, 9).samples == 9);

  OfBytes::Checkpoint checkpoint;
  REQUIRE(bytes.save(checkpoint) == DISCMC_OK);
  OfWords other;
  CHECK(other.restore(checkpoint, all, c_sink_to(log)) == DISCMC_BAD_CHECKPOINT);
  CHECK(other.resume() == DISCMC_NOT_STARTED);
}

TEST_CASE("an object becomes one of another kind by its start, whatever comes of that") {
  EventLog log;
  OfBytes bytes;
  std::vector<uint8_t> memory(100000);
  const discmc_memory all = {memory.data(), memory.size()};
  const discmc_limits bad = {}, good = to_c(closed);
  const discmc_sink sink = c_sink_to(log);
  REQUIRE(bytes.start(good, nullptr, all, sink) == DISCMC_OK);
  CHECK(bytes.start(bad, nullptr, all, sink) == DISCMC_BAD_LIMITS);
  CHECK(bytes.resume() == DISCMC_OK);  // the scan goes on
  CHECK(discmc_normal_extractor_start(&bytes.object, &discmc_normals_i16, &bad, nullptr, threshold,
                                      all, &sink) == DISCMC_BAD_LIMITS);
  CHECK(bytes.resume() == DISCMC_NOT_STARTED);
  REQUIRE(discmc_normal_extractor_start(&bytes.object, &discmc_normals_i16, &good, nullptr,
                                        threshold, all, &sink) == DISCMC_OK);
  const int16_t words[9] = {};
  CHECK(bytes.push(words, 9).samples == 9);
}

// ---- of the one that learns ----

TEST_CASE("a learning extractor takes bits, and learns, through C as well") {
  const auto bits_of = [](uint32_t row) { return static_cast<uint8_t>(row * 37 ^ row >> 3); };
  const auto scanned = [&](size_t learnt_bytes) {
    EventLog log;
    auto extractor = std::make_unique<discmc_learning_extractor>();
    std::vector<uint8_t> memory(2000000), learnt(learnt_bytes);
    const discmc_limits limits = {8, 9, DISCMC_CLOSED, {}};
    const discmc_sink sink = c_sink_to(log);
    if (learnt_bytes > 0)
      discmc_learning_extractor_learn_in(extractor.get(), {learnt.data(), learnt.size()});
    REQUIRE(discmc_learning_extractor_start(extractor.get(), &limits, nullptr, 1,
                                            {memory.data(), memory.size()}, &sink) == DISCMC_OK);
    for (uint32_t row = 0; row < 9 * 5; ++row) {
      const uint8_t bits = bits_of(row);
      REQUIRE(discmc_learning_extractor_push_bits(extractor.get(), &bits).status == DISCMC_OK);
    }
    REQUIRE(discmc_learning_extractor_finish(extractor.get()) == DISCMC_OK);
    const bool has_learnt = std::any_of(learnt.begin(), learnt.end(), [](uint8_t b) { return b; });
    CHECK(has_learnt == (learnt_bytes > 0));
    return log.events;
  };
  EventLog expected;
  auto extractor = std::make_unique<LearningExtractor>();
  std::vector<uint8_t> memory(2000000);
  require_ok(extractor->start({8, 9}, 1, {memory.data(), memory.size()}, sink_to(expected)));
  for (uint32_t row = 0; row < 9 * 5; ++row) {
    const uint8_t bits = bits_of(row);
    require_ok(extractor->push_bits(&bits).status);
  }
  require_ok(extractor->finish());
  CHECK(expected.events.size() > 100);
  CHECK(scanned(0) == expected.events);
  CHECK(scanned(1 << 16) == expected.events);
}

// ---- sizes ----

namespace {

template <class Index, class Sample>
void check_sizes(const discmc_normal_kind& kind, const Limits& limits, uint64_t bytes) {
  using Kept = GradientNormals<Sample>;
  const discmc_limits in_c = to_c(limits);
  const Capacities capacities = default_capacities<Index, Kept>(limits, bytes);
  const discmc_capacities told = discmc_normal_extractor_default_capacities(&kind, &in_c, bytes);
  REQUIRE(told.records == capacities.records);
  REQUIRE(told.holes == capacities.holes);
  REQUIRE(discmc_normal_extractor_minimum_bytes(&kind, &in_c) ==
          minimum_bytes<Index, Kept>(limits));
  REQUIRE(discmc_normal_extractor_bytes_for(&kind, &in_c, &told) ==
          bytes_for<Index, Kept>(limits, capacities));
  if (sizeof(Index) == sizeof(uint32_t)) return;
  const uint32_t w = limits.width, h = limits.height;
  REQUIRE(DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(w, h, sizeof(Sample)) ==
          minimum_bytes<Index, Kept>(limits));
  REQUIRE(DISCMC_NORMAL_EXTRACTOR_BYTES_FOR(w, h, sizeof(Sample), capacities.records) ==
          bytes_for<Index, Kept>(limits, capacities));
  const uint64_t constants[] =
      DISCMC_NORMAL_EXTRACTOR_DEFAULT_CAPACITIES(w, h, sizeof(Sample), bytes);
  REQUIRE(constants[0] == capacities.records);
  REQUIRE(constants[1] == capacities.holes);
}

void check_learning_sizes(const Limits& limits, uint64_t bytes) {
  const uint32_t w = limits.width, h = limits.height;
  const discmc_limits in_c = to_c(limits);
  const Capacities capacities = default_capacities<uint32_t>(limits, bytes);
  const discmc_capacities told = discmc_learning_extractor_default_capacities(&in_c, bytes);
  REQUIRE(told.records == capacities.records);
  REQUIRE(told.holes == capacities.holes);
  REQUIRE(discmc_learning_extractor_minimum_bytes(&in_c) == minimum_bytes<uint32_t>(limits));
  REQUIRE(discmc_learning_extractor_bytes_for(&in_c, &told) ==
          bytes_for<uint32_t>(limits, capacities));
  REQUIRE(DISCMC_LEARNING_EXTRACTOR_MINIMUM_BYTES(w, h) == minimum_bytes<uint32_t>(limits));
  REQUIRE(DISCMC_LEARNING_EXTRACTOR_BYTES_FOR(w, h, capacities.records) ==
          bytes_for<uint32_t>(limits, capacities));
  const uint64_t constants[] = DISCMC_LEARNING_EXTRACTOR_DEFAULT_CAPACITIES(w, h, bytes);
  REQUIRE(constants[0] == capacities.records);
  REQUIRE(constants[1] == capacities.holes);
}

}  // namespace

TEST_CASE("sizes are the same in C, as functions and as constants") {
  const uint32_t extents[] = {1, 2, 3, 29, 30, 31, 32, 64, 255, 4095, 32766};
  for (const uint32_t w : extents)
    for (const uint32_t h : extents) {
      const Limits limits{w, h};
      const uint64_t least = minimum_bytes<uint16_t>(limits);
      for (uint64_t bytes = 0; bytes < uint64_t{1} << 50; bytes = bytes * 7 / 3 + least / 2) {
        CAPTURE(w);
        CAPTURE(h);
        CAPTURE(bytes);
        check_sizes<uint16_t, uint8_t>(discmc_normals_u8, limits, bytes);
        check_sizes<uint16_t, uint16_t>(discmc_normals_u16, limits, bytes);
        check_sizes<uint16_t, int16_t>(discmc_normals_i16, limits, bytes);
        check_sizes<uint32_t, uint8_t>(discmc_host_normals_u8, limits, bytes);
        check_sizes<uint32_t, uint16_t>(discmc_host_normals_u16, limits, bytes);
        check_sizes<uint32_t, int16_t>(discmc_host_normals_i16, limits, bytes);
        check_learning_sizes(limits, bytes);
      }
      const discmc_limits in_c = to_c(limits);
      for (const uint32_t slices : {1U, 100U, UINT32_MAX}) {
        const Capacities worst = worst_case_capacities(limits, slices);
        CHECK(discmc_worst_case_capacities(&in_c, slices).records == worst.records);
        CHECK(discmc_worst_case_capacities(&in_c, slices).holes == worst.holes);
      }
    }
}
