// The C functions do what the C++ functions do, event for event and byte for byte.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <discmc/discmc.hpp>
#include <discmc/plane.hpp>
#include <string_view>
#include <vector>

#include "oracle/c_events.hpp"

using namespace discmc;
using reference::c_sink_to;
using reference::counts;
using reference::EventLog;
using reference::from_c;

namespace {

constexpr uint32_t width = 21, height = 17, depth = 13;
constexpr int32_t threshold = 100;
constexpr Limits closed{width, height};
constexpr Limits open{width, height, Border::open};

// Blobs and noise, so that there are holes, and too much for little memory.
template <class Sample>
std::vector<Sample> make_samples() {
  std::vector<Sample> samples(width * height * depth);
  uint32_t seed = 7;
  for (size_t i = 0; i < samples.size(); ++i) {
    seed = seed * 1664525 + 1013904223;
    const size_t x = i % width, y = i / width % height;
    const bool is_wall = x > 4 && x < 17 && y > 3 && y < 14;
    samples[i] = static_cast<Sample>((is_wall ? 90 : 20) + (seed >> 24) / 8);
  }
  return samples;
}

EventLog::Refuses refuses_every(uint64_t nth) {
  return [nth](uint64_t offer) { return nth != 0 && offer % nth == nth - 1; };
}

discmc_push_result push(discmc_extractor* extractor, const uint8_t* samples, uint32_t count) {
  return discmc_extractor_push_u8(extractor, samples, count, 1);
}
discmc_push_result push(discmc_extractor* extractor, const uint16_t* samples, uint32_t count) {
  return discmc_extractor_push_u16(extractor, samples, count, 1);
}
discmc_push_result push(discmc_extractor* extractor, const int16_t* samples, uint32_t count) {
  return discmc_extractor_push_i16(extractor, samples, count, 1);
}

bool succeeds(discmc_extractor& extractor, discmc_status status) {
  while (status == DISCMC_MORE) status = discmc_extractor_resume(&extractor);
  return status == DISCMC_OK;
}
bool succeeds(Extractor16& extractor, Status status) {
  while (status == Status::more) status = extractor.resume();
  return status == Status::ok;
}

bool are_equal(const discmc_capacities& c, const Capacities& cpp) {
  return c.records == cpp.records && c.holes == cpp.holes;
}

// A scan whose row 40 never comes, and that goes on from a checkpoint at row 60, elsewhere.
template <class Sample>
void scan_in_c(const std::vector<Sample>& samples, const Limits& limits, size_t bytes,
               const discmc_sink& sink) {
  std::vector<uint8_t> memory(bytes), other_memory(bytes);
  discmc_extractor first = {}, second = {};
  discmc_extractor* extractor = &first;
  const discmc_limits c_limits = reference::to_c(limits);
  REQUIRE(succeeds(first, discmc_extractor_start(&first, &c_limits, nullptr, threshold,
                                                 {memory.data(), memory.size()}, &sink)));
  for (uint32_t row = 0; row < height * depth; ++row) {
    if (row == 60) {
      discmc_extractor_checkpoint checkpoint;
      REQUIRE(discmc_extractor_save(&first, &checkpoint) == DISCMC_OK);
      memory.swap(other_memory);
      REQUIRE(discmc_extractor_restore(&second, &checkpoint, {memory.data(), bytes}, &sink) ==
              DISCMC_BAD_CHECKPOINT);
      std::copy(other_memory.begin(), other_memory.end(), memory.begin());
      REQUIRE(discmc_extractor_restore(&second, &checkpoint, {memory.data(), bytes}, &sink) ==
              DISCMC_OK);
      std::fill(other_memory.begin(), other_memory.end(), uint8_t{0xFF});
      extractor = &second;
    }
    const discmc_push_result result =
        row == 40 ? discmc_extractor_skip_row(extractor, DISCMC_PREVIOUS_ROW)
                  : push(extractor, samples.data() + size_t{row} * width, width);
    REQUIRE(result.samples == width);
    REQUIRE(succeeds(*extractor, result.status));
  }
  REQUIRE(succeeds(*extractor, discmc_extractor_finish(extractor)));
}

template <class Sample>
void scan_in_cpp(const std::vector<Sample>& samples, const Limits& limits, size_t bytes,
                 const Sink& sink) {
  std::vector<uint8_t> memory(bytes);
  Extractor16 extractor;
  REQUIRE(succeeds(extractor,
                   extractor.start(limits, threshold, {memory.data(), memory.size()}, sink)));
  for (uint32_t row = 0; row < height * depth; ++row) {
    const PushResult result = row == 40
                                  ? extractor.skip_row(Substitute::previous_row)
                                  : extractor.push(samples.data() + size_t{row} * width, width);
    REQUIRE(succeeds(extractor, result.status));
  }
  REQUIRE(succeeds(extractor, extractor.finish()));
}

uint64_t loose_fragments(const EventLog& log) {
  return log.events.back().event().statistics->fragments;
}

template <class Sample>
void check_scans(const Limits& limits) {
  const std::vector<Sample> samples = make_samples<Sample>();
  const size_t least = minimum_bytes<uint16_t>(limits);
  for (const size_t bytes : {least, least + 600, least + 200000})
    for (const uint32_t nth : {0U, 3U}) {
      CAPTURE(bytes);
      EventLog in_c(refuses_every(nth)), in_cpp;
      scan_in_c(samples, limits, bytes, c_sink_to(in_c));
      scan_in_cpp(samples, limits, bytes, sink_to(in_cpp));
      CHECK(in_c.events.size() > 100);
      CHECK(in_c.events == in_cpp.events);
      // Otherwise little memory has not been tried.
      if (bytes == least) CHECK(loose_fragments(in_c) > 100);
    }
}

size_t write_bytes(void* context, const uint8_t* bytes, size_t count) {
  auto& stream = *static_cast<std::vector<uint8_t>*>(context);
  stream.insert(stream.end(), bytes, bytes + count);
  return count;
}

std::vector<uint8_t> stream_in_c(const std::vector<uint8_t>& samples) {
  std::vector<uint8_t> stream;
  discmc_encoder encoder = {};
  const discmc_stream_label label = {depth, {1000, -2000, 3000}, 700, 5};
  REQUIRE(discmc_encoder_start(&encoder, &label, {&stream, write_bytes}) == DISCMC_OK);
  scan_in_c(samples, closed, 6000, {&encoder, discmc_encoder_take});
  CHECK(discmc_encoder_bytes(&encoder) == stream.size());
  CHECK(discmc_encoder_flush(&encoder) == 1);
  return stream;
}

}  // namespace

