// The encoder alone: its packets, their heads, slow outputs, flush(), and records at the limits.
#include "oracle/checkpointed_device.hpp"
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using Kind = Event::Kind;
using detail::wire::PacketKind;

namespace {

std::vector<Packet> packets_of(const Bytes& stream) {
  std::vector<Packet> packets;
  for (const Bytes& frame : frames_of(stream)) packets.push_back(packet_of(frame));
  return packets;
}

// Many regions, a few per packet.
Events many_regions(uint32_t count, uint32_t runs = 60) {
  Script script;
  Chance chance(1);
  for (uint32_t i = 0; i < count; ++i) add_ragged_region(script, chance, runs, 1000);
  return script.finish().events;
}

}  // namespace

TEST_CASE("an encoder refuses to start with an invalid header or output") {
  Line line;
  Encoder encoder;
  StreamHeader header = any_header();
  CHECK(begin_stream(encoder, header, ByteOutput{}) == Status::bad_sink);
  header.width = 0;
  CHECK(begin_stream(encoder, header, line.output()) == Status::bad_sink);
  header.width = Limits::max_extent + 1;
  CHECK(begin_stream(encoder, header, line.output()) == Status::bad_sink);
  header = any_header();
  header.height = 0;
  CHECK(begin_stream(encoder, header, line.output()) == Status::bad_sink);
  header = any_header();
  header.channel = 64;
  CHECK(begin_stream(encoder, header, line.output()) == Status::bad_label);
  CHECK(line.bytes.empty());
  CHECK(encoder.start({}, {}) == Status::bad_sink);
  CHECK(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  header.channel = 63;
  CHECK(begin_stream(encoder, header, line.output()) == Status::ok);
}

TEST_CASE(
    "headers and labels begin as zeros, and label() copies depth, scan and channel of the header") {
  StreamHeader without_surfaces = any_header();
  without_surfaces.surface_count = 0;
  CHECK_FALSE(without_surfaces.is_valid());
  const StreamHeader unsaid;
  CHECK(unsaid.width == 0);
  CHECK(unsaid.height == 0);
  CHECK(unsaid.depth == 0);
  CHECK(unsaid.thresholds[0] == 0);
  for (uint32_t surface = 1; surface < StreamHeader::max_surfaces; ++surface)
    CHECK(unsaid.thresholds[surface] == 0);
  const StreamLabel unnamed;
  CHECK(unnamed.depth == 0);
  CHECK(unnamed.scan == 0);
  CHECK(unnamed.channel == 0);
  for (const int32_t spacing : unnamed.spacing_nm) CHECK(spacing == 0);
  StreamHeader header;
  header.depth = 9;
  header.scan = 8;
  header.channel = 7;
  for (int axis = 0; axis < 3; ++axis) header.spacing_nm[axis] = axis + 4;
  const StreamLabel label = header.label();
  CHECK(label.depth == 9);
  CHECK(label.scan == 8);
  CHECK(label.channel == 7);
  for (int axis = 0; axis < 3; ++axis) CHECK(label.spacing_nm[axis] == axis + 4);
}

TEST_CASE(
    "an application record is accepted between pieces, even after a lost or abandoned piece") {
  Event region{}, lost{};
  region.kind = Event::Kind::region;
  lost.kind = Event::Kind::lost;
  Line line;
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  REQUIRE(encoder.accept(region) == SinkResult::accepted);
  CHECK(encoder.write_record({}) == Status::suspended);
  REQUIRE(encoder.accept(lost) == SinkResult::accepted);
  CHECK(encoder.write_record({}) == Status::ok);
  REQUIRE(encoder.accept(region) == SinkResult::accepted);
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  CHECK(encoder.write_record({}) == Status::ok);
}

TEST_CASE("packets are numbered, limited in size, and contain the number of previous pieces") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const std::vector<Bytes> frames = frames_of(encode(sample.events, sample.header));
    const std::vector<Events> brought = events_by_frame(frames);
    size_t pieces = 0;
    for (size_t i = 0; i < frames.size(); ++i) {
      CHECK(frames[i].size() <= detail::wire::max_frame);
      const Packet packet = packet_of(frames[i]);
      CHECK(packet.number == static_cast<uint8_t>(i));
      CHECK(packet.pieces == static_cast<uint16_t>(pieces));
      for (const RecordedEvent& recorded : brought[i])
        pieces += recorded.is(Kind::region_end) || recorded.is(Kind::fragment_end);
    }
    CHECK(packet_of(frames.front()).is(PacketKind::header));
    CHECK(packet_of(frames.back()).is(PacketKind::trailer));
  }
}

