// The surface decoder alone: restarts, given memory, and streams with wrong ends.
#include <discmc/receiver.hpp>

#include "oracle/slice_stream.hpp"
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;

namespace {

constexpr Limits limits{12, 8};

const BitVolume& volume() {
  static const BitVolume rough = reference::random({12, 8, 9}, 30, 5);
  return rough;
}

// With rows lost on the way.
Bytes slices_with_a_loss() {
  std::vector<Bytes> frames = frames_of(encode_slices(volume(), {{2}}));
  REQUIRE(frames.size() > 4);
  frames.erase(frames.begin() + 2);
  return joined(frames);
}

Bytes regions() {
  return encode(events_of(volume()), header_of(volume()));
}

Events decoded(SurfaceDecoder& decoder, const Memory& memory, const Bytes& stream) {
  EventLog log;
  reference::require_ok(decoder.start(memory, make_sink(log)));
  reference::require_ok(push_stream(decoder, stream, 0));
  CHECK(log.starts.size() == 1);
  return log.events;
}

}  // namespace

TEST_CASE("a restarted surface decoder is independent of the previous stream") {
  Bytes memory(Receiver::minimum_bytes(limits) + 100000);
  const Memory all{memory.data(), memory.size()};
  const Bytes streams[] = {slices_with_a_loss(), regions()};
  Events expected[2];
  for (int i = 0; i < 2; ++i) {
    SurfaceDecoder decoder;
    expected[i] = decoded(decoder, all, streams[i]);
    REQUIRE(expected[i].size() > 100);
  }
  struct Taker {
    SinkResult accept(const Event&) { return left-- > 0 ? SinkResult::accepted : SinkResult::busy; }
    int left;
  };
  SurfaceDecoder decoder;
  for (const Bytes& before : streams)
    for (int most = 0; most < 1000; most += most < 30 ? 1 : 5) {  // also within lost rows
      CAPTURE(most);
      for (int i = 0; i < 2; ++i) {
        Taker taker{most};
        reference::require_ok(decoder.start(all, make_sink(taker)));
        (void)decoder.push(before.data(), before.size());
        CHECK(decoded(decoder, all, streams[i]) == expected[i]);
        CHECK(decoder.report().holds_slices == (i == 0));
      }
    }
}

TEST_CASE("a surface decoder refuses a channel above 63, and continues as before") {
  const Bytes slices = encode_slices(volume());
  Bytes memory(Receiver::minimum_bytes(limits));
  SurfaceDecoder decoder;
  EventLog log, unused;
  reference::require_ok(decoder.start({memory.data(), memory.size()}, make_sink(log)));
  CHECK(decoder.start({}, make_sink(unused), StreamLabel::max_channel + 1) == Status::bad_label);
  reference::require_ok(push_stream(decoder, slices, 0));
  CHECK(log.starts.size() == 1);
  CHECK(unused.starts.empty());
}

TEST_CASE("a surface decoder that refused its memory can be restarted without memory") {
  const Bytes slices = encode_slices(volume());
  SurfaceDecoder decoder;
  EventLog log;
  reference::require_ok(decoder.start({}, make_sink(log)));
  CHECK(decoder.push(slices.data(), slices.size()).status == Status::too_little_memory);
  CHECK(decoder.finish() == Status::too_little_memory);
  CHECK(decoded(decoder, {}, regions()) == decode(regions()).events);
}

TEST_CASE("set_memory() succeeds only for a started surface decoder without enough memory") {
  const Bytes stream = encode_slices(volume());
  Bytes memory(Receiver::minimum_bytes(limits));
  const Memory all{memory.data(), memory.size()};
  SurfaceDecoder decoder;
  EventLog log;
  CHECK(decoder.set_memory(all) == Status::not_started);
  reference::require_ok(decoder.start({}, make_sink(log)));
  CHECK(decoder.set_memory(all) == Status::ok);
  const Decoded refused = decoder.push(stream.data(), stream.size());
  CHECK(refused.status == Status::too_little_memory);
  CHECK(refused.bytes == frames_of(stream).front().size());
  CHECK(decoder.set_memory({nullptr, memory.size()}) == Status::too_little_memory);
  CHECK(decoder.set_memory(all) == Status::ok);
  CHECK(log.starts.empty());
  const Decoded rest = decoder.push(stream.data() + refused.bytes, stream.size() - refused.bytes);
  CHECK(rest.status == Status::ok);
  CHECK(refused.bytes + rest.bytes == stream.size());
  CHECK(log.starts.size() == 1);
  CHECK(decoder.report().is_complete());
}