TEST_CASE("a scan through C makes the same events, whatever the samples, the memory, the sink") {
  for (const Limits& limits : {closed, open}) {
    check_scans<uint8_t>(limits);
    check_scans<uint16_t>(limits);
    check_scans<int16_t>(limits);
  }
}

TEST_CASE("a slab is scanned through C as in C++") {
  for (const Slab& slab : {Slab{0, false, true}, Slab{7, true, true}, Slab{7, true, false}}) {
    const Limits limits{width, height, Border::closed, slab};
    CAPTURE(slab.continues_below);
    CAPTURE(slab.continues_above);
    check_scans<uint8_t>(limits);
    const discmc_limits c_limits = reference::to_c(limits);
    std::vector<uint8_t> memory(6000);
    const discmc_memory all = {memory.data(), memory.size()};
    EventLog log;
    const discmc_sink sink = c_sink_to(log);
    discmc_extractor extractor = {};
    REQUIRE(discmc_extractor_start(&extractor, &c_limits, nullptr, threshold, all, &sink) ==
            DISCMC_OK);
    const discmc_slab told = discmc_extractor_limits(&extractor).slab;
    CHECK(told.first == slab.first);
    CHECK((told.continues_below != 0) == slab.continues_below);
    CHECK((told.continues_above != 0) == slab.continues_above);
  }
}

