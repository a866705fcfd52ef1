// The decoder alone: refusals, skipped packets, reports, and handwritten packets.
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using Kind = Event::Kind;
using detail::stream::Record;
using detail::stream::RecordKind;
using detail::wire::PacketKind;
namespace contexts = detail::stream::contexts;

namespace {

constexpr uint8_t records_kind = static_cast<uint8_t>(PacketKind::records);

// A stream of a header and these payloads of records, without a trailer.
Bytes stream_of(const std::vector<Bytes>& payloads) {
  Bytes stream = frames_of(encode(Script().finish().events)).front();
  uint8_t number = 1;
  for (const Bytes& payload : payloads) {
    const Bytes frame = frame_of({records_kind, number++, 0, payload});
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  return stream;
}

// The frame of a header that reports these numbers of packets and pieces.
Bytes header_after(uint32_t packets, uint64_t pieces) {
  Packet header = packet_of(stream_of({}));
  header.number = static_cast<uint8_t>(packets);
  header.pieces = static_cast<uint16_t>(pieces);
  uint8_t* const counts = header.payload.data() + header.payload.size() - 12;
  detail::wire::put_long(detail::wire::put(counts, packets, 4), pieces);
  return frame_of(header);
}

template <class Code>
Bytes payload_of(Code code) {
  Payload payload;
  code(payload.model);
  return payload.finish();
}

template <class Model>
void code_layer(Model& model, uint32_t slice) {
  model.record_kind(RecordKind::layer);
  model.layer(slice);
}

// The symbols of rings across z with these turns at the second, third and last corner.
constexpr uint32_t corners_symbol(uint32_t second, uint32_t third, uint32_t last) {
  return 1 + (second - 1) + 3 * (third - 1) + 9 * (last - 1);
}
constexpr uint32_t corners_of_square = corners_symbol(2, 2, 2);
constexpr uint32_t corners_of_triangle = corners_symbol(3, 3, 2);

struct CodedRun {
  Direction direction;
  uint32_t length;
};
using CodedRuns = std::vector<CodedRun>;

// The runs of a chain, after its first direction.
template <class Model>
void code_runs(Model& model, const CodedRuns& runs) {
  for (size_t i = 0; i < runs.size(); ++i) {
    if (i == 0)
      model.length(contexts::lengths, runs[i].direction, runs[i].length);
    else
      model.run(Run::straight(runs[i].direction, runs[i].length));
    model.is_last_run(i + 1 == runs.size());
  }
}

// A part of a region across z, or of a fragment.
struct Part {
  bool continues;
  bool is_last;
  bool has_ring;
  bool is_fragment = false;
  Incidence incidence = up;
  Direction came = 6;
};

template <class Model>
void code_part(Model& model, const Part& part, const CodedRuns& runs) {
  model.record_kind(RecordKind::part);
  Record record;
  record.incidence = part.incidence;
  record.continues = part.continues;
  record.is_fragment = part.is_fragment;
  record.is_last = part.is_last;
  model.part(record, part.has_ring);
  if (part.has_ring) model.start({1, 0, 0});
  if (part.is_fragment && !part.continues) model.chain_direction(part.came);
  if (!runs.empty()) model.chain_direction(runs[0].direction);
  code_runs(model, runs);
}

// A region up to the data of its only ring, which begins with direction 0.
template <class Model>
void begin_ring(Model& model, uint32_t corners = 0, uint32_t from = 2) {
  model.record_kind(RecordKind::region);
  model.start({1, 0, 0});
  model.incidence(up);
  model.corners(corners);
  model.ring_direction(from);
  model.begin_chain(0);
}

// A turn of 2 in a plane across z, and a run longer than one link, after a direction.
template <class Model>
void code_long_run(Model& model, Direction direction, uint32_t length) {
  model.coder().symbol(contexts::of_class(2) + contexts::by_direction + 8 * contexts::turn,
                       2 * 2 + 1);
  model.length(contexts::longer, direction, length - 1);
}

// A region of squares at the same position.
template <class Model>
void code_squares(Model& model, uint32_t rings) {
  model.record_kind(RecordKind::holed);
  for (uint32_t ring = 0; ring < rings; ++ring) {
    model.start({1, 0, 0});
    if (ring == 0) model.incidence(up);
    if (ring == 0) model.plain_number(rings - 2);
    model.corners(corners_of_square);
    model.ring_direction(2);
    model.begin_chain(0);
    model.two_lengths(0);
  }
}

// A whole fragment: its incoming direction and its runs, in reverse if coded from its end.
template <class Model>
void code_fragment(Model& model, Direction came, const CodedRuns& runs) {
  model.record_kind(RecordKind::forwards);
  model.start({1, 0, 0});
  model.incidence(up);
  model.chain_direction(came);
  model.chain_direction(runs[0].direction);
  code_runs(model, runs);
}

template <class Model>
void code_fragment_backwards(Model& model, const CodedRuns& runs, Direction came) {
  model.record_kind(RecordKind::backwards);
  model.start({1, 0, 0});
  model.incidence(up);
  model.chain_direction(runs[0].direction);
  code_runs(model, runs);
  model.chain_direction(came);
}

// A record that no encoder writes: its incidence does not exist.
template <class Model>
void code_unreadable(Model& model) {
  model.record_kind(RecordKind::part);
  model.raw_bits(4, 1);
  model.raw_bits(5, 31);
}

// A region across z that continues in a later packet.
template <class Model>
void code_first_part(Model& model) {
  code_part(model, {false, false, true}, {{0, 2}});
}

// The rest of that region.
template <class Model>
void code_last_part(Model& model) {
  code_part(model, {true, true, false}, {{2, 2}});
}

// The events of the first part.
Script first_part() {
  Script script;
  script.region(up).ring({1, 0, 0}).run(0, 2);
  return script;
}

Bytes first_payload() {
  return payload_of([](auto& model) { code_first_part(model); });
}
Bytes last_payload() {
  return payload_of([](auto& model) { code_last_part(model); });
}
Bytes frame_at(uint32_t number, const Bytes& payload, uint16_t regions = 0) {
  return frame_of({records_kind, static_cast<uint8_t>(number), regions, payload});
}

// A payload of one unreadable part, written by hand, between two marks.
template <class Code>
void check_unreadable(Code code) {
  const Received arrival = decode(stream_of({payload_of([&](auto& model) {
    code_layer(model, 1);
    code(model);
    code_layer(model, 2);
  })}));
  CHECK(arrival.events == Script().layer(1).events);
  CHECK(arrival.report.damaged_packets == 1);
  CHECK_FALSE(arrival.report.is_complete());
}

}  // namespace

TEST_CASE("a decoder without a sink, with a channel above 63 or without a start refuses calls") {
  Decoder decoder;
  const uint8_t byte = 1;
  const Decoded decoded = decoder.push(&byte, 1);
  CHECK(decoded.status == Status::not_started);
  CHECK(decoded.bytes == 0);
  CHECK(decoder.finish() == Status::not_started);
  CHECK(decoder.start(Sink{}) == Status::bad_sink);
  EventLog log;
  CHECK(decoder.start(make_sink(log), StreamLabel::max_channel + 1) == Status::bad_label);
  CHECK(decoder.push(&byte, 1).status == Status::not_started);
}

TEST_CASE("a restarted decoder is independent of the previous stream") {
  const Sample sample = samples()[2];
  const Bytes stream = encode(sample.events, sample.header);
  Decoder decoder;
  for (size_t count = 0; count < stream.size(); count += 41) {
    EventLog first, second;
    REQUIRE(decoder.start(make_sink(first)) == Status::ok);
    REQUIRE(decoder.push(stream.data(), count).status == Status::ok);
    REQUIRE(decoder.start(make_sink(second)) == Status::ok);
    CHECK(decoder.header().width == 0);
    REQUIRE(decoder.push(stream.data(), stream.size()).status == Status::ok);
    CHECK(second.events == sample.events);
    CHECK(decoder.report().is_complete());
  }
}

TEST_CASE("a restarted decoder forgets refusals and pending events") {
  const Sample sample = samples()[2];
  const Bytes stream = encode(sample.events, sample.header);
  const Bytes unknown = with_version(3, stream_of({}));
  const Bytes lost = stream_of({first_payload()});
  Decoder decoder;
  EventLog log;
  REQUIRE(decoder.start(make_sink(log)) == Status::ok);
  CHECK(decoder.push(unknown.data(), unknown.size()).status == Status::wrong_version);
  CHECK_FALSE(decoder.report().has_header);
  CHECK(log.starts.empty());
  REQUIRE(decoder.start(make_sink(log)) == Status::ok);
  CHECK(decoder.push(lost.data(), lost.size()).status == Status::ok);
  CHECK(log.events == first_part().events);

  struct Wall {
    SinkResult accept(const Event&) { return SinkResult::busy; }
  } wall;
  REQUIRE(decoder.start(make_sink(wall)) == Status::ok);
  CHECK(decoder.push(lost.data(), lost.size()).status == Status::suspended);
  CHECK(decoder.finish() == Status::suspended);
  EventLog again;
  REQUIRE(decoder.start(make_sink(again)) == Status::ok);
  REQUIRE(decoder.push(stream.data(), stream.size()).status == Status::ok);
  CHECK(again.events == sample.events);
  CHECK(decoder.report().is_complete());
}

TEST_CASE("a restarted decoder neither continues an open region nor reports its loss") {
  struct Taker {
    SinkResult accept(const Event& event) {
      if (log.events.size() == most) return SinkResult::busy;
      return log.accept(event);
    }
    size_t most;
    EventLog log{};
  };
  const Bytes begun = stream_of({first_payload()});
  const Bytes end = frame_at(0, last_payload());
  for (const bool is_ended : {false, true}) {
    Taker taker{first_part().events.size()};
    Decoder decoder;
    REQUIRE(decoder.start(make_sink(taker)) == Status::ok);
    REQUIRE(decoder.push(begun.data(), begun.size()).status == Status::ok);
    if (is_ended) CHECK(decoder.finish() == Status::suspended);
    EventLog log;
    REQUIRE(decoder.start(make_sink(log)) == Status::ok);
    CHECK(decoder.push(end.data(), end.size()).status == Status::ok);
    CHECK(decoder.finish() == Status::ok);
    CHECK(log.events.empty());
  }
}

TEST_CASE("a decoder delivers the start event of every stream first, even after refusals") {
  const Bytes stream = stream_of({payload_of([](auto& model) { code_layer(model, 4); })});
  struct Late {
    SinkResult accept(const Event& event) {
      if (event.kind == Event::Kind::start && refusals-- > 0) return SinkResult::busy;
      return log.accept(event);
    }
    int refusals = 0;
    EventLog log{};
  } late;
  Decoder decoder;
  for (size_t streams = 1; streams < 4; ++streams) {
    late.refusals = 2;
    REQUIRE(decoder.start(make_sink(late)) == Status::ok);
    const Decoded first = decoder.push(stream.data(), stream.size());
    CHECK(first.status == Status::suspended);
    CHECK(first.bytes < stream.size());
    const Decoded second = decoder.push(stream.data() + first.bytes, stream.size() - first.bytes);
    CHECK(second.status == Status::suspended);
    CHECK(second.bytes == 0);
    CHECK(late.log.events.size() == streams - 1);
    const Decoded third = decoder.push(stream.data() + first.bytes, stream.size() - first.bytes);
    CHECK(third.status == Status::ok);
    CHECK(late.log.starts.size() == streams);
    CHECK(late.log.events.size() == streams);
  }
}

TEST_CASE("a start event that arrives in the middle of a region is delivered after the region") {
  struct Listener {
    SinkResult accept(const Event& event) {
      if (event.kind == Event::Kind::start) events_before_start = log.events.size();
      return log.accept(event);
    }
    size_t events_before_start = 0;
    EventLog log{};
  } listener;
  Decoder decoder;
  REQUIRE(decoder.start(make_sink(listener)) == Status::ok);
  const Bytes heard =
      joined({frame_at(1, first_payload()), header_after(2, 0), frame_at(3, last_payload())});
  REQUIRE(decoder.push(heard.data(), heard.size()).status == Status::ok);
  CHECK(listener.log.events == first_part().run(2, 2).region_end().events);
  CHECK(listener.log.starts.size() == 1);
  CHECK(listener.events_before_start == listener.log.events.size());
}

TEST_CASE(
    "a restarted decoder accepts a stream of any channel and scan, and its counts begin at zero") {
  StreamHeader header = any_header();
  header.scan = 7;
  header.channel = 2;
  const Events square = Script().region(up).square({1, 0, 0}, 2).region_end().finish().events;
  EventLog log;
  Decoder decoder;
  for (const Bytes& stream : {encode(square), encode(square, header)})
    for (size_t part = 1; part < 4; ++part) {
      REQUIRE(decoder.start(make_sink(log)) == Status::ok);
      REQUIRE(decoder.push(stream.data(), stream.size() * part / 3).status == Status::ok);
      CHECK(decoder.report().foreign_packets == 0);
      CHECK(decoder.report().is_complete() == (part == 3));
    }
}

TEST_CASE("packets of other channels and scans are ignored and counted as foreign") {
  const auto frame = [](uint16_t scan, uint8_t channel) {
    Packet packet = packet_of(stream_of({}));
    packet.scan = scan;
    packet.channel = channel;
    return frame_of(packet);
  };
  const Bytes link = joined({frame(1, 4), frame(2, 6), frame(3, 5), frame(4, 5)});
  EventLog log;
  Decoder decoder;
  REQUIRE(decoder.start(make_sink(log), 5) == Status::ok);
  REQUIRE(decoder.push(link.data(), link.size()).status == Status::ok);
  CHECK(decoder.report().foreign_packets == 3);
  CHECK(decoder.report().packets == 1);
  CHECK(decoder.header().scan == 3);
  // The second of two surfaces, which begin with channel 4.
  const Bytes two = frame(9, 4 | 1 << 6);
  REQUIRE(decoder.start(make_sink(log), 5) == Status::ok);
  REQUIRE(decoder.push(two.data(), two.size()).status == Status::ok);
  CHECK(decoder.header().scan == 9);
}

TEST_CASE("zeros between frames are ignored, and a single byte between zeros is a damaged frame") {
  const uint8_t bytes[] = {0, 0, 1, 0, 0, 2};
  EventLog log;
  Decoder decoder;
  REQUIRE(decoder.start(make_sink(log)) == Status::ok);
  REQUIRE(decoder.push(bytes, sizeof bytes).status == Status::ok);
  CHECK(decoder.report().damaged_packets == 1);
  CHECK(decoder.finish() == Status::ok);
  CHECK(decoder.report().damaged_packets == 2);
}

TEST_CASE("a wrong digest in the trailer marks the stream as mixed, if no packet is lost") {
  for (const uint8_t lost : {uint8_t{0}, uint8_t{1}}) {
    std::vector<Bytes> frames = frames_of(encode(Script().finish().events));
    Packet trailer = packet_of(frames.back());
    trailer.payload.back() ^= 1;
    trailer.number = static_cast<uint8_t>(trailer.number + lost);
    frames.back() = frame_of(trailer);
    const StreamReport report = decode(joined(frames)).report;
    CHECK(report.has_trailer);
    CHECK(report.is_mixed == (lost == 0));
    CHECK_FALSE(report.is_complete());
  }
}

TEST_CASE("an application record contains the slice and row at which it was written") {
  Line line;
  Encoder encoder;
  REQUIRE(begin_stream(encoder, any_header(), line.output()) == Status::ok);
  const uint8_t bytes[] = {0xFF, 0xFE};
  REQUIRE(encoder.write_record({9, 0x01020304, 0x05060708, bytes, 2}) == Status::ok);
  const Received received = decode(line.bytes);
  REQUIRE(received.events.size() == 1);
  const Event event = received.events[0].event();
  CHECK(event.application->kind == 9);
  CHECK(event.application->slice == 0x01020304);
  CHECK(event.application->row == 0x05060708);
  CHECK(event.application->count == 2);
  CHECK(event.application->bytes[1] == 0xFE);
}

TEST_CASE(
    "piece counts and packet numbers wrap, and numbers half their range ahead count as repeated") {
  const auto is_taken = [](uint8_t number, uint16_t pieces) {
    Bytes stream = stream_of({});
    const Bytes frame = frame_of({records_kind, number, pieces, payload_of([](auto&) {})});
    stream.insert(stream.end(), frame.begin(), frame.end());
    const StreamReport report = decode(stream).report;
    CHECK(report.packets + report.repeated_packets == 2);
    return report.packets == 2;
  };
  CHECK(is_taken(1, 0x7FFF));
  CHECK_FALSE(is_taken(1, 0x8000));
  CHECK_FALSE(is_taken(1, 0xFFFF));
  CHECK(is_taken(1 + 127, 0));
  CHECK_FALSE(is_taken(1 + 128, 0));
  CHECK(is_taken(1 + 128, 1));
}

TEST_CASE("lost regions are counted when the next packet arrives, before the trailer") {
  const Bytes heard =
      joined({stream_of({}), frame_of({records_kind, 2, 3, payload_of([](auto&) {})})});
  CHECK(decode(heard).report.lost_packets == 1);
  CHECK(decode(heard).report.lost_pieces == 3);
}

TEST_CASE("a trailer that counts fewer regions than arrived reports no lost regions") {
  const Events square = Script().region(up).square({1, 0, 0}, 2).region_end().finish().events;
  std::vector<Bytes> frames = frames_of(encode(square));
  REQUIRE(frames.size() == 3);
  Packet trailer = packet_of(frames[2]);
  trailer.pieces = 0;
  // After the slices, the flag and three totals.
  detail::wire::put_long(trailer.payload.data() + 4 + 1 + 3 * 8, 0);
  frames[2] = frame_of(trailer);
  const StreamReport report = decode(joined(frames)).report;
  CHECK(report.has_trailer);
  CHECK(report.regions == 1);
  CHECK(report.lost_pieces == 0);
  CHECK_FALSE(report.is_complete());
}

TEST_CASE("a stream of only a header is neither complete nor abandoned") {
  const StreamReport report = decode(stream_of({})).report;
  CHECK(report.has_header);
  CHECK(report.slices == 0);
  CHECK_FALSE(report.has_trailer);
  CHECK_FALSE(report.is_abandoned);
  CHECK_FALSE(report.is_complete());
}

TEST_CASE("a region of parallelograms may fill a record to the last word") {
  constexpr uint32_t rings = Record::max_words / (Record::ring_words + 4);
  static_assert(rings * (Record::ring_words + 4) == Record::max_words, "to the last word");
  Script script;
  script.region(up);
  for (uint32_t ring = 0; ring < rings; ++ring)
    script.square({1, 4 * static_cast<int32_t>(ring), 0}, 2, ring > 0);
  const Received arrival = decode(encode(script.region_end().finish().events));
  CHECK(arrival.events == script.events);
  CHECK(arrival.report.damaged_packets == 0);
}

TEST_CASE("a late header of another stream does not replace the first header") {
  StreamHeader other = any_header();
  other.width = 77;
  std::vector<Bytes> frames = frames_of(encode(Script().layer(0).finish().events));
  frames.pop_back();  // the trailer, after which everything is ignored
  frames.push_back(frames_of(encode(Script().finish().events, other)).front());
  const Received arrival = decode(joined(frames));
  CHECK(arrival.header.width == any_header().width);
  CHECK(arrival.report.repeated_packets == 1);
}

TEST_CASE("a later header reports all packets and regions lost before that header") {
  struct Before {
    uint32_t packets, regions;
  };
  for (const Before before : {Before{1, 0}, Before{2, 0}, Before{257, 0}, Before{300, 70000},
                              Before{1, 5}, Before{1, 65536}, Before{2, 70000}}) {
    INFO("packets ", before.packets, ", regions ", before.regions);
    const StreamReport report =
        decode(joined({stream_of({}), header_after(before.packets, before.regions)})).report;
    CHECK(report.packets == 2);
    CHECK(report.lost_packets == before.packets - 1);
    CHECK(report.lost_pieces == before.regions);
  }
}

TEST_CASE(
    "a header that reports lost packets ends the open region, unless a gap preceded the region") {
  // The number of a packet wraps at 256: a loss of 256 packets is invisible, a loss of 257 is not.
  for (const bool gap_is_seen : {false, true}) {
    const uint32_t number = gap_is_seen ? 258 : 257;
    const Received arrival =
        decode(joined({stream_of({}), frame_at(number, first_payload()),
                       header_after(number + 1, 0), frame_at(number + 2, last_payload())}));
    Script expected = first_part();
    if (gap_is_seen)
      expected.run(2, 2).region_end();
    else
      expected.lost();
    CHECK(arrival.events == expected.events);
    CHECK(arrival.report.lost_packets == number - 1);
  }
}

TEST_CASE("a region continues after a header if packets were lost only before the region") {
  Decoder decoder;
  for (const uint32_t missed : {0U, 1U, 255U, 256U, 512U}) {
    CAPTURE(missed);
    EventLog log;
    REQUIRE(decoder.start(make_sink(log)) ==
            Status::ok);  // again, although it has a header already
    const Bytes heard = joined({frame_at(missed, first_payload()), header_after(missed + 1, 0),
                                frame_at(missed + 2, last_payload())});
    REQUIRE(decoder.push(heard.data(), heard.size()).status == Status::ok);
    CHECK(log.events == first_part().run(2, 2).region_end().events);
    CHECK(decoder.report().lost_packets == missed);
  }
}

TEST_CASE("a header that reports a gap ends the open region, even after an earlier gap") {
  struct Gap {
    uint32_t packets;
    uint64_t regions;
  };
  for (const Gap gap : {Gap{1, 0}, Gap{255, 0}, Gap{256, 1}, Gap{512, 2}}) {
    CAPTURE(gap.packets);
    const uint32_t number = 5;
    const Received arrival = decode(joined(
        {stream_of({}), frame_at(number, first_payload()),
         header_after(number + 1 + gap.packets, gap.regions),
         frame_at(number + 2 + gap.packets, last_payload(), static_cast<uint16_t>(gap.regions))}));
    CHECK(arrival.events == first_part().lost().events);
    CHECK(arrival.report.lost_packets == number - 1 + gap.packets);
  }
}

TEST_CASE(
    "a header counts as lost only regions that neither arrived nor were already counted as lost") {
  const Events square = Script().region(up).square({1, 0, 0}, 2).region_end().finish().events;
  const std::vector<Bytes> frames = frames_of(encode(square));
  for (const uint64_t before : {0U, 1U, 2U, 7U}) {
    const StreamReport report =
        decode(joined({frames[0], frames[1], header_after(2, before)})).report;
    CHECK(report.regions == 1);
    CHECK(report.lost_pieces == (before < 1 ? 0 : before - 1));
  }
}

TEST_CASE("without a header, a repeated packet is still counted as repeated") {
  const Bytes frame = frame_at(200, payload_of([](auto& model) { code_layer(model, 3); }));
  const Received arrival = decode(joined({frame, frame}));
  CHECK(arrival.events == Script().layer(3).events);
  CHECK(arrival.report.lost_packets == 200);
  CHECK(arrival.report.repeated_packets == 1);
}

TEST_CASE("packets of minimal and maximal length are accepted, and longer packets are damaged") {
  const uint8_t unknown_kind = 9;
  for (const size_t bytes : {size_t{0}, detail::wire::max_payload - 1, detail::wire::max_payload}) {
    const StreamReport report = decode(frame_of({unknown_kind, 0, 0, Bytes(bytes, 0x33)})).report;
    CHECK(report.packets == 1);
    CHECK(report.damaged_packets == 0);
  }
  for (const size_t more : {1U, 2U, 3U, 300U}) {
    Bytes frame = frame_of({unknown_kind, 0, 0, Bytes(detail::wire::max_payload, 0x33)});
    frame.insert(frame.end() - 1, more, 0x33);
    const StreamReport report = decode(frame).report;
    CHECK(report.packets == 0);
    CHECK(report.damaged_packets == 1);
  }
}

TEST_CASE("a region does not continue after an unreadable packet") {
  const Bytes unreadable = payload_of([](auto& model) { code_unreadable(model); });
  CHECK(decode(stream_of({first_payload(), unreadable, last_payload()})).events ==
        first_part().lost().events);
}

TEST_CASE("a run of maximal length is decoded in parts and in a fragment") {
  const Received arrival = decode(stream_of({payload_of([](auto& model) {
    code_part(model, {false, true, true}, {{0, Run::max_length}, {2, Run::max_length}});
    code_fragment(model, 0, {{2, Run::max_length}});
  })}));
  const Events expected = Script()
                              .region(up)
                              .ring({1, 0, 0})
                              .run(0, Run::max_length)
                              .run(2, Run::max_length)
                              .region_end()
                              .fragment(up, {1, 0, 0}, 0)
                              .run(2, Run::max_length)
                              .fragment_end()
                              .events;
  CHECK(arrival.events == expected);
}

TEST_CASE("a fragment coded backwards is decoded with its start first and its runs in order") {
  CHECK(decode(stream_of({payload_of([](auto& model) {
          code_fragment(model, 2, {{4, 10}, {6, 20}});
        })}))
            .events ==
        Script().fragment(up, {1, 0, 0}, 2).run(4, 10).run(6, 20).fragment_end().events);
  // The vertex is the last one before the end.
  const Vertex first = direction_vector(up, 4);
  const Vertex second = direction_vector(up, 6);
  const Vertex start{1 - 10 * first.x - 19 * second.x, -10 * first.y - 19 * second.y, 0};
  CHECK(decode(stream_of({payload_of([](auto& model) {
          code_fragment_backwards(model, {{6, 20}, {4, 10}}, 2);
        })}))
            .events == Script().fragment(up, start, 2).run(4, 10).run(6, 20).fragment_end().events);
}

TEST_CASE("a fragment may fill a record to the last word, and a further run is refused") {
  constexpr uint32_t most = Record::max_words - Record::ring_words;
  for (const bool is_backwards : {false, true})
    for (const uint32_t count : {most, most + 1, most + 5}) {
      CodedRuns runs;
      for (uint32_t i = 0; i < count; ++i) runs.push_back({static_cast<Direction>(i % 4), 1});
      const Received arrival = decode(stream_of({payload_of([&](auto& model) {
        if (is_backwards)
          code_fragment_backwards(model, runs, 0);
        else
          code_fragment(model, 0, runs);
      })}));
      CHECK(pieces_of(arrival.events).size() == (count == most ? 1 : 0));
      CHECK(arrival.report.fragments == (count == most ? 1 : 0));
      CHECK(arrival.report.damaged_packets == (count == most ? 0 : 1));
    }
}

TEST_CASE("a part without its beginning counts as a lost region or a lost fragment") {
  for (const bool is_fragment : {false, true}) {
    const Received arrival = decode(stream_of({payload_of([&](auto& model) {
      code_part(model, {true, true, false, is_fragment}, {{0, 2}});
    })}));
    CHECK(arrival.events.empty());
    CHECK(arrival.report.lost_pieces == 1);
  }
}

TEST_CASE("a part without its beginning counts as lost after a fragment with other directions") {
  const Received arrival = decode(stream_of({payload_of([](auto& model) {
    code_fragment(model, 7, {{0, 2}});
    code_part(model, {true, true, false, true, incidence_of({1, 1, 0})}, {{0, 2}});
  })}));
  CHECK(arrival.report.fragments == 1);
  CHECK(arrival.report.lost_pieces == 1);
  CHECK(arrival.report.damaged_packets == 0);
}

TEST_CASE("a truncated stream delivers its whole pieces, and the report has no trailer") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const std::vector<Bytes> frames = frames_of(encode(sample.events, sample.header));
    const Bytes stream = joined(frames);
    const std::vector<Events> brought = events_by_frame(frames);
    const size_t step = stream.size() < 1200 ? 1 : 1 + stream.size() / 25;
    size_t frame = 0, whole = 0, from = 0;
    for (size_t count = 0; count < stream.size(); ++count) {
      if (count == from + frames[frame].size()) {
        from += frames[frame].size();
        whole += brought[frame++].size();
      }
      if (count % step != 0 && count != from && count + 1 != stream.size()) continue;
      const Received cut =
          decode({stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(count)});
      Events expected(sample.events.begin(),
                      sample.events.begin() + static_cast<std::ptrdiff_t>(whole));
      const bool was_open = cut.events.size() > whole && cut.events.back().is(Kind::lost);
      if (was_open) expected.push_back(cut.events.back());
      REQUIRE(cut.events == expected);
      CHECK(pieces_of(cut.events).size() == cut.report.regions + cut.report.fragments);
      CHECK_FALSE(cut.report.is_complete());
      CHECK_FALSE(cut.report.is_abandoned);
      CHECK(cut.report.slices == 0);
      CHECK(cut.report.damaged_packets == (count == from ? 0 : 1));
      CHECK(cut.report.packets == frame);
    }
  }
}