TEST_CASE("an unknown version is refused at the end of the header's frame") {
  const Bytes stream = with_version(3, regions());
  SurfaceDecoder decoder;
  EventLog log;
  reference::require_ok(decoder.start({}, make_sink(log)));
  const Decoded decoded = decoder.push(stream.data(), stream.size());
  CHECK(decoded.status == Status::wrong_version);
  CHECK(decoded.bytes == frames_of(stream)[0].size());
  CHECK(decoder.push(stream.data(), 1).bytes == 0);
}

TEST_CASE("the surface is closed at the end of the scan, for any trailer") {
  SlicePlan plan;
  plan.flush_every = 4;
  const std::vector<Bytes> whole = frames_of(encode_slices(volume(), plan));
  // Scans of two slices, and of one and a half. Every four rows have a packet.
  for (const uint32_t rows : {16U, 12U})
    for (const uint8_t is_abandoned : {uint8_t{0}, uint8_t{1}}) {
      INFO("rows ", rows, ", is_abandoned ", is_abandoned);
      std::vector<Bytes> frames(whole.begin(), whole.begin() + 1 + rows / 4);
      Packet trailer = packet_of(whole.back());
      REQUIRE(trailer.is(detail::wire::PacketKind::slices_trailer));
      trailer.number = static_cast<uint8_t>(frames.size());
      trailer.payload[4] = is_abandoned;  // after the number of slices
      detail::wire::put_long(trailer.payload.data() + 4 + 1, rows);
      frames.push_back(frame_of(trailer));
      BitVolume scanned({12, 8, 2});
      std::copy_n(volume().on.begin(), rows * 12, scanned.on.begin());
      Bytes memory(Receiver::minimum_bytes(limits) + 100000);
      SurfaceDecoder decoder;
      const Events events = decoded(decoder, {memory.data(), memory.size()}, joined(frames));
      CHECK(pieces_of(events) == pieces_of(events_of(scanned)));
      CHECK(events.back().event().is_abandoned == (is_abandoned != 0 || rows == 12));
    }
}

namespace {

struct Scan {
  uint32_t width;
  uint8_t surfaces;
};

// Rows, some of them missing. Each slice is a key slice.
std::vector<Bytes> frames_with_skips(const Scan& scan) {
  StreamHeader header{scan.width, 8, 0, {}, {100, 180}};
  header.channel = 3;
  header.surface_count = static_cast<uint8_t>(scan.surfaces);
  Line line;
  StartedSliceEncoder encoder(header, line.output(), 1);
  Chance chance(5);
  Bytes row(scan.width);
  for (uint32_t i = 0; i < 8 * 7; ++i) {
    for (uint8_t& sample : row) sample = chance.byte();
    const PushResult result = i % 5 == 3   ? encoder.skip_row(Substitute::previous_row)
                              : i % 7 == 4 ? encoder.skip_row(Substitute::off)
                                           : encoder.push(row.data(), scan.width);
    reference::require_ok(result.status);
    if (i % 8 == 7) reference::require_ok(encoder.flush());
  }
  reference::require_ok(encoder.finish());
  return frames_of(line.bytes);
}

// Extracts the rows of one channel that a slice decoder delivers.
Events swept(const Bytes& stream, const Scan& scan, uint8_t channel) {
  struct Sweep {
    SinkResult accept(const RowEvent& event) {
      if (event.kind == RowEvent::Kind::row && event.channel == channel)
        reference::require_ok(extractor.push_bits(event.bits).status);
      if (event.kind == RowEvent::Kind::skipped && event.channel == channel)
        skip(1, event.is_repeated ? Substitute::previous_row : Substitute::off);
      if (event.kind == RowEvent::Kind::lost) skip(event.count, Substitute::off);
      if (event.kind == RowEvent::Kind::finish) reference::require_ok(extractor.finish());
      return SinkResult::accepted;
    }
    void skip(uint64_t rows, Substitute substitute) {
      for (; rows > 0; --rows) reference::require_ok(extractor.skip_row(substitute).status);
    }
    uint8_t channel;
    Extractor32 extractor{};
  } sweep{channel};
  EventLog log;
  const Limits size{scan.width, 8};
  Bytes memory(Extractor32::minimum_bytes(size) + 100000),
      rows(SliceDecoder::minimum_bytes(size, 2));
  reference::require_ok(
      sweep.extractor.start(size, 1, {memory.data(), memory.size()}, make_sink(log)));
  SliceDecoder decoder;
  reference::require_ok(decoder.start({rows.data(), rows.size()}, make_row_sink(sweep)));
  reference::require_ok(push_stream(decoder, stream, 0));
  return log.events;
}

}  // namespace

