// Packets of records from an encoder or a decoder, passed to another encoder.
#include <discmc/receiver.hpp>
#include <discmc/stream/records_packet.hpp>

#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using Kind = Event::Kind;
using detail::wire::PacketKind;

namespace {

// Regions of 12 runs, a few per packet.
Events small_regions(uint32_t count) {
  Script script;
  Chance chance(1);
  for (uint32_t i = 0; i < count; ++i) add_ragged_region(script, chance, 12, 1000);
  return script.finish().events;
}

struct KeptPacket {
  Bytes payload;
  uint32_t pieces;
  bool is_whole;
};
using KeptPackets = std::vector<KeptPacket>;

// Encodes four regions per packet, with room for a count.
Bytes encode_shortly(const Events& events) {
  Line line;
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  int regions = 0;
  for (const RecordedEvent& recorded : events) {
    REQUIRE(encoder.accept(recorded.event()) == SinkResult::accepted);
    if (recorded.is(Kind::region_end) && ++regions % 4 == 0) REQUIRE(encoder.flush() == Status::ok);
  }
  return line.bytes;
}

// Returns the packets of records of an encoder. Packets for whole regions have room for a count.
KeptPackets packets_of(const Events& events, bool are_whole = true) {
  std::vector<Packet> all;
  for (const Bytes& frame : frames_of(are_whole ? encode_shortly(events) : encode(events)))
    all.push_back(packet_of(frame));
  KeptPackets packets;
  for (size_t i = 0; i < all.size(); ++i) {
    const auto pieces = static_cast<uint16_t>(all[(i + 1) % all.size()].pieces - all[i].pieces);
    if (!all[i].is(PacketKind::records)) continue;
    packets.push_back({all[i].payload, pieces, are_whole});
  }
  return packets;
}

Status append(Encoder& encoder, const KeptPacket& packet) {
  return encoder.append(
      {packet.payload.data(), packet.payload.size(), packet.pieces, packet.is_whole});
}

// A stream with foreign packets, after some events of its own.
Bytes appended(const KeptPackets& packets, const Event& finish, const Events& before = {}) {
  Line line;
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  encode_all(encoder, before);
  for (const KeptPacket& packet : packets) CHECK(append(encoder, packet) == Status::ok);
  CHECK(encoder.accept(finish) == SinkResult::accepted);
  return line.bytes;
}

// The packets that a decoder passes on, and the rest.
struct Passed {
  KeptPackets packets;
  std::vector<size_t> events_before;  // each packet
  Events events;
  StreamReport report;
};

struct Taker {
  EventLog log;
  Passed passed;
  void accept(const RecordsPacket& packet) {
    passed.packets.push_back(
        {Bytes(packet.payload, packet.payload + packet.bytes), packet.pieces, packet.is_whole});
    passed.events_before.push_back(log.events.size());
  }
};

Status start(Decoder& decoder, const Sink& sink) {
  return decoder.start(sink);
}
template <class AnyReceiver>
Status start(AnyReceiver& receiver, const Sink& sink) {
  return receiver.start({}, sink);
}

// at_end: the expected status at the end of the stream.
template <class AnyDecoder = Decoder>
Passed passed(const Bytes& stream, Status at_end = Status::ok) {
  Taker taker;
  AnyDecoder decoder;
  reference::require_ok(start(decoder, make_sink(taker.log)));
  decoder.set_packet_passthrough({&taker, [](void* context, const RecordsPacket& packet) {
                                    static_cast<Taker*>(context)->accept(packet);
                                  }});
  CHECK(decoder.push(stream.data(), stream.size()).status == at_end);
  reference::require_ok(decoder.finish());
  taker.passed.events = taker.log.events;
  taker.passed.report = decoder.report();
  return taker.passed;
}

bool are_same(const KeptPackets& a, const KeptPackets& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const KeptPacket& one, const KeptPacket& other) {
                      return one.payload == other.payload && one.pieces == other.pieces &&
                             one.is_whole == other.is_whole;
                    });
}

Events regions_among(const Events& events) {
  Events regions;
  for (const Events& piece : pieces_of(events))
    regions.insert(regions.end(), piece.begin(), piece.end());
  return regions;
}

}  // namespace

TEST_CASE("packets written by another encoder are sent unchanged, with new numbers and counts") {
  for (const Events& events : {monstrous_events(), small_regions(1000)})
    CHECK(appended(packets_of(events, false), events.back().event()) == encode(events));
}

TEST_CASE("packets of whole regions are decoded unchanged after other records") {
  const Events before = Script().region(up).square({1, 0, 0}, 3).region_end().events;
  const Events regions = small_regions(1000);
  Events all = before;
  all.insert(all.end(), regions.begin(), regions.end());
  const Received received = decode(appended(packets_of(regions), regions.back().event(), before));
  CHECK(regions_among(received.events) == regions_among(all));
  CHECK(received.report.lost_pieces == 0);
  CHECK(received.report.lost_packets == 0);
  CHECK_FALSE(received.report.is_mixed);
}