TEST_CASE("an overlong frame at the end leaves the next stream undamaged") {
  const Bytes noise(1000, 7);
  const Bytes stream = encode(Script().finish().events, any_header());
  EventLog log;
  Decoder decoder;
  REQUIRE(decoder.start(make_sink(log)) == Status::ok);
  REQUIRE(decoder.push(noise.data(), noise.size()).status == Status::ok);
  REQUIRE(decoder.finish() == Status::ok);
  REQUIRE(decoder.push(stream.data(), stream.size()).status == Status::ok);
  CHECK(decoder.report().has_header);
  CHECK(decoder.report().damaged_packets == 1);
}

TEST_CASE("noise before, between and after frames is ignored") {
  const Sample sample = samples()[4];
  Chance chance(1);
  Bytes noisy;
  uint64_t damaged = 0;
  for (const Bytes& frame : frames_of(encode(sample.events, sample.header))) {
    const uint32_t count = chance.below(700);
    for (uint32_t i = 0; i < count; ++i)
      noisy.push_back(static_cast<uint8_t>(1 + chance.below(255)));
    damaged += count > 0;
    noisy.insert(noisy.end(), 1 + chance.below(3), 0);
    noisy.insert(noisy.end(), frame.begin(), frame.end());
  }
  const Received arrival = decode(noisy);
  CHECK(arrival.events == sample.events);
  CHECK(arrival.report.is_complete());
  CHECK(arrival.report.damaged_packets == damaged);
}