TEST_CASE("packets of a long stream are nearly full") {
  const std::vector<Packet> packets = packets_of(encode(many_regions(300, 12)));
  size_t bytes = 0, records = 0;
  for (const Packet& packet : packets)
    if (packet.is(PacketKind::records)) {
      bytes += packet.payload.size();
      ++records;
    }
  CHECK(bytes > (records - 1) * (detail::wire::max_payload - 60));
}

TEST_CASE("the header is repeated after every 64 packets of records with updated counts") {
  const std::vector<Packet> packets = packets_of(encode(many_regions(900)));
  REQUIRE(packets.size() > 200);
  for (size_t i = 0; i + 1 < packets.size(); ++i) {
    CAPTURE(i);
    REQUIRE(packets[i].is(PacketKind::header) == (i % (detail::wire::header_interval + 1) == 0));
    if (!packets[i].is(PacketKind::header)) continue;
    CHECK(packets[i].payload.size() == detail::wire::header_payload);
    detail::wire::ByteReader counts(packets[i].payload.data() + detail::wire::header_payload - 12,
                                    12);
    CHECK(counts.get(4) == i);
    CHECK(counts.get(8) == packets[i].pieces);
  }
}

TEST_CASE("flush() sends pending records once") {
  const Events events = many_regions(40);
  Line line;
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  CHECK(encoder.flush() == Status::ok);
  const size_t header = line.bytes.size();
  CHECK(header ==
        detail::wire::header_payload + detail::wire::packet_head + detail::wire::packet_tail + 2);
  CHECK(encoder.flush() == Status::ok);
  CHECK(line.bytes.size() == header);
  uint64_t regions = 0;
  for (const RecordedEvent& recorded : events) {
    REQUIRE(encoder.accept(recorded.event()) == SinkResult::accepted);
    regions += recorded.is(Kind::region_end);
    CHECK(encoder.flush() == Status::ok);
    CHECK(decode(line.bytes).report.regions == regions);
  }
  CHECK(decode(line.bytes).events == events);
  CHECK(decode(line.bytes).report.is_complete());
}

TEST_CASE("flush() before start() has no effect") {
  Encoder encoder;
  CHECK(encoder.flush() == Status::ok);
}

TEST_CASE("a flush on a slow line continues at the byte that the line refused") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    Bytes fast;
    for (const size_t bytes_at_once : {0U, 1U, 5U}) {
      Line line(bytes_at_once);
      Encoder encoder;
      REQUIRE(begin_stream(encoder, sample.header, line.output()) == Status::ok);
      size_t encoded = 0;
      for (const RecordedEvent& one : sample.events) {
        encode_all(encoder, {one});
        if (++encoded % 37 == 0)
          while (encoder.flush() == Status::suspended) continue;
      }
      CHECK(decode(line.bytes).events == sample.events);
      if (bytes_at_once == 0) fast = line.bytes;
      CHECK(line.bytes == fast);
    }
  }
}

TEST_CASE("the trailer is written once, even if the finish event is repeated") {
  for (const size_t bytes_at_once : {0U, 1U}) {
    Line line(bytes_at_once);
    Encoder encoder;
    REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
    const Events events = many_regions(3);
    encode_all(encoder, events);
    encode_all(encoder, {events.back()});
    while (encoder.flush() == Status::suspended) continue;
    CHECK(line.bytes == encode(events));
  }
}

TEST_CASE("the trailer's abandoned flag is 1 after an abandoned scan and otherwise 0") {
  for (const bool abandoned : {false, true}) {
    const RecordedEvent finish = Script().finish().events.front();
    Event event = finish.event();
    event.is_abandoned = abandoned;
    const std::vector<Packet> packets = packets_of(encode({RecordedEvent(event)}));
    CHECK(packets.back().payload[4] == (abandoned ? 1 : 0));
  }
}

TEST_CASE("a restarted encoder begins a new stream") {
  const Events events = many_regions(100);
  for (size_t event_count = 0; event_count <= events.size(); event_count += 1 + event_count / 3) {
    Line line(event_count % 2);
    Encoder encoder;
    REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
    encode_all(encoder,
               Events(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(event_count)));
    Line again;
    REQUIRE(begin_stream(encoder, any_header(), again.output()) == Status::ok);
    encode_all(encoder, events);
    CHECK(again.bytes == encode(events));
    CHECK(encoder.bytes() == again.bytes.size());
  }
}

