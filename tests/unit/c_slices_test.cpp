// The C functions of streams of bits do what the C++ functions do, byte for byte and event for
// event.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <cstring>
#include <discmc/surface_decoder.hpp>

#include "oracle/c_row_events.hpp"
#include "oracle/slice_stream.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::Block;
using reference::c_sink_to;
using reference::counts;
using reference::from_c;

namespace {

constexpr uint32_t width = 37, height = 13, depth = 7;
constexpr Limits limits{width, height};
constexpr discmc_limits limits_in_c = {width, height, DISCMC_CLOSED, {}};

discmc_memory in_c(const Memory& memory) {
  return {memory.data, memory.bytes};
}
discmc_byte_output in_c(const ByteOutput& output) {
  return {output.context, output.write};
}

discmc_stream_header header_in_c(uint8_t surfaces) {
  // Static, so that its padding is 0: it goes into checkpoints, too.
  static discmc_stream_header header = {
      width, height, depth, {1000, -2000, 3000}, 100, DISCMC_CLOSED, 5, 700, 0, {120, 90, -4}};
  header.further_surfaces = static_cast<uint8_t>(surfaces - 1);
  return header;
}

// A wall that is rough, so that every threshold has a surface.
template <class Sample>
std::vector<Sample> make_samples() {
  std::vector<Sample> samples;
  Chance chance(3);
  for (uint32_t i = 0; i < width * height * depth; ++i)
    samples.push_back(
        static_cast<Sample>((i % width > 9 && i % width < 30 ? 95 : 60) + chance.below(30)));
  return samples;
}

discmc_push_result push(discmc_slice_encoder* encoder, const uint8_t* samples, uint32_t stride) {
  return discmc_slice_encoder_push_u8(encoder, samples, width, stride);
}
discmc_push_result push(discmc_slice_encoder* encoder, const uint16_t* samples, uint32_t stride) {
  return discmc_slice_encoder_push_u16(encoder, samples, width, stride);
}
discmc_push_result push(discmc_slice_encoder* encoder, const int16_t* samples, uint32_t stride) {
  return discmc_slice_encoder_push_i16(encoder, samples, width, stride);
}

bool succeeds(discmc_slice_encoder& encoder, discmc_status status) {
  while (status == DISCMC_MORE) status = discmc_slice_encoder_resume(&encoder);
  return status == DISCMC_OK;
}
bool succeeds(SliceEncoder& encoder, Status status) {
  while (status == Status::more) status = encoder.resume();
  return status == Status::ok;
}

constexpr uint8_t bits_of_row[4 * 5] = {1, 2, 3, 4, 5, 0xFF, 0x7F, 0, 0, 1, 9, 8, 7, 6, 5};
constexpr uint8_t told[3] = {7, 0, 9};

// A scan with a row of bits, one that never comes, a flush, a power failure, a record and another
// line.
template <class Sample>
Bytes encode_in_c(const std::vector<Sample>& samples, uint32_t interval, uint8_t surfaces,
                  size_t bytes_a_time) {
  Line line(bytes_a_time), other(bytes_a_time);
  Block block(discmc_slice_encoder_bytes_for(&limits_in_c, interval, surfaces));
  Block later(block.memory().bytes);
  discmc_slice_encoder encoder = {};
  const discmc_stream_header header = header_in_c(surfaces);
  REQUIRE(discmc_slice_encoder_start(&encoder, &header, interval, in_c(block.memory()),
                                     in_c(line.output())) == DISCMC_OK);
  for (uint32_t row = 0; row < height * depth; ++row) {
    const Sample* const first = &samples[size_t{row} * width];
    discmc_push_result result = {DISCMC_MORE, 0};
    while (result.samples == 0)
      result = row == 20   ? discmc_slice_encoder_push_bits(&encoder, bits_of_row)
               : row == 30 ? discmc_slice_encoder_skip_row(&encoder, DISCMC_PREVIOUS_ROW)
               : row == 31 ? push(&encoder, first, 2)
                           : push(&encoder, first, 1);
    REQUIRE(result.samples == width);
    REQUIRE(succeeds(encoder, result.status));
    if (row == 40) {
      discmc_status status = DISCMC_MORE;
      while (status == DISCMC_MORE) status = discmc_slice_encoder_flush(&encoder);
      REQUIRE(status == DISCMC_OK);
    }
    if (row == 45) {
      discmc_slice_encoder_checkpoint checkpoint = {};
      REQUIRE(discmc_slice_encoder_save(&encoder, &checkpoint) == DISCMC_OK);
      std::memcpy(later.memory().data, block.memory().data,
                  discmc_slice_encoder_bytes_used(&encoder));
      encoder = {};
      REQUIRE(discmc_slice_encoder_restore(&encoder, &checkpoint, in_c(later.memory()),
                                           in_c(line.output())) == DISCMC_OK);
      line.bytes.resize(discmc_slice_encoder_bytes(&encoder));
    }
    if (row == 50) {
      const discmc_application_record record = {11, 0, 0, told, sizeof told};
      discmc_status status = DISCMC_MORE;
      while (status == DISCMC_MORE) status = discmc_slice_encoder_tell(&encoder, &record);
      REQUIRE(status == DISCMC_OK);
      CHECK(discmc_slice_encoder_slices(&encoder) == 3);
      CHECK(discmc_slice_encoder_rows(&encoder) == 12);
    }
    if (row == 60) discmc_slice_encoder_set_output(&encoder, in_c(other.output()));
  }
  REQUIRE(succeeds(encoder, discmc_slice_encoder_finish(&encoder)));
  line.bytes.insert(line.bytes.end(), other.bytes.begin(), other.bytes.end());
  CHECK(discmc_slice_encoder_bytes(&encoder) == line.bytes.size());
  CHECK(block.is_intact());
  CHECK(later.is_intact());
  return line.bytes;
}

template <class Sample>
Bytes encode_in_cpp(const std::vector<Sample>& samples, uint32_t interval, uint8_t surfaces) {
  Line line, other;
  Block block(slice_encoder_bytes(limits, {interval}, surfaces));
  SliceEncoder encoder;
  reference::require_ok(
      encoder.start(from_c(header_in_c(surfaces)), {interval}, block.memory(), line.output()));
  for (uint32_t row = 0; row < height * depth; ++row) {
    const Sample* const first = &samples[size_t{row} * width];
    const PushResult result = row == 20   ? encoder.push_bits(bits_of_row)
                              : row == 30 ? encoder.skip_row(Substitute::previous_row)
                              : row == 31 ? encoder.push(first, width, 2)
                                          : encoder.push(first, width);
    REQUIRE(result.samples == width);
    if (row == 40) reference::require_ok(encoder.flush());
    if (row == 50) reference::require_ok(encoder.tell({11, 0, 0, told, sizeof told}));
    if (row == 60) encoder.set_output(other.output());
  }
  REQUIRE(succeeds(encoder, encoder.finish()));
  line.bytes.insert(line.bytes.end(), other.bytes.begin(), other.bytes.end());
  return line.bytes;
}

Bytes some_stream(uint8_t surfaces = 1, uint32_t interval = 2) {
  return encode_in_cpp(make_samples<uint8_t>(), interval, surfaces);
}

/// Takes row events of either side, and refuses every nth (0: none) of those that may be.
struct RowListener {
  std::vector<std::vector<int64_t>> events;
  uint32_t nth = 0;
  uint32_t calls = 0;

