// Frames of any length that ByteOutput allows carry the same events, and never exceed that length.
#include <discmc/receiver.hpp>

#include "oracle/slice_config.hpp"
#include "oracle/slice_stream.hpp"
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using reference::require_ok;

namespace {

constexpr uint16_t lengths[] = {48, 49, 57, 64, 100, 200, 255, 256};

ByteOutput limited(Line& line, uint16_t max_frame) {
  ByteOutput output = line.output();
  output.max_frame = max_frame;
  return output;
}

bool is_of_surface(const Bytes& frame) {
  const auto kind = static_cast<detail::wire::PacketKind>(packet_of(frame).kind);
  return kind == detail::wire::PacketKind::records || kind >= detail::wire::PacketKind::slices;
}

void check_lengths(const Bytes& stream, uint16_t max_frame) {
  size_t longest = 0;
  for (const Bytes& frame : frames_of(stream))
    if (is_of_surface(frame)) longest = std::max(longest, frame.size());
  CHECK(longest <= max_frame);
  CHECK(longest > max_frame / 2U);
}

Event with_normal(const RecordedEvent& recorded, Chance& chance) {
  Event event = recorded.event();
  if (event.kind == Event::Kind::run) event.normal = {chance.byte(), chance.byte()};
  return event;
}

/// A stream of these events, with normals.
Bytes with_normals(const Events& events, const StreamHeader& header, uint16_t max_frame) {
  Line line;
  NormalEncoder encoder;
  require_ok(begin_stream(encoder, header, limited(line, max_frame)));
  Chance chance(7);
  for (const RecordedEvent& recorded : events)
    REQUIRE(encoder.accept(with_normal(recorded, chance)) == SinkResult::accepted);
  REQUIRE(encoder.flush() == Status::ok);
  return line.bytes;
}

}  // namespace

TEST_CASE("short frames transmit all regions, fragments and normals") {
  for (const uint16_t length : lengths)
    for (const uint64_t memory : {uint64_t{3000}, uint64_t{100000}}) {
      INFO("length ", length, ", memory ", memory);
      const BitVolume volume = reference::random({20, 15, 10}, 100, length);
      const Events events = events_of(volume, Extractor32::default_capacities({20, 15}, memory));
      Line line;
      Encoder encoder;
      require_ok(begin_stream(encoder, header_of(volume), limited(line, length)));
      encode_all(encoder, events);
      check_lengths(line.bytes, length);
      const Received received = decode(line.bytes);
      CHECK(received.report.is_complete());
      CHECK(received.events == events);

      const Bytes stream = with_normals(events, header_of(volume), length);
      check_lengths(stream, length);
      CHECK(decode(stream).events ==
            decode(with_normals(events, header_of(volume), detail::wire::max_frame)).events);
    }
}

TEST_CASE("a short frame has room for the most distant starts and the longest runs") {
  constexpr int32_t far = 2 * static_cast<int32_t>(Limits::max_extent) - 1;
  StreamHeader header = any_header();
  header.width = header.height = Limits::max_extent;
  Script script;
  for (int32_t i = 0; i < 40; ++i) {
    const int32_t low = i % 2 == 0 ? 1 : far;
    script.region(up).square({low, far + 1 - low, i % 3 * 700000000}, 30000).region_end();
  }
  const Bytes stream = with_normals(script.events, header, ByteOutput::min_frame_limit);
  check_lengths(stream, ByteOutput::min_frame_limit);
  CHECK(decode(stream).events.size() == script.events.size());
}

TEST_CASE("short frames transmit all slices of several surfaces") {
  for (const uint16_t length : lengths)
    for (const uint32_t interval : {0U, 1U, 3U}) {
      INFO("length ", length, ", interval ", interval);
      const BitVolume volume = reference::random({67, 20, 6}, 128, length);
      StreamHeader header = header_of(volume);
      header.surface_count = 2;
      header.thresholds[1] = header.thresholds[0];
      Line line;
      StartedSliceEncoder encoder(header, limited(line, length), interval);
      require_ok(encoder.push(volume.on.data(), static_cast<uint32_t>(volume.voxels())).status);
      require_ok(encoder.finish());
      check_lengths(line.bytes, length);
      EventLog log;
      Bytes room(Receiver::minimum_bytes({volume.width, volume.height}, 2) + 500000);
      Receiver receiver;
      require_ok(receiver.start(memory_of(room), make_sink(log)));
      CHECK(receiver.push(line.bytes.data(), line.bytes.size()).status == Status::finished);
      CHECK(receiver.report().is_complete());
      CHECK(log.events == events_of(volume));
    }
}

TEST_CASE("frame lengths outside the limits of ByteOutput are refused") {
  Line line;
  for (const uint16_t length : {uint16_t{1}, uint16_t{47}, uint16_t{257}, uint16_t{65535}}) {
    Encoder encoder;
    CHECK(encoder.start({}, limited(line, length)) == Status::bad_sink);
    StreamHeader header;
    header.width = header.height = 4;
    Bytes memory(SliceEncoder::minimum_bytes({{4, 4}}));
    SliceEncoder slices;
    CHECK(slices.start(slice_config(header), memory_of(memory), limited(line, length)) ==
          Status::bad_sink);
  }
}