TEST_CASE("an unknown version is reported, and no events are delivered") {
  const Sample sample = samples()[2];
  for (const uint8_t version : Bytes{0, 2, 3, 255}) {
    std::vector<Bytes> frames = frames_of(encode(sample.events, sample.header));
    Packet header = packet_of(frames[0]);
    header.payload[3] = version;
    header.payload.resize(40, 0x55);
    frames[0] = frame_of(header);
    const Received arrival = decode(joined(frames));
    CHECK(arrival.status == Status::wrong_version);
    CHECK(arrival.events.empty());
    CHECK_FALSE(arrival.report.has_header);
    CHECK(arrival.report.packets == 0);
  }
}

TEST_CASE("a header with invalid values is refused") {
  const Bytes frame = frames_of(encode(Script().finish().events)).front();
  const auto without_header = [&](size_t at, uint8_t value, size_t size) {
    Packet packet = packet_of(frame);
    packet.payload.resize(size);
    if (at < size) packet.payload[at] = value;
    const Received arrival = decode(frame_of(packet));
    CHECK(arrival.report.packets + arrival.report.damaged_packets == 1);
    return !arrival.report.has_header && arrival.report.damaged_packets == 1;
  };
  CHECK(without_header(0, 'd', detail::wire::header_payload));
  CHECK(without_header(4, 0, detail::wire::header_payload));     // width 0
  CHECK(without_header(5, 0x80, detail::wire::header_payload));  // width above the limit
  CHECK(without_header(6, 0, detail::wire::header_payload));     // height 0
  using Flags = detail::wire::HeaderFlags;
  constexpr size_t flags = detail::wire::header_payload - 8 - 4 - 1;
  CHECK(without_header(flags, Flags::slices | Flags::levels, detail::wire::header_payload));
  CHECK(without_header(99, 0, detail::wire::header_payload - 1));
  CHECK_FALSE(
      without_header(99, 0, detail::wire::header_payload + 5));  // a later version may be longer
}