TEST_CASE("a decoder passes packets of whole regions on unchanged and decodes all other packets") {
  const Events fragments = Script().fragment(up, {1, 0, 0}, 6).run(0, 5).fragment_end().events;
  const Events regions = small_regions(1000);
  const KeptPackets packets = packets_of(regions);
  const Passed one = passed(appended(packets, regions.back().event(), fragments));
  CHECK(are_same(one.packets, packets));
  CHECK(regions_among(one.events) == fragments);
  CHECK(one.events.back().is(Kind::finish));
  CHECK(one.report.regions == 1000);
  CHECK(one.report.lost_pieces == 0);
  const Passed of_surface =
      passed<Receiver>(appended(packets, regions.back().event(), fragments), Status::finished);
  CHECK(are_same(of_surface.packets, packets));
  CHECK(of_surface.events == one.events);
  const Passed none = passed(appended(packets_of(regions, false), regions.back().event()));
  CHECK(none.packets.empty());
  CHECK(regions_among(none.events) == regions_among(regions));
}

TEST_CASE("a lost packet among packets that are passed on is counted") {
  const Events regions = small_regions(1000);
  const KeptPackets packets = packets_of(regions);
  std::vector<Bytes> frames = frames_of(appended(packets, regions.back().event()));
  frames.erase(frames.begin() + 5);
  const Passed rest = passed(joined(frames));
  CHECK(rest.packets.size() == packets.size() - 1);
  CHECK(rest.report.lost_packets == 1);
  CHECK(rest.report.lost_pieces == packets[4].pieces);
  CHECK(rest.report.regions == 1000 - packets[4].pieces);
}

TEST_CASE("packets of whole regions before a header are decoded") {
  const Events regions = small_regions(1000);
  std::vector<Bytes> frames = frames_of(appended(packets_of(regions), regions.back().event()));
  frames.erase(frames.begin());
  const Passed late = passed(joined(frames));
  CHECK_FALSE(late.packets.empty());  // the packets after the repeated header
  CHECK(pieces_of(late.events).size() + late.packets.size() > 64);
  CHECK(late.report.regions == 1000);
}

TEST_CASE("a region interrupted by a passed-on packet is lost") {
  Script begun;
  Chance chance(3);
  add_ragged_region(begun, chance, 500, 1000);
  std::vector<Bytes> frames = frames_of(appended({}, begun.events.back().event(), begun.events));
  const Events regions = small_regions(4);
  const std::vector<Bytes> others =
      frames_of(appended(packets_of(regions), regions.back().event()));
  Packet packet = packet_of(others[1]);
  packet.number = 2;
  frames.resize(2);
  frames.push_back(frame_of(packet));
  const Passed cut = passed(joined(frames));
  REQUIRE(cut.packets.size() == 1);
  CHECK(cut.events.at(cut.events_before[0] - 1).is(Kind::lost));
}

TEST_CASE("a packet of whole regions without the number of regions is damaged") {
  const Events regions = small_regions(4);
  std::vector<Bytes> frames = frames_of(appended(packets_of(regions), regions.back().event()));
  Packet packet = packet_of(frames[1]);
  packet.payload.resize(1);
  frames[1] = frame_of(packet);
  const Passed damaged = passed(joined(frames));
  CHECK(damaged.packets.empty());
  CHECK(damaged.report.damaged_packets == 1);
}

TEST_CASE("an encoder refuses an invalid packet of another encoder") {
  const KeptPacket longest{Bytes(detail::wire::max_whole_regions), 0xFFFF, true};
  KeptPacket too_long = longest, too_many = longest;
  too_long.payload.push_back(0);
  const KeptPacket longest_part{Bytes(detail::wire::max_payload), 1, false};
  KeptPacket too_long_part = longest_part;
  too_long_part.payload.push_back(0);
  ++too_many.pieces;
  Line line;
  Encoder encoder;
  CHECK(append(encoder, longest) == Status::not_started);
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  CHECK(append(encoder, too_long) == Status::bad_record);
  CHECK(append(encoder, too_long_part) == Status::bad_record);
  const size_t bytes_before = line.bytes.size();
  CHECK(append(encoder, longest_part) == Status::ok);
  CHECK(line.bytes.size() > bytes_before + detail::wire::max_payload);  // at once
  CHECK(append(encoder, too_many) == Status::bad_record);
  const Events events = small_regions(1);
  REQUIRE(encoder.accept(events.front().event()) == SinkResult::accepted);
  CHECK(append(encoder, longest) == Status::suspended);
  for (size_t i = 1; i + 1 < events.size(); ++i)
    REQUIRE(encoder.accept(events[i].event()) == SinkResult::accepted);
  CHECK(append(encoder, longest) == Status::ok);
  REQUIRE(encoder.accept(events.back().event()) == SinkResult::accepted);
  CHECK(append(encoder, longest) == Status::finished);
}