TEST_CASE("a stream through C is byte for byte that of C++, and decodes to the same events") {
  const std::vector<uint8_t> samples = make_samples<uint8_t>();
  const std::vector<uint8_t> stream = stream_in_c(samples);
  std::vector<uint8_t> expected;
  Encoder encoder;
  REQUIRE(encoder.start({depth, {1000, -2000, 3000}, 700, 5}, {&expected, write_bytes}) ==
          Status::ok);
  scan_in_cpp(samples, closed, 6000, sink_to(encoder));
  CHECK(stream == expected);

  EventLog in_c(refuses_every(5)), in_cpp;
  discmc_decoder decoder = {};
  const discmc_sink sink = c_sink_to(in_c);
  REQUIRE(discmc_decoder_start(&decoder, &sink, DISCMC_ANY_CHANNEL) == DISCMC_OK);
  for (size_t done = 0; done < stream.size();) {
    const discmc_decoded decoded =
        discmc_decoder_push(&decoder, stream.data() + done, stream.size() - done);
    done += decoded.bytes;
  }
  while (discmc_decoder_finish(&decoder) == DISCMC_MORE) {
  }
  Decoder decoder_cpp;
  REQUIRE(decoder_cpp.start(sink_to(in_cpp)) == Status::ok);
  REQUIRE(decoder_cpp.push(stream.data(), stream.size()).status == Status::ok);
  REQUIRE(decoder_cpp.finish() == Status::ok);
  CHECK(in_c.events == in_cpp.events);

  const discmc_stream_report report = discmc_decoder_report(&decoder);
  CHECK(report.is_complete == 1);
  CHECK(report.has_trailer == 1);
  CHECK(report.bytes == stream.size());
  CHECK(report.slices == depth);
  CHECK(report.regions == decoder_cpp.report().regions);
  CHECK(report.fragments == decoder_cpp.report().fragments);
  CHECK(report.totals.skipped_rows == 1);
  CHECK(counts(from_c(report.totals)) == counts(decoder_cpp.report().totals));
  const discmc_stream_header header = discmc_decoder_header(&decoder);
  CHECK(header.width == width);
  CHECK(header.height == height);
  CHECK(header.depth == depth);
  CHECK(header.spacing_nm[0] == 1000);
  CHECK(header.spacing_nm[1] == -2000);
  CHECK(header.spacing_nm[2] == 3000);
  CHECK(header.threshold == threshold);
  CHECK(header.border == DISCMC_CLOSED);
  CHECK(header.scan == 700);
  CHECK(header.channel == 5);
}

TEST_CASE("a stream goes on from a checkpoint through C") {
  std::vector<uint8_t> whole, stream;
  const discmc_stream_label label = {};
  discmc_encoder first = {}, second = {};
  discmc_encoder_checkpoint checkpoint;
  CHECK(discmc_encoder_save(&first, &checkpoint) == DISCMC_NOT_STARTED);
  REQUIRE(discmc_encoder_start(&first, &label, {&whole, write_bytes}) == DISCMC_OK);
  const discmc_stream_header header = {9, 9, 0, {0, 0, 0}, 0, DISCMC_CLOSED, 0, 0, 0, {}};
  discmc_event event = {};
  event.kind = DISCMC_START;
  event.of.header = &header;
  REQUIRE(discmc_encoder_take(&first, &event) == DISCMC_TAKEN);
  event.kind = DISCMC_LAYER;
  REQUIRE(discmc_encoder_take(&first, &event) == DISCMC_TAKEN);
  REQUIRE(discmc_encoder_save(&first, &checkpoint) == DISCMC_OK);
  CHECK(discmc_encoder_restore(&second, &checkpoint, {nullptr, nullptr}) == DISCMC_BAD_SINK);
  REQUIRE(discmc_encoder_restore(&second, &checkpoint, {&stream, write_bytes}) == DISCMC_OK);
  stream.assign(whole.begin(),
                whole.begin() + static_cast<ptrdiff_t>(discmc_encoder_bytes(&second)));
  for (discmc_encoder* encoder : {&first, &second}) {
    event.slice = 1;
    REQUIRE(discmc_encoder_take(encoder, &event) == DISCMC_TAKEN);
    REQUIRE(discmc_encoder_flush(encoder) == 1);
  }
  CHECK(stream == whole);
  checkpoint.head[0] ^= 1;
  CHECK(discmc_encoder_restore(&second, &checkpoint, {&stream, write_bytes}) ==
        DISCMC_BAD_CHECKPOINT);
}