  Answer take(const RowEvent& event) {
    if (nth != 0 && ++calls % nth == 0) return Answer::not_now;
    events.push_back(reference::numbers_of(event, width));
    return Answer::taken;
  }
  static discmc_answer take_in_c(void* context, const discmc_row_event* event) {
    StreamHeader header;
    ApplicationRecord application;
    const RowEvent same = from_c(*event, header, application);
    return static_cast<discmc_answer>(static_cast<RowListener*>(context)->take(same));
  }
  discmc_row_sink sink_in_c() { return {this, take_in_c}; }
};

// The decoders of C as push_stream() knows those of C++.
struct SliceDecoderInC {
  discmc_slice_decoder decoder = {};
  Decoded push(const uint8_t* bytes, size_t count) {
    const discmc_decoded decoded = discmc_slice_decoder_push(&decoder, bytes, count);
    return {static_cast<Status>(decoded.status), decoded.bytes};
  }
  Status finish() { return static_cast<Status>(discmc_slice_decoder_finish(&decoder)); }
};
struct SurfaceDecoderInC {
  discmc_surface_decoder decoder = {};
  Decoded push(const uint8_t* bytes, size_t count) {
    const discmc_decoded decoded = discmc_surface_decoder_push(&decoder, bytes, count);
    return {static_cast<Status>(decoded.status), decoded.bytes};
  }
  Status finish() { return static_cast<Status>(discmc_surface_decoder_finish(&decoder)); }
};

void check_report(const discmc_stream_report& c, const StreamReport& cpp) {
  CHECK((c.has_header != 0) == cpp.has_header);
  CHECK((c.holds_slices != 0) == cpp.holds_slices);
  CHECK((c.has_trailer != 0) == cpp.has_trailer);
  CHECK((c.abandoned != 0) == cpp.abandoned);
  CHECK((c.is_unreadable != 0) == cpp.is_unreadable);
  CHECK((c.is_mixed != 0) == cpp.is_mixed);
  CHECK((c.is_complete != 0) == cpp.is_complete());
  CHECK(c.bytes == cpp.bytes);
  CHECK(c.packets == cpp.packets);
  CHECK(c.repeated_packets == cpp.repeated_packets);
  CHECK(c.damaged_packets == cpp.damaged_packets);
  CHECK(c.foreign_packets == cpp.foreign_packets);
  CHECK(c.lost_packets == cpp.lost_packets);
  CHECK(c.regions == cpp.regions);
  CHECK(c.fragments == cpp.fragments);
  CHECK(c.lost_pieces == cpp.lost_pieces);
  CHECK(c.rows == cpp.rows);
  CHECK(c.lost_rows == cpp.lost_rows);
  CHECK(c.total_rows == cpp.total_rows);
  CHECK(c.slices == cpp.slices);
  CHECK(counts(from_c(c.totals)) == counts(cpp.totals));
}

void check_header(const discmc_stream_header& c, const StreamHeader& cpp) {
  CHECK(c.width == cpp.width);
  CHECK(c.height == cpp.height);
  CHECK(c.depth == cpp.depth);
  for (int i = 0; i < 3; ++i) {
    CHECK(c.spacing_nm[i] == cpp.spacing_nm[i]);
    CHECK(c.further_thresholds[i] == cpp.further_thresholds[i]);
  }
  CHECK(c.threshold == cpp.threshold);
  CHECK(c.border == static_cast<uint8_t>(cpp.border));
  CHECK(c.channel == cpp.channel);
  CHECK(c.scan == cpp.scan);
  CHECK(c.further_surfaces == cpp.further_surfaces);
}

// Decodes to rows on both sides; some refusals in C change nothing. Returns the report.
StreamReport check_rows(const Bytes& stream, uint8_t surfaces) {
  Block block(discmc_slice_decoder_bytes_for(&limits_in_c, surfaces));
  RowListener listener_c, listener_cpp;
  listener_c.nth = 3;
  SliceDecoderInC in_c_too;
  const discmc_row_sink sink = listener_c.sink_in_c();
  REQUIRE(discmc_slice_decoder_start(&in_c_too.decoder, in_c(block.memory()), &sink,
                                     DISCMC_ANY_CHANNEL) == DISCMC_OK);
  reference::require_ok(push_stream(in_c_too, stream, 11));
  CHECK(block.is_intact());

  Block block_of_cpp(slice_decoder_bytes(limits, surfaces));
  SliceDecoder decoder;
  reference::require_ok(decoder.start(block_of_cpp.memory(), row_sink_to(listener_cpp)));
  reference::require_ok(push_stream(decoder, stream, 0));
  CHECK(listener_c.events == listener_cpp.events);
  check_report(discmc_slice_decoder_report(&in_c_too.decoder), decoder.report());
  check_header(discmc_slice_decoder_header(&in_c_too.decoder), decoder.header());
  return decoder.report();
}

// The same to surfaces. bytes: of memory.
StreamReport check_surface(const Bytes& stream, size_t bytes, uint8_t channel) {
  Block block(bytes), block_of_cpp(bytes);
  EventLog log_c([](uint64_t offer) { return offer % 3 == 2; }), log_cpp;
  SurfaceDecoderInC in_c_too;
  const discmc_sink sink = c_sink_to(log_c);
  REQUIRE(discmc_surface_decoder_start(&in_c_too.decoder, in_c(block.memory()), &sink, channel) ==
          DISCMC_OK);
  reference::require_ok(push_stream(in_c_too, stream, 11));
  CHECK(block.is_intact());

  SurfaceDecoder decoder;
  reference::require_ok(decoder.start(block_of_cpp.memory(), sink_to(log_cpp), channel));
  reference::require_ok(push_stream(decoder, stream, 0));
  CHECK(log_c.events.size() > 100);
  CHECK(log_c.events == log_cpp.events);
  check_report(discmc_surface_decoder_report(&in_c_too.decoder), decoder.report());
  check_header(discmc_surface_decoder_header(&in_c_too.decoder), decoder.header());
  return decoder.report();
}

}  // namespace