TEST_CASE("skipped and lost rows are skipped in every surface, even if the sink is busy") {
  for (const Scan& scan : {Scan{1, 1}, Scan{11, 1}, Scan{11, 2}}) {
    std::vector<Bytes> frames = frames_with_skips(scan);
    frames.erase(frames.begin() + 3);
    const Bytes stream = joined(frames);
    Bytes memory(Receiver::minimum_bytes({scan.width, 8}, scan.surfaces) + 100000);
    for (uint8_t surface = 0; surface < scan.surfaces; ++surface)
      for (const bool refuses : {false, true}) {
        INFO("width ", scan.width, ", surface ", surface, ", refuses ", refuses);
        const auto channel = static_cast<uint8_t>(3 + surface);
        EventLog log(refuses ? EventLog::Refuses(reference::refuses_first) : nullptr);
        SurfaceDecoder decoder;
        reference::require_ok(
            decoder.start({memory.data(), memory.size()}, make_sink(log), channel));
        reference::require_ok(push_stream(decoder, stream, 0));
        CHECK(decoder.report().lost_rows == 8);
        CHECK(log.events == swept(stream, scan, channel));
      }
  }
}

TEST_CASE("a surface decoder returns the number of bytes consumed and reads no further bytes") {
  const Bytes slices = encode_slices(volume());
  Bytes memory(Receiver::minimum_bytes(limits) + 100000);
  for (const Bytes& stream : {slices, regions()})
    for (const size_t first : {size_t{0}, size_t{1}, size_t{30}, stream.size()}) {
      SurfaceDecoder decoder;
      EventLog log;
      const Decoded unasked = decoder.push(stream.data(), 1);
      CHECK(unasked.status == Status::not_started);
      CHECK(unasked.bytes == 0);
      CHECK(decoder.finish() == Status::not_started);
      reference::require_ok(decoder.start({memory.data(), memory.size()}, make_sink(log)));
      CHECK(decoder.push(stream.data(), first).bytes == first);
      CHECK(decoder.push(stream.data() + first, stream.size() - first).bytes ==
            stream.size() - first);
      CHECK(decoder.report().bytes == stream.size());
      CHECK(decoder.report().is_complete());
    }
}

TEST_CASE("the last events arrive before the end of the stream, even if the sink was busy") {
  const Bytes stream = encode_slices(volume());
  Bytes memory(Receiver::minimum_bytes(limits) + 100000);
  EventLog log(reference::refuses_first);
  SurfaceDecoder decoder;
  reference::require_ok(decoder.start({memory.data(), memory.size()}, make_sink(log)));
  CHECK(push_until_done(decoder, stream) == stream.size());
  CHECK(log.events.back().is(Event::Kind::finish));
}