TEST_CASE("records and another line go into a stream through C as in C++") {
  std::vector<uint8_t> stream, other;
  const discmc_stream_label label = {};
  const uint8_t told[201] = {7, 0, 9};
  const discmc_application_record record = {11, 2, 3, told, 3}, too_long = {11, 2, 3, told, 201};
  discmc_encoder encoder = {};
  CHECK(discmc_encoder_tell(&encoder, &record) == DISCMC_NOT_STARTED);
  REQUIRE(discmc_encoder_start(&encoder, &label, {&stream, write_bytes}) == DISCMC_OK);
  const discmc_stream_header header = {9, 9, 0, {0, 0, 0}, 0, DISCMC_CLOSED, 0, 0, 0, {}};
  discmc_event event = {};
  event.kind = DISCMC_START;
  event.of.header = &header;
  REQUIRE(discmc_encoder_take(&encoder, &event) == DISCMC_TAKEN);
  CHECK(discmc_encoder_tell(&encoder, &too_long) == DISCMC_BAD_RECORD);
  const size_t before = stream.size();
  discmc_encoder_set_output(&encoder, {&other, write_bytes});
  CHECK(discmc_encoder_tell(&encoder, &record) == DISCMC_OK);
  CHECK(stream.size() == before);
  stream.insert(stream.end(), other.begin(), other.end());

  std::vector<uint8_t> expected;
  Encoder encoder_cpp;
  REQUIRE(encoder_cpp.start({}, {&expected, write_bytes}) == Status::ok);
  const StreamHeader same = from_c(header);
  Event start{};
  start.kind = Event::Kind::start;
  start.header = &same;
  REQUIRE(encoder_cpp.take(start) == Answer::taken);
  encoder_cpp.set_output({&expected, write_bytes});
  REQUIRE(encoder_cpp.tell({11, 2, 3, told, 3}) == Status::ok);
  CHECK(stream == expected);
}

TEST_CASE("what a start refuses it refuses through C, and an object of zeros is not started") {
  discmc_extractor extractor = {};
  discmc_decoder decoder = {};
  discmc_encoder encoder = {};
  EventLog log;
  discmc_sink sink = c_sink_to(log);
  const discmc_sink none = {};
  std::vector<uint8_t> memory(2000);
  const discmc_memory all = {memory.data(), memory.size()};
  const discmc_memory little = {memory.data(), 100};
  const discmc_limits good = {9, 9, DISCMC_CLOSED, {}};
  const discmc_limits bad = {0, 9, DISCMC_CLOSED, {}};
  const discmc_capacities too_few = {1, 1}, too_many = {1000, 0};
  const uint8_t samples[9] = {};
  CHECK(discmc_extractor_push_u8(&extractor, samples, 9, 1).status == DISCMC_NOT_STARTED);
  CHECK(discmc_extractor_resume(&extractor) == DISCMC_NOT_STARTED);
  CHECK(discmc_extractor_finish(&extractor) == DISCMC_NOT_STARTED);
  CHECK(discmc_extractor_abandon(&extractor) == DISCMC_NOT_STARTED);
  CHECK(discmc_extractor_reset(&extractor) == DISCMC_NOT_STARTED);
  CHECK(discmc_decoder_push(&decoder, samples, 9).status == DISCMC_NOT_STARTED);
  CHECK(discmc_decoder_start(&decoder, &none, DISCMC_ANY_CHANNEL) == DISCMC_BAD_SINK);
  const discmc_stream_label bad_label = {0, {0, 0, 0}, 0, DISCMC_MAX_CHANNEL + 1};
  CHECK(discmc_encoder_start(&encoder, &bad_label, {nullptr, write_bytes}) == DISCMC_BAD_LABEL);
  const discmc_sink to_encoder = {&encoder, discmc_encoder_take};
  CHECK(discmc_extractor_start(&extractor, &good, nullptr, 1, all, &to_encoder) == DISCMC_BAD_SINK);
  const auto is_busy = [](void*, const uint8_t*, size_t) { return size_t{0}; };
  discmc_encoder waiting = {};
  const discmc_stream_label label = {};
  const discmc_sink to_waiting = {&waiting, discmc_encoder_take};
  CHECK(discmc_encoder_start(&waiting, &label, {nullptr, is_busy}) == DISCMC_OK);
  CHECK(discmc_extractor_start(&extractor, &good, nullptr, 1, all, &to_waiting) == DISCMC_OK);
  CHECK(discmc_encoder_flush(&waiting) == 0);
  extractor = {};
  CHECK(discmc_extractor_start(&extractor, &bad, nullptr, 1, all, &sink) == DISCMC_BAD_LIMITS);
  CHECK(discmc_extractor_start(&extractor, &good, nullptr, 1, all, &none) == DISCMC_BAD_SINK);
  CHECK(discmc_extractor_start(&extractor, &good, &too_few, 1, all, &sink) ==
        DISCMC_BAD_CAPACITIES);
  CHECK(discmc_extractor_start(&extractor, &good, nullptr, 1, little, &sink) ==
        DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_extractor_start(&extractor, &good, &too_many, 1, all, &sink) ==
        DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_extractor_bytes_used(&extractor) == 0);
  REQUIRE(discmc_extractor_start(&extractor, &good, nullptr, 1, all, &sink) == DISCMC_OK);
  CHECK(discmc_extractor_push_u8(&extractor, samples, 4, 1).samples == 4);
  CHECK(discmc_extractor_push_bits(&extractor, samples).status == DISCMC_ROW_IN_PROGRESS);
  CHECK(discmc_extractor_finish(&extractor) == DISCMC_SLICE_IN_PROGRESS);
  CHECK(discmc_extractor_abandon(&extractor) == DISCMC_OK);
  CHECK(discmc_extractor_push_u8(&extractor, samples, 9, 1).status == DISCMC_FINISHED);
  CHECK(discmc_extractor_reset(&extractor) == DISCMC_OK);
}