TEST_CASE("a stream of bits through C is byte for byte that of C++, on any line") {
  const auto check = [](const auto& samples) {
    for (const uint32_t interval : {0U, 1U, 3U})
      for (const uint8_t surfaces : {uint8_t{1}, uint8_t{4}})
        for (const size_t bytes_a_time : {0U, 100U})
          CHECK(encode_in_c(samples, interval, surfaces, bytes_a_time) ==
                encode_in_cpp(samples, interval, surfaces));
  };
  check(make_samples<uint8_t>());
  check(make_samples<uint16_t>());
  check(make_samples<int16_t>());
}

TEST_CASE("rows come out of a stream of bits through C as in C++, and so does what is lost") {
  for (const uint8_t surfaces : {uint8_t{1}, uint8_t{3}}) {
    const Bytes stream = some_stream(surfaces);
    const StreamReport whole = check_rows(stream, surfaces);
    CHECK(whole.is_complete());
    CHECK(whole.holds_slices);
    CHECK(whole.rows == height * depth);
    CHECK(whole.totals.skipped_rows == 1);
    std::vector<Bytes> frames = frames_of(stream);
    frames.erase(frames.begin() + 3);
    const StreamReport torn = check_rows(joined(frames), surfaces);
    CHECK(torn.lost_packets == 1);
    CHECK(torn.lost_rows > 0);
    CHECK(torn.total_rows == height * depth);
  }
}

