// The user's own data is sent with a scan, in the order of the stream.
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

const BitVolume volume = reference::random({12, 10, 8}, 60, 5);

ApplicationRecord record_of(const Bytes& bytes, uint8_t kind = 1, uint32_t slice = 0,
                            uint32_t row = 0) {
  return {kind, slice, row, bytes.data(), bytes.size()};
}

// The bytes of a slice's record: its number, repeated.
Bytes bytes_of_slice(uint32_t slice) {
  return Bytes(slice * 25, static_cast<uint8_t>(slice));
}

// A scan with a record before every slice, and an empty one at the end.
Bytes regions_with_records(size_t bytes_at_once) {
  Line line(bytes_at_once);
  Encoder encoder;
  require_ok(encoder.start({volume.depth}, line.output()));
  Bytes memory(30000);
  Extractor16 extractor;
  require_ok(
      extractor.start({volume.width, volume.height}, 1, memory_of(memory), make_sink(encoder)));
  const uint32_t slice = volume.width * volume.height;
  for (uint32_t z = 0; z < volume.depth; ++z) {
    const Bytes bytes = bytes_of_slice(z);
    until_done([&] {
      const Status status = extractor.resume();
      return status == Status::ok ? encoder.write_record(record_of(bytes, 7, z, extractor.rows()))
                                  : status;
    });
    reference::push_all(extractor, std::vector<uint8_t>(volume.on.begin() + z * slice,
                                                        volume.on.begin() + (z + 1) * slice));
  }
  until_done([&] {
    const Status status = extractor.resume();
    return status == Status::ok ? encoder.write_record({}) : status;
  });
  reference::finish_all(extractor);
  return line.bytes;
}

Bytes slices_with_records(size_t bytes_at_once) {
  Line line(bytes_at_once);
  StartedSliceEncoder encoder(header_of(volume), line.output());
  const uint32_t slice = volume.width * volume.height;
  for (uint32_t z = 0; z < volume.depth; ++z) {
    const Bytes bytes = bytes_of_slice(z);
    until_done([&] { return encoder.write_record(record_of(bytes, 7)); });
    for (uint32_t pushed = 0; pushed < slice;)
      pushed += encoder.push(&volume.on[z * slice + pushed], slice - pushed).samples;
  }
  until_done([&] { return encoder.write_record({}); });
  until_done([&] { return encoder.finish(); });
  return line.bytes;
}

// The events are those of the volume, and the records those that were sent.
void check_records(const Events& events) {
  Events records, others;
  for (const RecordedEvent& event : events)
    (event.is(Event::Kind::application) ? records : others).push_back(event);
  CHECK(others == events_of(volume));
  REQUIRE(records.size() == volume.depth + 1);
  for (uint32_t z = 0; z < volume.depth; ++z) {
    const Event event = records[z].event();
    const ApplicationRecord& record = *event.application;
    CHECK(record.kind == 7);
    CHECK(record.slice == z);
    CHECK(record.row == 0);
    CHECK(Bytes(record.bytes, record.bytes + record.count) == bytes_of_slice(z));
  }
  CHECK(records.back().event().application->count == 0);
}

constexpr Limits limits{12, 10};

}  // namespace

TEST_CASE("records in a stream of regions arrive and leave all other events unchanged") {
  for (const size_t bytes_at_once : {size_t{0}, size_t{1}, size_t{50}}) {
    const Received received = decode(regions_with_records(bytes_at_once));
    CHECK(received.status == Status::ok);
    CHECK(received.report.is_complete());
    check_records(received.events);
  }
}

TEST_CASE("records in a stream of slices arrive before the following row") {
  for (const size_t bytes_at_once : {size_t{0}, size_t{1}, size_t{50}}) {
    const Bytes stream = slices_with_records(bytes_at_once);
    const ReceivedRows rows = decode_slices(stream, {volume.width, volume.height, 0});
    CHECK(rows.report.is_complete());
    uint32_t row = 0, records = 0;
    for (const RecordedRow& recorded : rows.rows) {
      if (recorded.is(RowEvent::Kind::row)) ++row;
      if (!recorded.is(RowEvent::Kind::application)) continue;
      CHECK(row == records * volume.height);
      ++records;
    }
    CHECK(records == volume.depth + 1);
    const Received received = decode_surface(stream, limits);
    CHECK(received.status == Status::ok);
    check_records(received.events);
  }
}

TEST_CASE("a record in a stream of slices is sent at once, with the current slice and row") {
  Line line;
  StartedSliceEncoder encoder(header_of(volume), line.output());
  require_ok(encoder.push(volume.on.data(), volume.width * (2 * volume.height + 3)).status);
  const Bytes bytes{1, 2, 3};
  require_ok(encoder.write_record(record_of(bytes, 7, 99, 99)));
  EventLog log;
  Bytes memory_of_surface(Receiver::minimum_bytes({volume.width, volume.height}) + 100000);
  SurfaceDecoder decoder;
  require_ok(decoder.start(memory_of(memory_of_surface), make_sink(log)));
  require_ok(decoder.push(line.bytes.data(), line.bytes.size()).status);
  REQUIRE_FALSE(log.events.empty());
  const Event event = log.events.back().event();
  REQUIRE(event.kind == Event::Kind::application);
  CHECK(event.application->slice == 2);
  CHECK(event.application->row == 3);
}