TEST_CASE("an extractor tells of itself through C what it tells in C++") {
  std::vector<uint8_t> memory(6000), memory_of_cpp(6000);
  EventLog log;
  const discmc_sink sink = c_sink_to(log);
  const discmc_limits limits = reference::to_c(open);
  discmc_extractor extractor = {};
  REQUIRE(discmc_extractor_start(&extractor, &limits, nullptr, threshold,
                                 {memory.data(), memory.size()}, &sink) == DISCMC_OK);
  Extractor16 same;
  REQUIRE(same.start(open, threshold, {memory_of_cpp.data(), memory_of_cpp.size()}, sink_to(log)) ==
          Status::ok);
  const std::vector<int16_t> samples = make_samples<int16_t>();
  const uint32_t count = width * height * 2 + width * 3;
  REQUIRE(discmc_extractor_push_i16(&extractor, samples.data(), count, 1).samples == count);
  REQUIRE(same.push(samples.data(), count).samples == count);
  CHECK(discmc_extractor_slices(&extractor) == 2);
  CHECK(discmc_extractor_rows(&extractor) == 3);
  const uint8_t bits[3] = {0xFF, 0xFF, 0x1F};
  CHECK(discmc_extractor_push_bits(&extractor, bits).samples == width);
  REQUIRE(same.push_bits(bits).samples == width);
  CHECK(discmc_extractor_rows(&extractor) == 4);
  CHECK(discmc_extractor_limits(&extractor).border == DISCMC_OPEN);
  CHECK(discmc_extractor_limits(&extractor).width == width);
  CHECK(discmc_extractor_limits(&extractor).height == height);
  CHECK(are_equal(discmc_extractor_capacities(&extractor), same.capacities()));
  CHECK(discmc_extractor_bytes_used(&extractor) == same.bytes_used());
  CHECK(counts(from_c(discmc_extractor_statistics(&extractor))) == counts(same.statistics()));
  CHECK(discmc_extractor_high_water(&extractor).records == same.high_water().records);
  CHECK(discmc_extractor_high_water(&extractor).holes == same.high_water().holes);
  CHECK(same.high_water().records > 0);
}

TEST_CASE(
    "a sink is copied; its struct need not live as long as the scan, and a start in vain leaves "
    "it") {
  const std::vector<uint8_t> samples(9, 200);
  std::vector<uint8_t> memory(4000);
  const discmc_memory all = {memory.data(), memory.size()};
  const discmc_limits limits = {3, 3, DISCMC_CLOSED, {}};
  EventLog log, other;
  discmc_extractor extractor = {};
  discmc_sink sink = c_sink_to(log);
  REQUIRE(discmc_extractor_start(&extractor, &limits, nullptr, threshold, all, &sink) == DISCMC_OK);
  sink = {};
  const discmc_limits bad = {0, 3, DISCMC_CLOSED, {}};
  const discmc_sink to_other = c_sink_to(other);
  CHECK(discmc_extractor_start(&extractor, &bad, nullptr, threshold, all, &to_other) ==
        DISCMC_BAD_LIMITS);
  CHECK(discmc_extractor_push_u8(&extractor, samples.data(), 9, 1).status == DISCMC_OK);
  CHECK(discmc_extractor_finish(&extractor) == DISCMC_OK);
  CHECK(log.events.size() > 26);
  CHECK(other.events.empty());
}