TEST_CASE("a surface decoder through C makes the same events, in any memory, of each surface") {
  const size_t least = minimum_surface_bytes(limits, 3);
  const Bytes stream = some_stream(3);
  for (const size_t bytes : {least, least + 3000, least + 300000})
    for (const uint8_t channel : {uint8_t{DISCMC_ANY_CHANNEL}, uint8_t{6}, uint8_t{7}})
      CHECK(check_surface(stream, bytes, channel).is_complete());
  std::vector<Bytes> frames = frames_of(stream);
  frames.erase(frames.begin() + 3);
  CHECK(check_surface(joined(frames), least, 6).lost_rows > 0);
}

TEST_CASE("a surface decoder through C takes streams of regions, without memory") {
  const Bytes stream = encode(events_of(reference::random({9, 9, 9}, 100, 4)));
  const StreamReport report = check_surface(stream, 0, DISCMC_ANY_CHANNEL);
  CHECK(report.is_complete());
  CHECK_FALSE(report.holds_slices);
  CHECK(report.regions > 10);
}

TEST_CASE("a decoder of bits is given memory through C when the header has told how much") {
  const Bytes stream = some_stream();
  Block block(discmc_minimum_surface_bytes(&limits_in_c, 1));
  const discmc_memory all = in_c(block.memory());
  const discmc_memory little = {all.data, 100};
  const auto check = [&](auto& decoder, auto give_memory) {
    const Decoded decoded = decoder.push(stream.data(), stream.size());
    CHECK(decoded.status == Status::too_little_memory);
    CHECK(decoder.push(stream.data(), 1).bytes == 0);
    CHECK(decoder.finish() == Status::too_little_memory);
    CHECK(give_memory(&decoder.decoder, little) == DISCMC_TOO_LITTLE_MEMORY);
    CHECK(give_memory(&decoder.decoder, all) == DISCMC_OK);
    const Bytes rest(stream.begin() + static_cast<ptrdiff_t>(decoded.bytes), stream.end());
    CHECK(push_stream(decoder, rest, 0) == Status::ok);
  };
  RowListener listener;
  const discmc_row_sink rows = listener.sink_in_c();
  SliceDecoderInC slices;
  REQUIRE(discmc_slice_decoder_start(&slices.decoder, {}, &rows, 5) == DISCMC_OK);
  check(slices, discmc_slice_decoder_give_memory);
  CHECK(discmc_slice_decoder_report(&slices.decoder).is_complete == 1);
  EventLog log;
  const discmc_sink events = c_sink_to(log);
  SurfaceDecoderInC surface;
  REQUIRE(discmc_surface_decoder_start(&surface.decoder, {}, &events, 5) == DISCMC_OK);
  check(surface, discmc_surface_decoder_give_memory);
  CHECK(discmc_surface_decoder_report(&surface.decoder).is_complete == 1);
}

