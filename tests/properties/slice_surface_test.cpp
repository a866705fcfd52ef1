// Streams of regions and of slices give the same surface.
#include <discmc/receiver.hpp>

#include "oracle/slice_stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using reference::Plan;

namespace {

// A scan with missing rows, for an extractor and for a slice encoder. The first row of a key slice
// has no row before it.
template <class Scanner>
void scan(Scanner& scanner, const BitVolume& volume, bool skips) {
  for (uint32_t row = 0; row < volume.height * volume.depth; ++row) {
    const bool is_skipped = skips && row % 7 == 3;
    const uint8_t* const samples = &volume.on[size_t{row} * volume.width];
    const bool is_off = row % 2 == 0 || row % volume.height == 0;
    const PushResult result =
        is_skipped ? scanner.skip_row(is_off ? Substitute::off : Substitute::previous_row)
                   : scanner.push(samples, volume.width);
    reference::require_ok(result.status);
  }
  reference::require_ok(scanner.finish());
}

Events swept(const BitVolume& volume, Border border, bool skips) {
  EventLog log;
  const Limits limits{volume.width, volume.height, border};
  Bytes memory(Extractor32::minimum_bytes(limits) + 200000);
  Extractor32 extractor;
  reference::require_ok(extractor.start(limits, 1, memory_of(memory), make_sink(log)));
  scan(extractor, volume, skips);
  return log.events;
}

Bytes encoded(const BitVolume& volume, Border border, bool skips, uint32_t interval) {
  Line line;
  StartedSliceEncoder encoder(header_of(volume, border), line.output(), interval);
  scan(encoder, volume, skips);
  return line.bytes;
}

std::vector<BitVolume> volumes() {
  return {reference::ball({20, 20, 20}, {19, 19, 19}, 70), reference::random({13, 11, 9}, 128, 1),
          reference::random({33, 7, 5}, 30, 2), BitVolume({4, 3, 2}), BitVolume({1, 1, 1})};
}

}  // namespace

TEST_CASE("a stream of slices yields the events of an extractor with the same rows") {
  for (const BitVolume& volume : volumes())
    for (const Border border : {Border::closed, Border::open})
      for (const bool skips : {false, true})
        for (const uint32_t interval : {0U, 1U, 3U}) {
          const Bytes stream = encoded(volume, border, skips, interval);
          const Limits limits{volume.width, volume.height, border};
          const Events events = swept(volume, border, skips);
          for (const size_t chunk : {0U, 1U, 100U})
            for (const bool refuses : {false, true}) {
              const Received surface = decode_surface(stream, limits, chunk, refuses);
              CHECK(surface.status == Status::ok);
              CHECK(surface.report.is_complete());
              CHECK(surface.events == events);
            }
        }
}

TEST_CASE("a surface decoder decodes a stream of regions without any memory") {
  const BitVolume volume = volumes()[0];
  const Events events = swept(volume, Border::closed, false);
  const Bytes stream = encode(events, header_of(volume));
  EventLog log;
  SurfaceDecoder decoder;
  reference::require_ok(decoder.start({}, make_sink(log)));
  CHECK(decoder.push(stream.data(), stream.size()).bytes == stream.size());
  reference::require_ok(decoder.finish());
  CHECK(decoder.report().is_complete());
  CHECK(decoder.header().width == volume.width);
  CHECK(log.events == decode(stream).events);
}

TEST_CASE("the surface of a stream with lost packets is closed, and lost rows are skipped") {
  const BitVolume volume = reference::ball({40, 40, 40}, {39, 39, 39}, 300);
  const std::vector<Bytes> frames = frames_of(encoded(volume, Border::closed, false, 4));
  REQUIRE(frames.size() > 10);
  for (size_t lost = 1; lost + 1 < frames.size(); ++lost) {
    CAPTURE(lost);
    std::vector<Bytes> kept = frames;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(lost));
    const Received surface = decode_surface(joined(kept), {40, 40});
    CHECK(surface.status == Status::ok);
    CHECK_FALSE(surface.report.is_complete());
    CHECK(surface.report.lost_rows > 0);
    CHECK(surface.report.lost_rows <= 4 * 40);
    // The surface of the volume without those rows.
    BitVolume rest = volume;
    uint64_t skipped = 0;
    for (const RecordedEvent& recorded : surface.events) {
      if (!recorded.is(Event::Kind::skipped)) continue;
      const Event event = recorded.event();
      ++skipped;
      for (uint32_t x = 0; x < 40; ++x) rest.on[rest.index(x, event.row, event.slice)] = 0;
    }
    CHECK(skipped == surface.report.lost_rows);
    CHECK(pieces_of(surface.events) == pieces_of(swept(rest, Border::closed, false)));
  }
}