namespace {

bool are_equal(const discmc_vertex& c, const Vertex& cpp) {
  return c.x == cpp.x && c.y == cpp.y && c.z == cpp.z;
}

void check_sizes(const Limits& limits) {
  const uint32_t w = limits.width, h = limits.height;
  const discmc_limits c_limits = reference::to_c(limits);
  const uint64_t least = minimum_bytes<uint16_t>(limits);
  REQUIRE(discmc_minimum_bytes(&c_limits) == least);
  REQUIRE(DISCMC_MINIMUM_BYTES(w, h) == least);
  for (uint64_t bytes = 0; bytes < uint64_t{1} << 50; bytes = bytes * 7 / 3 + least / 2) {
    const Capacities capacities = default_capacities<uint16_t>(limits, bytes);
    const discmc_capacities c_capacities = discmc_default_capacities(&c_limits, bytes);
    REQUIRE(are_equal(c_capacities, capacities));
    const uint64_t as_constants[] = DISCMC_DEFAULT_CAPACITIES(w, h, bytes);
    REQUIRE(as_constants[0] == capacities.records);
    REQUIRE(as_constants[1] == capacities.holes);
    REQUIRE(discmc_bytes_for(&c_limits, &c_capacities) == bytes_for<uint16_t>(limits, capacities));
    REQUIRE(DISCMC_BYTES_FOR(w, h, capacities.records) == bytes_for<uint16_t>(limits, capacities));
  }
}

}  // namespace

TEST_CASE("sizes are the same in C, as functions and as constants, whatever the border and slab") {
  const uint32_t extents[] = {1,  2,  3,  7,   29,  30,  31,  32,   33,    59,   60,
                              63, 64, 65, 100, 255, 256, 513, 4095, 32759, 32766};
  for (const uint32_t w : extents)
    for (const uint32_t h : extents) {
      CAPTURE(w);
      CAPTURE(h);
      check_sizes({w, h, Border::closed});
      check_sizes({w, h, Border::open});
      check_sizes({w, h, Border::closed, {3, true, true}});
    }
  const discmc_capacities least = DISCMC_MINIMUM_CAPACITIES;
  CHECK(are_equal(least, minimum_capacities()));
  CHECK(are_equal(discmc_minimum_capacities(), minimum_capacities()));
}

TEST_CASE("limits and capacities are valid in C when they are in C++") {
  const discmc_limits largest = {1, DISCMC_MAX_EXTENT, DISCMC_OPEN, {}};
  const discmc_limits too_large = {1, DISCMC_MAX_EXTENT + 1, DISCMC_OPEN, {}};
  const discmc_limits upper_slab = {1, 1, DISCMC_OPEN, {5, 1, 0}};
  const discmc_limits from_nowhere = {1, 1, DISCMC_OPEN, {5, 0, 1}};
  CHECK(discmc_limits_is_valid(&largest) == 1);
  CHECK(discmc_limits_is_valid(&too_large) == 0);
  CHECK(discmc_limits_is_valid(&upper_slab) == 1);
  CHECK(discmc_limits_is_valid(&from_nowhere) == 0);
  for (const uint32_t records : {0U, 3U, 4U, 5U, 32758U, 32759U, 32760U, 65535U, UINT32_MAX}) {
    CAPTURE(records);
    const discmc_capacities capacities = {records, 0};
    CHECK((discmc_capacities_is_valid(&capacities) == 1) == is_valid<uint16_t>({records, 0}));
  }
}

TEST_CASE("a header is valid in C when it is in C++") {
  const discmc_stream_header good = {9, 9, 0, {0, 0, 0}, 0, DISCMC_CLOSED, 60, 0, 3, {}};
  CHECK(discmc_stream_header_is_valid(&good) == 1);
  discmc_stream_header channels = good, surfaces = good, size = good;
  ++channels.channel;
  ++surfaces.further_surfaces;
  surfaces.channel = 0;
  size.width = DISCMC_MAX_EXTENT + 1;
  for (const discmc_stream_header& bad : {channels, surfaces, size})
    CHECK(discmc_stream_header_is_valid(&bad) == 0);
}