TEST_CASE("extra bytes at the end of a header are ignored") {
  Packet packet = packet_of(stream_of({}));
  packet.payload.insert(packet.payload.end(), 5, 0xFF);
  const StreamReport report = decode(frame_of(packet)).report;
  CHECK(report.packets == 1);
  CHECK(report.lost_packets == 0);
  CHECK(report.lost_pieces == 0);
}

TEST_CASE(
    "a short trailer is refused, and a trailer that counts more regions reports lost regions") {
  const Events square = Script().region(up).square({1, 0, 0}, 2).region_end().finish().events;
  const std::vector<Bytes> frames = frames_of(encode(square));
  Packet trailer = packet_of(frames[2]);
  for (const uint32_t lost : {0U, 3U, 0x7FFFU, 0x8000U, 0x8001U, 65536U, 1000000U}) {
    // After the slices, the flag and three totals.
    detail::wire::put_long(trailer.payload.data() + 4 + 1 + 3 * 8, 1 + lost);
    trailer.pieces = static_cast<uint16_t>(1 + lost);
    const StreamReport report = decode(joined({frames[0], frames[1], frame_of(trailer)})).report;
    CHECK(report.has_trailer);
    CHECK(report.lost_pieces == lost);
    CHECK(report.lost_packets == 0);
  }
  trailer.payload.pop_back();
  const StreamReport report = decode(joined({frames[0], frames[1], frame_of(trailer)})).report;
  CHECK_FALSE(report.has_trailer);
  CHECK(report.damaged_packets == 1);
}