TEST_CASE("a slice encoder of zeros is not started, and refuses through C what it does in C++") {
  discmc_slice_encoder encoder = {};
  const std::vector<uint8_t> samples(width);
  const auto refuses_all = [&](discmc_status status) {
    CHECK(push(&encoder, samples.data(), 1).status == status);
    CHECK(discmc_slice_encoder_push_bits(&encoder, samples.data()).status == status);
    CHECK(discmc_slice_encoder_skip_row(&encoder, DISCMC_OFF).status == status);
  };
  const discmc_application_record record = {}, too_long = {0, 0, 0, samples.data(), 201};
  refuses_all(DISCMC_NOT_STARTED);
  CHECK(discmc_slice_encoder_resume(&encoder) == DISCMC_NOT_STARTED);
  CHECK(discmc_slice_encoder_flush(&encoder) == DISCMC_NOT_STARTED);
  CHECK(discmc_slice_encoder_tell(&encoder, &record) == DISCMC_NOT_STARTED);
  CHECK(discmc_slice_encoder_finish(&encoder) == DISCMC_NOT_STARTED);
  CHECK(discmc_slice_encoder_abandon(&encoder) == DISCMC_NOT_STARTED);
  CHECK(discmc_slice_encoder_bytes(&encoder) == 0);

  Line line;
  const discmc_byte_output output = in_c(line.output());
  const discmc_stream_header good = header_in_c(1);
  Block block(discmc_slice_encoder_bytes_for(&limits_in_c, 0, 1));
  const discmc_memory all = in_c(block.memory());
  const discmc_memory little = {all.data, all.bytes - 1};
  discmc_stream_header bad = good;
  bad.width = 0;
  CHECK(discmc_slice_encoder_start(&encoder, &bad, 0, all, output) == DISCMC_BAD_LIMITS);
  bad = header_in_c(DISCMC_MAX_SURFACES + 1);
  CHECK(discmc_slice_encoder_start(&encoder, &bad, 0, all, output) == DISCMC_BAD_LABEL);
  CHECK(discmc_slice_encoder_start(&encoder, &good, 0, all, {}) == DISCMC_BAD_SINK);
  CHECK(discmc_slice_encoder_start(&encoder, &good, 0, little, output) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_slice_encoder_resume(&encoder) == DISCMC_NOT_STARTED);
  CHECK(line.bytes.empty());

  REQUIRE(discmc_slice_encoder_start(&encoder, &good, 0, all, output) == DISCMC_OK);
  CHECK(discmc_slice_encoder_tell(&encoder, &too_long) == DISCMC_BAD_RECORD);
  CHECK(discmc_slice_encoder_push_u8(&encoder, samples.data(), 4, 1).samples == 4);
  CHECK(discmc_slice_encoder_push_bits(&encoder, samples.data()).status == DISCMC_ROW_IN_PROGRESS);
  CHECK(discmc_slice_encoder_finish(&encoder) == DISCMC_SLICE_IN_PROGRESS);
  CHECK(discmc_slice_encoder_abandon(&encoder) == DISCMC_OK);
  refuses_all(DISCMC_FINISHED);
  CHECK(discmc_slice_encoder_tell(&encoder, &record) == DISCMC_FINISHED);
  CHECK(decode_slices(line.bytes, {width, height, depth}).report.abandoned);
}