TEST_CASE("memory that is too small for a stream of slices is refused") {
  const BitVolume volume = volumes()[0];
  const Bytes stream = encoded(volume, Border::closed, false, 0);
  const Limits limits{volume.width, volume.height};
  for (const uint64_t bytes :
       {uint64_t{0}, uint64_t{100}, SliceDecoder::minimum_bytes(limits),
        Receiver::minimum_bytes(limits) - 1, Receiver::minimum_bytes(limits)}) {
    CAPTURE(bytes);
    Bytes memory(bytes);
    EventLog log;
    SurfaceDecoder decoder;
    reference::require_ok(decoder.start({memory.data(), bytes}, make_sink(log)));
    const Status status = decoder.push(stream.data(), stream.size()).status;
    const bool is_enough = bytes == Receiver::minimum_bytes(limits);
    CHECK(status == (is_enough ? Status::ok : Status::too_little_memory));
    CHECK(decoder.push(stream.data(), 0).status == status);
    CHECK(log.events.empty() == !is_enough);
  }
  SurfaceDecoder decoder;
  CHECK(decoder.start({}, {}) == Status::bad_sink);
  CHECK(decoder.push(stream.data(), 5).status == Status::not_started);
  CHECK(decoder.finish() == Status::not_started);
}

TEST_CASE("a call skips at most max_skipped_rows rows, for any row number in the stream") {
  constexpr uint32_t most = SurfaceDecoder::max_skipped_rows;
  constexpr uint32_t rows = 2 * most + 100;
  const Bytes stream = lost_slices({3, 2, rows / 2});
  EventLog log;
  const auto skipped = [&log] {
    return std::count_if(log.events.begin(), log.events.end(), [](const RecordedEvent& recorded) {
      return recorded.is(Event::Kind::skipped);
    });
  };
  Bytes memory(Receiver::minimum_bytes({3, 2}));
  SurfaceDecoder decoder;
  reference::require_ok(decoder.start(memory_of(memory), make_sink(log)));
  const Decoded decoded = decoder.push(stream.data(), stream.size());
  CHECK(decoded.status == Status::suspended);
  CHECK(skipped() == most);
  const uint8_t* const rest = stream.data() + decoded.bytes;
  const size_t left = stream.size() - decoded.bytes;
  CHECK(decoder.push(rest, left).status == Status::suspended);
  CHECK(skipped() == 2 * most);
  CHECK(decoder.push(rest, left).status == Status::ok);
  CHECK(skipped() == rows);
  CHECK(decoder.report().lost_rows == rows);
  reference::require_ok(decoder.finish());
}

TEST_CASE("a stream truncated within its first packet delivers no start event") {
  const BitVolume volume = volumes()[0];
  const Bytes stream = encoded(volume, Border::closed, false, 0);
  EventLog log;
  Bytes memory(Receiver::minimum_bytes({20, 20}) + 100000);
  SurfaceDecoder decoder;
  reference::require_ok(decoder.start(memory_of(memory), make_sink(log)));
  reference::require_ok(decoder.push(stream.data(), 10).status);
  reference::require_ok(decoder.finish());
  const size_t header = frames_of(stream)[0].size();
  reference::require_ok(decoder.push(stream.data() + 10, header - 10).status);
  CHECK_FALSE(decoder.report().has_header);
  CHECK(decoder.report().damaged_packets == 2);
  CHECK(log.starts.empty());
  // For example one of a stream of another name.
  std::vector<Bytes> other = frames_of(stream);
  for (Bytes& frame : other) {
    Packet packet = packet_of(frame);
    packet.channel = 9;
    frame = frame_of(packet);
  }
  reference::require_ok(push_stream(decoder, joined(other), 0));
  REQUIRE(log.starts.size() == 1);
  CHECK(log.starts[0].channel == 9);
  CHECK(log.events == swept(volume, Border::closed, false));
}

TEST_CASE("set_memory() replaces memory that was too small") {
  const BitVolume volume = volumes()[0];
  const Bytes stream = encoded(volume, Border::closed, false, 0);
  const Limits limits{volume.width, volume.height};
  const size_t head = frames_of(stream)[0].size();
  for (const uint64_t bytes :
       {SliceDecoder::minimum_bytes(limits), Receiver::minimum_bytes(limits) - 1}) {
    CAPTURE(bytes);
    EventLog log;
    SurfaceDecoder decoder;
    Bytes little(bytes), enough(Receiver::minimum_bytes(limits) + 200000);
    reference::require_ok(decoder.start(memory_of(little), make_sink(log)));
    CHECK(decoder.push(stream.data(), head).status == Status::too_little_memory);
    const size_t minimum = Receiver::minimum_bytes(limits);
    CHECK(decoder.set_memory({enough.data(), minimum - 1}) == Status::too_little_memory);
    reference::require_ok(decoder.set_memory(memory_of(enough)));
    const Bytes unlike(bytes, 0xA5);
    unpoison(little.data(), little.size());  // red zones
    little = unlike;                         // the caller's memory again
    reference::require_ok(decoder.push(stream.data() + head, stream.size() - head).status);
    CHECK(decoder.report().is_complete());
    CHECK(log.events == swept(volume, Border::closed, false));
    CHECK(little == unlike);
  }
}

TEST_CASE("a sink that refuses events loses no event of a truncated stream of slices") {
  const BitVolume volume = reference::random({20, 10, 6}, 90, 2);
  const Limits limits{volume.width, volume.height};
  std::vector<Bytes> frames = frames_of(encoded(volume, Border::closed, false, 1));
  for (; frames.size() > 1; frames.pop_back()) {
    CAPTURE(frames.size());
    const Received surface = decode_surface(joined(frames), limits);
    CHECK(surface.events == decode_surface(joined(frames), limits, 0, true).events);
  }
}