TEST_CASE("packets of unknown kinds are skipped without a reported loss") {
  const Sample sample = samples()[4];
  std::vector<Bytes> frames;
  uint8_t number = 0;
  for (const Bytes& frame : frames_of(encode(sample.events, sample.header))) {
    Packet packet = packet_of(frame);
    const Packet stranger{static_cast<uint8_t>(number % 2 == 0 ? 4 : 255), number, packet.pieces,
                          Bytes(number % 99, 0xC3)};
    if (number > 0) frames.push_back(frame_of(stranger));
    if (number > 0) ++number;
    packet.number = number++;
    if (packet.is(detail::wire::PacketKind::trailer))
      detail::wire::put(&*packet.payload.end() - 4, digest_of(frames), 4);
    frames.push_back(frame_of(packet));
  }
  const Received arrival = decode(joined(frames));
  CHECK(arrival.events == sample.events);
  CHECK(arrival.report.is_complete());
}

TEST_CASE("extension records are skipped") {
  const Bytes payload = payload_of([](auto& model) {
    for (const uint32_t bytes : {0U, 1U, 5U, 100U}) {
      code_layer(model, bytes);
      model.record_kind(RecordKind::extension);
      model.raw_bits(8, 0xEE);
      model.raw_bits(8, bytes);
      for (uint32_t i = 0; i < bytes; ++i) model.raw_bits(8, i * 37 & 0xFF);
    }
    code_layer(model, 101);
  });
  const Received arrival = decode(stream_of({payload}));
  CHECK(arrival.events == Script().layer(0).layer(1).layer(5).layer(100).layer(101).events);
  CHECK(arrival.report.damaged_packets == 0);
}