TEST_CASE("a row after a record is accepted even if the record is still being sent") {
  LimitedLine line{SIZE_MAX};
  StartedSliceEncoder encoder(header_of(volume), line.output());
  require_ok(encoder.push(volume.on.data(), volume.width).status);
  for (uint32_t row = 1; row < volume.height; ++row) {
    require_ok(encoder.flush());
    line.room = 0;
    require_ok(encoder.write_record(record_of(Bytes(5, 1))));
    const PushResult pushed = encoder.push(&volume.on[size_t{row} * volume.width], volume.width);
    CHECK(pushed.samples == volume.width);
    line.room = SIZE_MAX;
    require_ok(encoder.resume());
    CHECK(encoder.rows() + volume.height * encoder.slices() == row + 1);
  }
}

TEST_CASE("a record waits until a refused event is accepted, in both kinds of streams") {
  for (const Bytes& stream : {regions_with_records(0), slices_with_records(0)}) {
    const Received idle = decode_surface(stream, limits);
    const Received busy = decode_surface(stream, limits, 0, true);
    CHECK(idle.status == Status::ok);
    CHECK(busy.status == Status::ok);
    CHECK(busy.events == idle.events);
  }
}

TEST_CASE("a decoded and re-encoded stream keeps its application records") {
  EventLog log;
  const Bytes stream = regions_with_records(0);
  Encoder encoder;
  Line line;
  require_ok(encoder.start({volume.depth}, line.output()));
  Decoder decoder;
  require_ok(decoder.start(make_sink(encoder)));
  require_ok(decoder.push(stream.data(), stream.size()).status);
  CHECK(encoder.flush() == Status::ok);
  CHECK(line.bytes == stream);
}

TEST_CASE("a record longer than 200 bytes, before the start or within a region is refused") {
  const Bytes most(ApplicationRecord::max_bytes, 0), too_many(ApplicationRecord::max_bytes + 1, 0);
  Line line;
  Encoder encoder;
  CHECK(encoder.write_record(record_of(most)) == Status::not_started);
  require_ok(begin_stream(encoder, any_header(), line.output()));
  CHECK(encoder.write_record(record_of(too_many)) == Status::bad_record);
  require_ok(encoder.write_record(record_of(most)));
  const Events square = Script().region(up).square({1, 0, 0}, 2).region_end().events;
  for (const RecordedEvent& event : square) {
    if (!event.is(Event::Kind::region))
      CHECK(encoder.write_record(record_of(most)) == Status::suspended);
    REQUIRE(encoder.accept(event.event()) == SinkResult::accepted);
  }
  require_ok(encoder.write_record(record_of(most)));
  Bytes memory(SliceEncoder::minimum_bytes({{1, 1}}));
  SliceEncoder slices;
  CHECK(slices.write_record(record_of(most)) == Status::not_started);
  require_ok(slices.start(slice_config(any_header()), memory_of(memory), line.output()));
  CHECK(slices.write_record(record_of(too_many)) == Status::bad_record);
  require_ok(slices.write_record(record_of(most)));
  require_ok(slices.finish());
  CHECK(slices.write_record(record_of(most)) == Status::finished);
}

TEST_CASE("a record is refused once the scan has ended, even if the output is busy") {
  const Bytes bytes(3, 7);
  for (const size_t bytes_at_once : {size_t{0}, size_t{1}}) {
    CAPTURE(bytes_at_once);
    Line line(bytes_at_once);
    Encoder encoder;
    Extractor32 extractor;
    Bytes room(Extractor32::minimum_bytes({1, 1}));
    require_ok(encoder.start({}, line.output()));
    require_ok(extractor.start({1, 1}, 1, memory_of(room), make_sink(encoder)));
    until_done([&] { return extractor.finish(); });
    CHECK(encoder.write_record(record_of(bytes)) == Status::finished);
    while (encoder.flush() == Status::suspended) continue;
    CHECK(encoder.write_record(record_of(bytes)) == Status::finished);
    CHECK(decode(line.bytes).report.repeated_packets == 0);

    Line other(bytes_at_once);
    SliceEncoder slices;
    Bytes memory(SliceEncoder::minimum_bytes({{1, 1}}));
    require_ok(slices.start(slice_config(any_header()), memory_of(memory), other.output()));
    (void)slices.finish();
    CHECK(slices.write_record(record_of(bytes)) == Status::finished);
    until_done([&] { return slices.finish(); });
    CHECK(slices.write_record(record_of(bytes)) == Status::finished);
    CHECK(decode_slices(other.bytes, {1, 1, 1}).report.is_complete());
  }
}

TEST_CASE("an unset record is all zeros, and a record in a too short packet is refused") {
  Line line;
  Encoder encoder;
  require_ok(begin_stream(encoder, any_header(), line.output()));
  require_ok(encoder.write_record({}));
  CHECK(encoder.flush() == Status::ok);
  const std::vector<Bytes> frames = frames_of(line.bytes);
  Packet packet = packet_of(frames[1]);
  CHECK(packet.payload.size() == 9);
  const Events events = decode(joined({frames[0], frame_of(packet)})).events;
  REQUIRE(events.size() == 1);
  const Event event = events[0].event();
  CHECK(event.application->kind == 0);
  CHECK(event.application->slice == 0);
  CHECK(event.application->row == 0);
  packet.payload.pop_back();
  const Received received = decode(joined({frames[0], frame_of(packet)}));
  CHECK(received.events.empty());
  CHECK(received.report.damaged_packets == 1);
}