TEST_CASE("every status has the text that it has in C++") {
  for (discmc_status status = 0; status <= DISCMC_DEVICE_ERROR; ++status)
    CHECK(std::string_view(discmc_text(status)) == text(static_cast<Status>(status)));
  CHECK(std::string_view(discmc_text(DISCMC_DEVICE_ERROR + 1)) == "unknown status");
}

TEST_CASE("chains and polygons are the same through C") {
  const Incidence up = incidence_of(Vertex{0, 0, 1});
  // A square of side 3, its first side in two runs.
  const Direction right = direction_of(up, Vertex{2, 0, 0});
  const Direction back = direction_of(up, Vertex{0, 2, 0});
  std::vector<discmc_run> runs;
  for (const auto& [direction, length] : {std::pair{right, 1U},
                                          {right, 2U},
                                          {back, 3U},
                                          {opposite_direction(up, right), 3U},
                                          {opposite_direction(up, back), 3U}})
    runs.push_back(discmc_run_straight(direction, length));
  const auto count = static_cast<uint32_t>(runs.size());
  CHECK(discmc_run_direction(runs[1]) == right);
  CHECK(discmc_run_length(runs[1]) == 2);
  CHECK(discmc_normal(up).z == 1);
  CHECK(discmc_direction_count(up) == 8);
  CHECK(discmc_direction_vector(up, back).y == 2);
  CHECK(discmc_displacement(up, runs.data(), 2).x == 6);
  CHECK(discmc_twice_area(up, runs.data(), count) == 2 * 36);
  REQUIRE(discmc_link_count(runs.data(), count) == 12);

  std::vector<discmc_vertex> vertices(12);
  discmc_unfold(up, {1, 0, 0}, runs.data(), count, vertices.data());
  CHECK(vertices[3].x == 7);
  std::vector<uint32_t> scratch(24);
  std::vector<discmc_vertex> ring;
  const discmc_ring_receiver receiver = {
      &ring, [](void* context, const discmc_vertex* simple, uint32_t length) {
        static_cast<std::vector<discmc_vertex>*>(context)->assign(simple, simple + length);
      }};
  discmc_split_ring(vertices.data(), 12, scratch.data(), &receiver);
  REQUIRE(ring.size() == 12);
  std::vector<discmc_vertex> all = ring;
  CHECK(discmc_twice_area_of_ring(up, ring.data(), 12) == 2 * 36);
  CHECK(discmc_is_corner(ring.data(), 12, 3) == 1);
  CHECK(discmc_is_corner(ring.data(), 12, 1) == 0);
  CHECK(discmc_keep_corners(ring.data(), 12, nullptr, nullptr) == 4);
  const auto keep = [](void*, const discmc_vertex* vertex) {
    return static_cast<uint8_t>(vertex->x == 3);
  };
  CHECK(discmc_keep_corners(all.data(), 12, keep, nullptr) == 6);

  CHECK(discmc_is_closed(up, runs.data(), count) == 1);
  CHECK(discmc_is_closed(up, runs.data(), count - 1) == 0);
  discmc_reverse(up, runs.data(), count);
  CHECK(discmc_twice_area(up, runs.data(), count) == -2 * 36);
}

TEST_CASE("runs are taken in through C as well") {
  discmc_run side = discmc_run_straight(2, 3);
  CHECK(discmc_run_absorb(&side, discmc_run_straight(2, 4)) == 1);
  CHECK(discmc_run_length(side) == 7);
  CHECK(discmc_run_absorb(&side, discmc_run_straight(3, 4)) == 0);
  CHECK(discmc_run_absorb(&side, discmc_run_straight(2, DISCMC_RUN_MAX_LENGTH)) == 0);
  CHECK(discmc_run_length(side) == 7);
}