TEST_CASE("a region sent entirely in parts is delivered as a single region") {
  const Bytes first = payload_of([](auto& model) {
    code_part(model, {false, false, true}, {{3, 70000}});
  });
  const Bytes second = payload_of([](auto& model) {
    code_part(model, {true, false, false}, {{7, 1}});
    code_part(model, {true, false, true}, {{1, 1}});
  });
  const Bytes third = payload_of([](auto& model) {
    code_part(model, {true, true, false}, {{0, 2}});
  });
  Script expected;
  expected.region(up).ring({1, 0, 0}).run(3, 70000).run(7, 1).ring({1, 0, 0}, true).run(1, 1);
  CHECK(decode(stream_of({first, second, third})).events == expected.run(0, 2).region_end().events);
  CHECK(decode(stream_of({second, third})).events.empty());
  Script broken;
  broken.region(up).ring({1, 0, 0}).run(3, 70000).lost();
  CHECK(decode(stream_of({first})).events == broken.events);
  CHECK(decode(stream_of({first, first})).events.size() == 2 * broken.events.size());
}

TEST_CASE("a layer mark between parts ends the open region") {
  const Bytes payload = payload_of([](auto& model) {
    code_first_part(model);
    code_layer(model, 9);
    code_last_part(model);
  });
  CHECK(decode(stream_of({payload})).events == first_part().lost().layer(9).events);
}

TEST_CASE("records that violate the grammar are refused") {
  check_unreadable([](auto& model) {  // runs without a ring before them
    code_part(model, {false, true, false}, {{0, 2}});
  });
  check_unreadable([](auto& model) {  // a second ring in a fragment
    code_part(model, {true, true, true, true}, {{0, 2}});
  });
  check_unreadable([](auto& model) {  // a fragment without a start
    code_part(model, {false, true, false, true}, {{0, 2}});
  });
  for (const uint32_t incidence : {uint32_t{no_incidence}, 27U, 31U}) {
    check_unreadable([&](auto& model) {  // a part without an incidence
      model.record_kind(RecordKind::part);
      model.raw_bits(4, 1);
      model.raw_bits(5, incidence);
    });
    for (const RecordKind kind : {RecordKind::region, RecordKind::holed, RecordKind::forwards})
      check_unreadable([&](auto& model) {  // and whole records
        model.record_kind(kind);
        model.start({1, 1, 1});
        model.raw_bits(5, incidence);
      });
  }
  // The second length would be that of a short run if its upper bits were ignored.
  for (const uint32_t too_long : {Run::max_length + 1, 2 * (Run::max_length + 1) + 5}) {
    check_unreadable([&](auto& model) {  // a first run that is too long
      code_part(model, {false, true, true}, {{0, too_long}});
    });
    check_unreadable([&](auto& model) {  // a later run that is too long
      model.record_kind(RecordKind::forwards);
      model.start({1, 0, 0});
      model.incidence(up);
      model.chain_direction(2);
      model.chain_direction(0);
      model.length(contexts::lengths, 0, 1);
      model.is_last_run(false);
      code_long_run(model, 2, too_long);
      model.is_last_run(true);
    });
  }
  check_unreadable([](auto& model) {  // a first run without links, because its length wraps
    code_part(model, {false, true, true}, {});
    model.chain_direction(0);
    model.coder().symbol(contexts::lengths + 3 * contexts::of_number, contexts::of_number - 1);
    model.raw_bits(5, 31);
    model.raw_bits(32, 0);
    model.is_last_run(true);
  });
  check_unreadable([](auto& model) {  // a run of a fragment that is too long
    code_fragment(model, 4, {{0, Run::max_length + 1}});
  });
  check_unreadable([](auto& model) {  // more rings than a record has room for
    code_squares(model, Record::max_words / (Record::ring_words + 4) + 1);
  });
  for (const uint32_t from : {4U, 7U})
    check_unreadable([&](auto& model) {  // a first direction outside the plane
      model.record_kind(RecordKind::region);
      model.start({0, 1, 0});
      model.incidence(incidence_of({1, 1, 0}));
      model.corners(1);
      model.ring_direction(from);
    });
  for (const uint32_t first : {0U, 1U})
    check_unreadable([&](auto& model) {  // a length of a square that is too long
      begin_ring(model, corners_of_square);
      model.two_lengths(first == 0 ? 12 : 3);
      model.length(contexts::longer, 0, detail::stream::max_compact_length - 2);
    });
  check_unreadable(
      [](auto& model) {  // a length of a trapezoid; its last two lengths would be valid
        begin_ring(model, corners_symbol(3, 1, 1));
        model.two_lengths(12);
        model.length(contexts::longer, 0, detail::stream::max_compact_length - 2);
      });
  check_unreadable([](auto& model) {  // a length of a triangle that is too long
    begin_ring(model, corners_of_triangle);
    model.length(contexts::lengths, 0, detail::stream::max_compact_length + 1);
  });
  for (const uint32_t corners : {corners_symbol(1, 3, 2), corners_symbol(2, 1, 2)})
    check_unreadable(
        [&](auto& model) {  // rings of four corners that their last two runs cannot close
          begin_ring(model, corners);
          model.two_lengths(0);
        });
  check_unreadable([](auto& model) {  // run by run, with one run too long
    begin_ring(model);
    model.length(contexts::lengths, 0, detail::stream::max_compact_length + 1);
    model.is_last_run(true);
  });
  check_unreadable([](auto& model) {  // with a later run too long
    begin_ring(model);
    model.length(contexts::lengths, 0, 1);
    model.is_last_run(false);
    code_long_run(model, 2, detail::stream::max_compact_length + 1);
    model.is_last_run(true);
  });
  check_unreadable([](auto& model) {  // with runs whose last one is too short
    begin_ring(model);
    code_runs(model, {{0, 1}, {4, detail::stream::max_compact_length + 1}});
  });
  check_unreadable([](auto& model) {  // no run leads back from the end of the runs
    begin_ring(model);
    code_runs(model, {{0, 1}, {1, 1}});
  });
  check_unreadable([](auto& model) {  // the runs lead back already
    begin_ring(model);
    code_runs(model, {{0, 1}, {4, 1}});
  });
  check_unreadable([](auto& model) {  // a last run that would be too long
    begin_ring(model);
    code_runs(model, {{0, detail::stream::max_compact_length}, {2, 1}, {6, 1}, {0, 1}});
  });
}