TEST_CASE("a further scan begins after the line has accepted all of the previous scan") {
  const Events events = Script().layer(0).finish().events;
  Line line(1);
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  StreamHeader header = any_header();
  uint32_t refusals = 0;
  while (encoder.accept(start_of(header)) != SinkResult::accepted) ++refusals;
  CHECK(refusals > 10);
  CHECK(line.bytes == encode({}));
  encode_all(encoder, events);
  header.scan = 1;
  CHECK(joined({encode({}), encode(events, header)}) == line.bytes);
}

TEST_CASE("the spacing of the label is sent if the scan has no spacing") {
  const auto sent_spacing = [](const StreamHeader& scan) {
    Line line;
    Encoder encoder;
    REQUIRE(encoder.start({0, {7, 8, 9}}, line.output()) == Status::ok);
    REQUIRE(encoder.accept(start_of(scan)) == SinkResult::accepted);
    const StreamHeader header = decode(line.bytes).header;
    return std::vector<int32_t>(header.spacing_nm, header.spacing_nm + 3);
  };
  StreamHeader scan = any_header();
  for (int axis = -1; axis < 3; ++axis) {
    CAPTURE(axis);
    for (int32_t& spacing : scan.spacing_nm) spacing = 0;
    if (axis >= 0) scan.spacing_nm[axis] = 5;
    const std::vector<int32_t> own(scan.spacing_nm, scan.spacing_nm + 3);
    CHECK(sent_spacing(scan) == (axis < 0 ? std::vector<int32_t>{7, 8, 9} : own));
  }
}

TEST_CASE("an encoder restarted amid a region in parts encodes the next region completely") {
  LimitedLine narrow{frames_of(encode({})).front().size()};  // for the header
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), narrow.output()) == Status::ok);
  size_t accepted = 0;
  const Events long_region = many_regions(1, 500);
  while (encoder.accept(long_region[accepted].event()) == SinkResult::accepted) ++accepted;
  REQUIRE(long_region[accepted].is(Event::Kind::run));
  Line line;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  const Events events = Script().region(up).square({1, 0, 0}, 2).region_end().finish().events;
  encode_all(encoder, events);
  CHECK(line.bytes == encode(events));
}

TEST_CASE("records of every length fit in packets at every fill level") {
  for (uint32_t lead = 0; lead < 90; ++lead)
    for (const bool is_fragment : {false, true}) {
      Script script;
      Chance chance(lead);
      for (uint32_t i = 0; i < 6; ++i) {
        add_ragged_region(script, chance, 2 + lead, 2);
        if (is_fragment) add_ragged_fragment(script, chance, 1 + lead, 99999);
        script.skipped(UINT32_MAX - 1, chance.below(9), false).layer(i);
      }
      const Events events = script.finish().events;
      const Bytes stream = encode(events);
      for (const Bytes& frame : frames_of(stream)) REQUIRE(frame.size() <= detail::wire::max_frame);
      CHECK(decode(stream).events == events);
    }
}

TEST_CASE(
    "a fragment near its end is coded backwards in as few bytes as a fragment near its start") {
  const auto bytes = [](bool is_end_near) {
    Script script;
    const Vertex near{1, 0, 0}, far{1, 0, 60000};
    script.region(up).square(near, 2).region_end();
    const Incidence side = incidence_of({0, 1, 0});
    const Direction rising = 4;  // (0, 0, 2)
    const Direction along = is_end_near ? opposite_direction(side, rising) : rising;
    script.fragment(side, is_end_near ? far : near, along).run(along, 30000).fragment_end();
    return encode(script.finish().events).size();
  };
  CHECK(bytes(true) <= bytes(false) + 2);
}

TEST_CASE(
    "rings that retrace their links, wind twice or begin within a side are decoded unchanged") {
  Script script;
  script.region(up).ring({1, 0, 0}).run(0, 5).run(4, 5).region_end();
  script.region(up).ring({1, 0, 0}).run(0, 1).run(3, 3).run(6, 2).run(1, 1).region_end();
  script.region(up).ring({1, 0, 0}).run(0, 1).run(2, 2).run(5, 4).run(0, 1).region_end();
  script.region(up).ring({1, 0, 0}).run(0, 1).run(4, 2).run(0, 3).run(4, 2).region_end();
  const Events events = script.finish().events;
  CHECK(decode(encode(events)).events == events);
}