TEST_CASE("decoders of zeros are not started, and start with a sink alone") {
  SliceDecoderInC slices;
  SurfaceDecoderInC surface;
  const uint8_t byte = 0;
  CHECK(slices.push(&byte, 1).status == Status::not_started);
  CHECK(slices.finish() == Status::not_started);
  CHECK(discmc_slice_decoder_give_memory(&slices.decoder, {}) == DISCMC_NOT_STARTED);
  CHECK(discmc_slice_decoder_report(&slices.decoder).bytes == 0);
  CHECK(surface.push(&byte, 1).status == Status::not_started);
  CHECK(surface.finish() == Status::not_started);
  CHECK(discmc_surface_decoder_give_memory(&surface.decoder, {}) == DISCMC_NOT_STARTED);
  CHECK(discmc_surface_decoder_report(&surface.decoder).bytes == 0);
  const discmc_row_sink no_rows = {};
  const discmc_sink no_events = {};
  CHECK(discmc_slice_decoder_start(&slices.decoder, {}, &no_rows, DISCMC_ANY_CHANNEL) ==
        DISCMC_BAD_SINK);
  CHECK(discmc_surface_decoder_start(&surface.decoder, {}, &no_events, DISCMC_ANY_CHANNEL) ==
        DISCMC_BAD_SINK);
  CHECK(slices.push(&byte, 1).status == Status::not_started);
  CHECK(surface.push(&byte, 1).status == Status::not_started);
}

TEST_CASE("a key slice in the middle of a code is none, for a decoder of zeros as for any other") {
  std::vector<Bytes> frames = frames_of(some_stream());
  Packet key = packet_of(frames[1]);
  REQUIRE((key.kind & wire::SliceBits::key) != 0);
  key.kind = static_cast<uint8_t>(key.kind & ~wire::SliceBits::first);
  frames[1] = frame_of(key);
  const StreamReport report = check_rows(joined(frames), 1);
  CHECK(report.is_unreadable);
  CHECK(report.lost_rows > 0);
}

TEST_CASE("a row sink is copied, and a start in vain leaves it") {
  const Bytes stream = some_stream();
  Block block(discmc_slice_decoder_bytes_for(&limits_in_c, 1));
  RowListener listener;
  discmc_row_sink sink = listener.sink_in_c();
  SliceDecoderInC slices;
  REQUIRE(discmc_slice_decoder_start(&slices.decoder, in_c(block.memory()), &sink,
                                     DISCMC_ANY_CHANNEL) == DISCMC_OK);
  sink = {};
  CHECK(discmc_slice_decoder_start(&slices.decoder, {}, &sink, DISCMC_ANY_CHANNEL) ==
        DISCMC_BAD_SINK);
  CHECK(push_stream(slices, stream, 0) == Status::ok);
  CHECK(listener.events.size() > height * depth);
}

TEST_CASE("sizes of streams of bits are the same in C, as functions and as constants") {
  const uint32_t extents[] = {1, 2, 3, 7, 29, 30, 31, 32, 33, 59, 60, 64, 256, 4095, 32766};
  for (const uint32_t w : extents)
    for (const uint32_t h : extents)
      for (const uint32_t surfaces : {1U, 2U, 4U}) {
        CAPTURE(w);
        CAPTURE(h);
        CAPTURE(surfaces);
        const Limits size{w, h};
        const discmc_limits size_in_c = {w, h, DISCMC_CLOSED, {}};
        for (const uint32_t interval : {0U, 1U, 2U}) {
          const uint64_t bytes = slice_encoder_bytes(size, {interval}, surfaces);
          REQUIRE(discmc_slice_encoder_bytes_for(&size_in_c, interval, surfaces) == bytes);
          REQUIRE(DISCMC_SLICE_ENCODER_BYTES_FOR(w, h, interval, surfaces) == bytes);
        }
        const uint64_t of_rows = slice_decoder_bytes(size, surfaces);
        REQUIRE(discmc_slice_decoder_bytes_for(&size_in_c, surfaces) == of_rows);
        REQUIRE(DISCMC_SLICE_DECODER_BYTES_FOR(w, h, surfaces) == of_rows);
        const uint64_t least = minimum_surface_bytes(size, surfaces);
        REQUIRE(discmc_minimum_surface_bytes(&size_in_c, surfaces) == least);
        REQUIRE(DISCMC_MINIMUM_SURFACE_BYTES(w, h, surfaces) == least);
      }
}