TEST_CASE("the lattice is the same through C") {
  for (uint8_t incidence = 0; incidence < DISCMC_INCIDENCE_CODES; ++incidence) {
    if (incidence == DISCMC_NO_INCIDENCE) continue;
    CHECK(are_equal(discmc_normal(incidence), normal(incidence)));
    CHECK(discmc_incidence_of(discmc_normal(incidence)) == incidence);
    CHECK(discmc_opposite(incidence) == opposite(incidence));
    REQUIRE(discmc_direction_count(incidence) == direction_count(incidence));
    for (Link link = 0; link < DISCMC_LINK_CODES; ++link) {
      CHECK(discmc_direction_of(incidence, link) == direction_of(incidence, link));
      CHECK(discmc_direction_of_vector(incidence, discmc_link_vector(link)) ==
            direction_of(incidence, link));
    }
    for (Direction from = 0; from < direction_count(incidence); ++from) {
      CHECK(discmc_link_of(incidence, from) == link_of(incidence, from));
      CHECK(are_equal(discmc_direction_vector(incidence, from), direction_vector(incidence, from)));
      CHECK(discmc_opposite_direction(incidence, from) == opposite_direction(incidence, from));
      for (Direction to = 0; to < direction_count(incidence); ++to)
        CHECK(discmc_turn(incidence, from, to) == turn(incidence, from, to));
    }
  }
  for (Link link = 0; link < DISCMC_LINK_CODES; ++link) {
    CHECK(are_equal(discmc_link_vector(link), link_vector(link)));
    CHECK(discmc_opposite_link(link) == opposite_link(link));
  }
}

TEST_CASE("planes are the same through C") {
  for (uint8_t incidence = 0; incidence < 30; ++incidence) {
    REQUIRE((discmc_is_incidence(incidence) != 0) == is_incidence(incidence));
    if (!is_incidence(incidence)) continue;
    const Vertex vertex{3, -4, 1 << 30};
    const discmc_vertex in_c = {3, -4, 1 << 30};
    CHECK(discmc_plane_offset(incidence, in_c) == plane_offset(incidence, vertex));
    CHECK(discmc_projected(incidence, in_c).u == projected(incidence, vertex).u);
    CHECK(discmc_projected(incidence, in_c).v == projected(incidence, vertex).v);
    for (Direction direction = 0; direction < 9; ++direction) {
      CHECK((discmc_is_direction_of(incidence, direction) != 0) ==
            is_direction_of(incidence, direction));
      if (!is_direction_of(incidence, direction)) continue;
      const Run run = Run::straight(direction, 5);
      CHECK(are_equal(discmc_after_run(incidence, in_c, run.code()),
                      after_run(incidence, vertex, run)));
      const PlanePoint beside = point_beside(incidence, vertex, direction);
      const discmc_plane_point told = discmc_point_beside(incidence, in_c, direction);
      CHECK(told.u == beside.u);
      CHECK(told.v == beside.v);
      const PlaneSide side(incidence, vertex, run);
      for (int64_t away = -100; away <= 100; away += 25)
        CHECK((discmc_meets_ray(incidence, in_c, run.code(), {told.u + away, told.v}) != 0) ==
              side.meets_ray({beside.u + away, beside.v}));
    }
    for (const uint32_t code : {0U, 8U, 15U, 0xFFFFFFFFU, 0x80000000U})
      CHECK((discmc_is_run_of(incidence, code) != 0) == is_run_of(incidence, Run::from_code(code)));
  }
}

TEST_CASE("the facets of all configurations are the same through C") {
  uint32_t total = 0;
  for (int c = 0; c < configurations; ++c) {
    const auto configuration = static_cast<Configuration>(c);
    const discmc_cell_facts facts = discmc_facts_of(configuration);
    CHECK(facts.facets == cell_facts.facets[c]);
    CHECK(facts.classic_triangles == cell_facts.classic_triangles[c]);
    CHECK(facts.enclosed == cell_facts.enclosed[c]);
    for (uint32_t i = 0; i < facts.facets; ++i, ++total) {
      const uint8_t facet = discmc_facet_at(configuration, i);
      CHECK(facet == facet_table.facet[facet_table.first[c] + i]);
      CHECK(discmc_incidence_of_facet(facet) == incidence_of(Facet{facet}));
    }
  }
  CHECK(total == FacetTable::total);
  for (int facet = 0; facet < facet_codes; ++facet) {
    const discmc_facet_ring ring = discmc_ring_of_facet(static_cast<Facet>(facet));
    REQUIRE(ring.count == facet_rings.ring[facet].count);
    for (uint32_t i = 0; i < ring.count; ++i)
      CHECK(are_equal(ring.vertices[i], position(facet_rings.ring[facet].point[i])));
    for (uint32_t edge = 0; edge < ring.count; ++edge) {
      const discmc_neighbour told = discmc_across_edge(static_cast<Facet>(facet), edge);
      const Neighbour expected = across_edge(static_cast<Facet>(facet), static_cast<int>(edge));
      CHECK(told.facet == expected.facet);
      CHECK(are_equal(told.cell, expected.cell));
    }
  }
}