TEST_CASE("a stream with an unreadable packet is incomplete, even if no region is missing") {
  std::vector<Bytes> frames = frames_of(encode(Script().layer(0).layer(1).finish().events));
  Packet packet = packet_of(frames[1]);
  packet.payload = payload_of([](auto& model) { code_unreadable(model); });
  frames[1] = frame_of(packet);
  CHECK_FALSE(decode(joined(frames)).report.is_complete());
}

TEST_CASE("a part that continues no piece ends the open region, and two regions count as lost") {
  const auto code_stray = [](auto& model) {
    code_part(model, {true, true, false, false, incidence_of({1, 0, 0})}, {{0, 2}});
  };
  const Received arrival = decode(stream_of({payload_of([&](auto& model) {
    code_first_part(model);
    code_stray(model);
    code_last_part(model);
    code_layer(model, 5);
  })}));
  CHECK(arrival.events == first_part().lost().layer(5).events);
  CHECK(arrival.report.lost_pieces == 2);
  CHECK(arrival.report.damaged_packets == 0);
}

TEST_CASE("a stream with a lost region is incomplete, even if the total of regions matches") {
  Events one = Script().region(up).square({1, 0, 0}, 2).region_end().finish().events;
  std::vector<Bytes> frames = frames_of(encode(one));
  Packet packet = packet_of(frames[1]);
  packet.payload = payload_of([](auto& model) {
    code_last_part(model);
    code_first_part(model);
    code_last_part(model);
  });
  frames[1] = frame_of(packet);
  const StreamReport report = decode(joined(frames)).report;
  CHECK(report.regions == report.totals.regions);
  CHECK(report.lost_packets == 0);
  CHECK(report.lost_pieces == 1);
  CHECK_FALSE(report.is_complete());
}

TEST_CASE("a part with another incidence or kind does not continue the open piece") {
  for (const bool is_fragment : {false, true})
    for (const Incidence incidence : {up, Incidence{0}}) {
      if (!is_fragment && incidence == up) continue;
      const Received arrival = decode(stream_of({payload_of([&](auto& model) {
        code_first_part(model);
        code_part(model, {true, true, false, is_fragment, incidence}, {{0, 2}});
      })}));
      CHECK(arrival.events == first_part().lost().events);
    }
}

TEST_CASE("a ring of two opposite runs is decoded up to the maximal compact length") {
  for (const uint32_t length : {1U, detail::stream::max_compact_length}) {
    const Received arrival = decode(stream_of({payload_of([&](auto& model) {
      begin_ring(model);
      code_runs(model, {{0, length}});
    })}));
    CHECK(arrival.events ==
          Script().region(up).ring({1, 0, 0}).run(0, length).run(4, length).region_end().events);
  }
}

TEST_CASE("a ring that fills a record is delivered, and a longer ring is refused") {
  constexpr uint32_t longest = Record::max_words - Record::ring_words;
  for (const uint32_t count : {longest, longest + 1, longest + 2, longest + 4}) {
    CodedRuns runs;
    for (uint32_t i = 0; i + 1 < count; ++i)
      runs.push_back({static_cast<Direction>(i % 2 == 0 ? 0 : 4), 1});
    const Received arrival = decode(stream_of({payload_of([&](auto& model) {
      begin_ring(model);
      code_runs(model, runs);
    })}));
    CHECK(pieces_of(arrival.events).size() == (count == longest ? 1 : 0));
    CHECK(arrival.report.damaged_packets == (count == longest ? 0 : 1));
  }
}

TEST_CASE("a ring of four corners is coded by turns and two lengths, a triangle by one length") {
  const Received arrival = decode(stream_of({payload_of([](auto& model) {
    begin_ring(model, corners_of_square);
    model.two_lengths(4 * 3 + 1);  // four links or more, then two
    model.length(contexts::longer, 0, detail::stream::max_compact_length - 3);
    begin_ring(model, corners_of_triangle);
    model.length(contexts::lengths, 0, 5);
  })}));
  const Events expected = Script()
                              .region(up)
                              .ring({1, 0, 0})
                              .run(0, detail::stream::max_compact_length)
                              .run(2, 2)
                              .run(4, detail::stream::max_compact_length)
                              .run(6, 2)
                              .region_end()
                              .region(up)
                              .ring({1, 0, 0})
                              .run(0, 5)
                              .run(3, 10)
                              .run(6, 5)
                              .region_end()
                              .events;
  CHECK(arrival.events == expected);
}