TEST_CASE("an invalid region or fragment damages only its own packet") {
  // If the first words of a run outside a ring were read as a start, the second would be a ring.
  for (const Events& invalid :
       {Script().fragment(up, {1, 0, 0}, 0).fragment_end().events,
        Script().region(up).region_end().events,
        Script().region(up).run(0, 2).ring({1, 0, 0}).run(0, 2).run(4, 3).region_end().events,
        Script().region(up).run(0, 2).ring({1, 0, 8}).run(0, 2).run(4, 3).region_end().events})
    for (const bool is_first : {true, false})
      for (uint32_t follower = 0; follower < 100; ++follower) {
        Script script;
        if (!is_first) script.region(up).square({1, 0, 0}, 2).region_end();
        const Events whole = script.events;
        script.events.insert(script.events.end(), invalid.begin(), invalid.end());
        script.layer(follower).skipped(7 * follower, follower, false);
        const Received arrival = decode(encode(script.finish().events));
        CHECK(pieces_of(arrival.events) == pieces_of(whole));
        CHECK(arrival.report.damaged_packets == 1);
        CHECK(arrival.report.has_trailer);
      }
}

TEST_CASE("a region lost before its end is reported as lost") {
  for (const uint32_t runs : {10U, 500U})
    for (int follower = 0; follower < 4; ++follower) {
      Chance chance(1);
      Script script;
      script.region(up).ring({1, 0, 0});
      for (uint32_t i = 0; i < runs; ++i) script.run(i % 8, 1 + chance.below(1000));
      script.lost();
      if (follower == 1) script.layer(7);
      if (follower == 2) script.region(up).square({1, 0, 0}, 2).region_end();
      if (follower == 3) script.fragment(up, {1, 0, 0}, 1).run(2, 2).fragment_end();
      const Events events = script.finish().events;
      const Received arrival = decode(encode(events));
      CHECK(pieces_of(arrival.events) == pieces_of(events));
      CHECK(arrival.events.back() == events.back());
    }
}

TEST_CASE("an unstarted encoder refuses events") {
  Encoder encoder;
  const Events events = Script().layer(1).region(up).square({1, 0, 0}, 2).region_end().events;
  for (const RecordedEvent& event : events)
    CHECK(encoder.accept(event.event()) == SinkResult::not_started);
}

TEST_CASE("a ring may begin at any fill level of a nearly full record") {
  constexpr uint32_t most = detail::stream::Record::max_words;
  for (uint32_t runs = most - 2 * detail::stream::Record::ring_words; runs <= most; ++runs) {
    Script script;
    script.region(up).ring({1, 0, 0});
    for (uint32_t i = 0; i < runs; ++i) script.run(i % 2 == 0 ? 0 : 2, 1);
    const Events events = script.square({1, 0, 8}, 2, true).region_end().finish().events;
    CHECK(decode(encode(events)).events == events);
  }
}

TEST_CASE("an event of an unknown kind is not encoded") {
  Event unknown{};
  unknown.kind = static_cast<Event::Kind>(200);
  Script script;
  script.region(up).square({1, 0, 0}, 2).region_end();
  Events with_unknown = script.events;
  with_unknown.insert(with_unknown.begin() + 2, RecordedEvent(unknown));
  CHECK(encode(with_unknown) == encode(script.events));
}

TEST_CASE("an event of an unknown kind does not end the open region") {
  Event region{}, unknown{};
  region.kind = Event::Kind::region;
  unknown.kind = static_cast<Event::Kind>(200);
  Line line;
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  REQUIRE(encoder.accept(region) == SinkResult::accepted);
  REQUIRE(encoder.accept(unknown) == SinkResult::accepted);
  CHECK(encoder.write_record({}) == Status::suspended);
}

TEST_CASE("an encoder encodes normals after restore() only if normals are enabled again") {
  for (const bool with_normals : {true, false}) {
    Line whole, line;
    NormalEncoder first;
    REQUIRE(begin_stream(first, any_header(), line.output()) == Status::ok);
    const Events square = Script().region(up).square({1, 0, 0}, 2).region_end().events;
    NormalEncoder uninterrupted;
    Encoder plain;
    Encoder& expected = with_normals ? uninterrupted : plain;
    REQUIRE(begin_stream(expected, any_header(), whole.output()) == Status::ok);

    Memory part;
    REQUIRE(first.save(&part) == Status::ok);
    Encoder after;
    read_back(image_of({part}), {memory_of(after)});
    REQUIRE(after.restore(line.output()) == Status::ok);
    if (with_normals) after.encode_normals();
    for (Encoder* const encoder : {&expected, &after}) {
      for (const RecordedEvent& recorded : square) {
        Event event = recorded.event();
        event.normal = {3, 4};
        REQUIRE(encoder->accept(event) == SinkResult::accepted);
      }
      REQUIRE(encoder->flush() == Status::ok);
    }
    CHECK(line.bytes == whole.bytes);
  }
}
