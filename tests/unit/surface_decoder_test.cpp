// The surface decoder alone: started again, given memory, and streams that end where none should.
#include <doctest/doctest.h>
#include <discmc/surface_decoder.hpp>

#include "oracle/slice_stream.hpp"
#include "oracle/stream_samples.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;

namespace {

constexpr Limits limits{20, 12};

const BitVolume& volume() {
  static const BitVolume rough = reference::random({20, 12, 9}, 30, 5);
  return rough;
}

// With rows that are lost on the way.
Bytes slices_with_a_loss() {
  std::vector<Bytes> frames = frames_of(encode_slices(volume(), {{2}}));
  REQUIRE(frames.size() > 5);
  frames.erase(frames.begin() + 2);
  return joined(frames);
}

Bytes regions() {
  return encode(events_of(volume()), header_of(volume()));
}

Events decoded(SurfaceDecoder& decoder, const Memory& memory, const Bytes& stream) {
  EventLog log;
  reference::require_ok(decoder.start(memory, sink_to(log)));
  reference::require_ok(push_stream(decoder, stream, 0));
  CHECK(log.starts.size() == 1);
  return log.events;
}

}  // namespace

TEST_CASE("a surface decoder that is started again forgets everything") {
  Bytes memory(minimum_surface_bytes(limits) + 100000);
  const Memory all{memory.data(), memory.size()};
  const Bytes streams[] = {slices_with_a_loss(), regions()};
  Events expected[2];
  for (int i = 0; i < 2; ++i) {
    SurfaceDecoder decoder;
    expected[i] = decoded(decoder, all, streams[i]);
    REQUIRE(expected[i].size() > 100);
  }
  struct Taker {
    Answer take(const Event&) { return left-- > 0 ? Answer::taken : Answer::not_now; }
    int left;
  };
  SurfaceDecoder decoder;
  for (const Bytes& before : streams)
    for (int most = 0; most < 3000; most += 1 + most / 4) {
      CAPTURE(most);
      for (int i = 0; i < 2; ++i) {
        Taker taker{most};
        reference::require_ok(decoder.start(all, sink_to(taker)));
        (void)decoder.push(before.data(), before.size());
        CHECK(decoded(decoder, all, streams[i]) == expected[i]);
        CHECK(decoder.report().holds_slices == (i == 0));
      }
    }
}

TEST_CASE("a surface decoder that was refused memory is started again without it") {
  const Bytes slices = encode_slices(volume());
  SurfaceDecoder decoder;
  EventLog log;
  reference::require_ok(decoder.start({}, sink_to(log)));
  CHECK(decoder.push(slices.data(), slices.size()).status == Status::too_little_memory);
  CHECK(decoder.finish() == Status::too_little_memory);
  CHECK(decoded(decoder, {}, regions()) == decode(regions()).events);
}

TEST_CASE("memory is given to a surface decoder that has too little, and to no other") {
  const Bytes stream = encode_slices(volume());
  Bytes memory(minimum_surface_bytes(limits));
  const Memory all{memory.data(), memory.size()};
  SurfaceDecoder decoder;
  EventLog log;
  CHECK(decoder.give_memory(all) == Status::not_started);
  reference::require_ok(decoder.start({}, sink_to(log)));
  CHECK(decoder.give_memory(all) == Status::ok);
  const Decoded refused = decoder.push(stream.data(), stream.size());
  CHECK(refused.status == Status::too_little_memory);
  CHECK(refused.bytes == frames_of(stream).front().size());
  CHECK(decoder.give_memory({nullptr, memory.size()}) == Status::too_little_memory);
  CHECK(decoder.give_memory(all) == Status::ok);
  CHECK(log.starts.empty());
  const Decoded rest = decoder.push(stream.data() + refused.bytes, stream.size() - refused.bytes);
  CHECK(rest.status == Status::ok);
  CHECK(refused.bytes + rest.bytes == stream.size());
  CHECK(log.starts.size() == 1);
  CHECK(decoder.report().is_complete());
}

TEST_CASE("a version that is not known is refused at the byte that tells of it") {
  std::vector<Bytes> frames = frames_of(regions());
  Packet header = packet_of(frames[0]);
  ++header.payload[3];
  frames[0] = frame_of(header);
  const Bytes stream = joined(frames);
  SurfaceDecoder decoder;
  EventLog log;
  reference::require_ok(decoder.start({}, sink_to(log)));
  const Decoded decoded = decoder.push(stream.data(), stream.size());
  CHECK(decoded.status == Status::wrong_version);
  CHECK(decoded.bytes == frames[0].size());
  CHECK(decoder.push(stream.data(), 1).bytes == 0);
}

TEST_CASE("where a scan ends within a slice its surface is closed, whatever the trailer says") {
  SlicePlan plan;
  plan.flush_every = 4;
  std::vector<Bytes> frames = frames_of(encode_slices(volume(), plan));
  Packet trailer = packet_of(frames.back());
  REQUIRE(trailer.is(wire::PacketKind::slices_trailer));
  // A scan of 16 rows, of which every four have a packet; behind the slices and the flag.
  wire::ByteWriter(trailer.payload.data() + 4 + 1).put_long(16);
  trailer.number = 1 + 4;
  frames.resize(1 + 4);
  frames.push_back(frame_of(trailer));
  BitVolume scanned({20, 12, 2});
  std::copy_n(volume().on.begin(), 16 * 20, scanned.on.begin());
  Bytes memory(minimum_surface_bytes(limits) + 100000);
  SurfaceDecoder decoder;
  const Events events = decoded(decoder, {memory.data(), memory.size()}, joined(frames));
  CHECK(pieces_of(events) == pieces_of(events_of(scanned)));
  CHECK(events.back().event().abandoned);
}