TEST_CASE("a fragment in parts is continued only by parts of the same incidence") {
  for (const bool is_same : {true, false}) {
    const Received arrival = decode(stream_of({payload_of([&](auto& model) {
      code_part(model, {false, false, true, true, up, 5}, {{0, 2}});
      code_part(model, {true, true, false, true, is_same ? up : Incidence{0}}, {{2, 3}});
    })}));
    Script expected;
    expected.fragment(up, {1, 0, 0}, 5).run(0, 2);
    if (is_same)
      expected.run(2, 3).fragment_end();
    else
      expected.lost();
    CHECK(arrival.events == expected.events);
    CHECK(arrival.report.fragments == (is_same ? 1 : 0));
    CHECK(arrival.report.lost_pieces == (is_same ? 0 : 1));
  }
}

TEST_CASE("a second ring in a fragment is refused, even in a continued part") {
  const Received arrival = decode(stream_of({payload_of([&](auto& model) {
    code_part(model, {false, false, true, true, up, 5}, {{0, 2}});
    code_part(model, {true, true, true, true}, {{2, 3}});
  })}));
  CHECK(arrival.events == Script().fragment(up, {1, 0, 0}, 5).run(0, 2).lost().events);
  CHECK(arrival.report.damaged_packets == 1);
}

TEST_CASE("a stream is incomplete if the number of fragments in the trailer differs") {
  const Events one = Script().fragment(up, {1, 0, 0}, 2).run(2, 2).fragment_end().finish().events;
  std::vector<Bytes> frames = frames_of(encode(one));
  REQUIRE(decode(joined(frames)).report.is_complete());
  Packet trailer = packet_of(frames.back());
  // After the number of slices and the flag. A region replaces the fragment.
  detail::wire::put_long(trailer.payload.data() + 4 + 1 + 3 * 8, 1);
  detail::wire::put_long(trailer.payload.data() + 4 + 1 + 6 * 8, 0);
  frames.back() = frame_of(trailer);
  const StreamReport report = decode(joined(frames)).report;
  CHECK(report.lost_pieces == 0);
  CHECK_FALSE(report.is_complete());
}

TEST_CASE("a header that arrives after records still counts as the first header") {
  std::vector<Bytes> frames = frames_of(encode(Script().layer(0).layer(1).finish().events));
  std::swap(frames[0], frames[1]);
  const Received arrival = decode(joined(frames));
  CHECK(arrival.report.has_header);
  CHECK(arrival.report.repeated_packets == 1);
  CHECK(arrival.header.width == any_header().width);
}

TEST_CASE("a decoder repeats the last events of a stream until the sink accepts") {
  const Bytes stream = stream_of({first_payload()});
  for (const uint32_t refusals : {0U, 1U, 3U}) {
    struct Sullen {
      SinkResult accept(const Event& event) {
        if (event.kind == Event::Kind::start) return SinkResult::accepted;
        if (refused++ < refusals) return SinkResult::busy;
        refused = 0;
        return log.accept(event);
      }
      uint32_t refusals;
      uint32_t refused = 0;
      EventLog log{};
    } sullen{refusals};
    Decoder decoder;
    REQUIRE(decoder.start(make_sink(sullen)) == Status::ok);
    const Decoded decoded = decoder.push(stream.data(), stream.size());
    CHECK(decoded.bytes == stream.size());
    CHECK(decoded.status == (refusals == 0 ? Status::ok : Status::suspended));
    // The events that push() could not deliver, and the loss, which only the end reveals.
    uint32_t calls = 1;
    while (decoder.finish() == Status::suspended) ++calls;
    CHECK(calls == (refusals == 0 ? 1 : 4 * refusals));
    CHECK(sullen.log.events == Script().region(up).ring({1, 0, 0}).run(0, 2).lost().events);
  }
}

TEST_CASE("a payload that ends within a record is refused as damaged") {
  const Bytes whole = payload_of([](auto& model) {
    for (uint32_t slice = 0; slice < 100; ++slice) code_layer(model, slice * 3);
  });
  for (size_t count = 0; count < whole.size(); ++count) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(count));
    const Received arrival = decode(stream_of({part}));
    CHECK(arrival.events.size() <= 100);
    (void)pieces_of(arrival.events);
  }
}

TEST_CASE("a part may fill a record to the last word, and a longer part is refused as damaged") {
  constexpr uint32_t most = Record::max_words - Record::ring_words;
  const auto code_part_of = [](auto& model, uint32_t count) {
    CodedRuns runs;
    for (uint32_t i = 0; i < count; ++i) runs.push_back({static_cast<Direction>(i % 4), 1});
    code_part(model, {false, true, true}, runs);
  };
  const Received full =
      decode(stream_of({payload_of([&](auto& model) { code_part_of(model, most); })}));
  CHECK(full.report.regions == 1);
  CHECK(full.events.size() == 1 + 1 + most + 1);
  check_unreadable([&](auto& model) { code_part_of(model, most + 1); });
}

TEST_CASE("a truncated frame at the end counts as damaged once") {
  EventLog log;
  Decoder decoder;
  const Bytes frame = frames_of(encode(Script().finish().events)).front();
  REQUIRE(decoder.start(make_sink(log)) == Status::ok);
  REQUIRE(decoder.push(frame.data(), frame.size() - 1).status == Status::ok);
  for (int i = 0; i < 2; ++i) {
    CHECK(decoder.finish() == Status::ok);
    CHECK(decoder.report().damaged_packets == 1);
  }
  CHECK(decoder.push(frame.data(), frame.size()).status == Status::ok);
  CHECK(decoder.finish() == Status::ok);
  CHECK(decoder.report().damaged_packets == 1);
  CHECK(decoder.report().has_header);
}

TEST_CASE("packets after the trailer are not delivered") {
  const Sample sample = samples()[4];
  const Bytes stream = encode(sample.events, sample.header);
  const Sample other = samples()[5];
  Bytes two = stream;
  const Bytes second = encode(other.events, other.header);
  two.insert(two.end(), second.begin(), second.end());
  const Received arrival = decode(two);
  CHECK(arrival.events == sample.events);
  CHECK(arrival.report.is_complete());
  CHECK(arrival.report.repeated_packets == frames_of(second).size());
}

TEST_CASE("is_complete() requires a header, a trailer, and no lost or unreadable packet") {
  StreamReport whole{};
  whole.has_header = whole.has_trailer = true;
  whole.regions = whole.totals.regions = 7;
  whole.fragments = whole.totals.fragments = 3;
  CHECK(whole.is_complete());
  const auto is_complete_but = [&](auto change) {
    StreamReport report = whole;
    change(report);
    return report.is_complete();
  };
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.has_header = false; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.has_trailer = false; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.lost_packets = 1; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.lost_pieces = 1; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.regions = 8; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.fragments = 2; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.is_unreadable = true; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.is_mixed = true; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.rows = 1; }));
  CHECK_FALSE(is_complete_but([](StreamReport& report) { report.lost_rows = 1; }));
}
