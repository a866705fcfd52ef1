// A stream over a lossy link: every loss is counted exactly, and no wrong event is delivered.
#include "oracle/stream_samples.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using Kind = Event::Kind;
using detail::wire::PacketKind;

namespace {

// A stream in frames, and the frames of each of its regions and fragments.
struct Sent {
  struct Span {
    size_t first, last;
    Events events;
  };

  explicit Sent(const Events& events, const StreamHeader& header = any_header())
      : Sent(frames_of(encode(events, header))) {}

  explicit Sent(std::vector<Bytes> whole)
      : frames(std::move(whole)), brought(events_by_frame(frames)) {
    Span span{};
    for (size_t i = 0; i < frames.size(); ++i)
      for (const RecordedEvent& recorded : brought[i]) {
        if (recorded.is(Kind::region) || recorded.is(Kind::fragment)) span = {i, i, {}};
        span.events.push_back(recorded);
        span.last = i;
        if (recorded.is(Kind::region_end) || recorded.is(Kind::fragment_end))
          pieces.push_back(span);
      }
  }

  std::vector<Bytes> frames;
  std::vector<Events> brought;
  std::vector<Span> pieces;
};

// The events that must arrive from the kept frames, and the report.
void check_arrival(const Sent& sent, const std::vector<bool>& is_kept, const Received& arrival) {
  std::vector<Events> expected;
  for (const Sent::Span& span : sent.pieces)
    if (std::all_of(is_kept.begin() + static_cast<std::ptrdiff_t>(span.first),
                    is_kept.begin() + static_cast<std::ptrdiff_t>(span.last) + 1,
                    [](bool kept) { return kept; }))
      expected.push_back(span.events);
  CHECK(pieces_of(arrival.events) == expected);
  CHECK(arrival.report.regions + arrival.report.fragments == expected.size());
  const auto kept = static_cast<uint64_t>(std::count(is_kept.begin(), is_kept.end(), true));
  CHECK(arrival.report.packets == kept);
  CHECK(arrival.report.is_complete() == (kept == is_kept.size()));
  if (!is_kept.back()) return;  // later packets are unknown
  CHECK(arrival.report.lost_pieces == sent.pieces.size() - expected.size());
  if (arrival.report.has_header) CHECK(arrival.report.lost_packets == is_kept.size() - kept);
}

void check_kept(const Sent& sent, const std::vector<bool>& is_kept, size_t portion = 0) {
  Bytes stream;
  for (size_t i = 0; i < sent.frames.size(); ++i)
    if (is_kept[i]) stream.insert(stream.end(), sent.frames[i].begin(), sent.frames[i].end());
  check_arrival(sent, is_kept, decode(stream, portion));
}

void check_without(const Sent& sent, size_t first, size_t count) {
  INFO("first ", first, ", count ", count);
  std::vector<bool> is_kept(sent.frames.size(), true);
  for (size_t i = first; i < first + count; ++i) is_kept[i] = false;
  check_kept(sent, is_kept);
}

// Small packets, large regions in parts, fragments and marks, and several headers.
Events long_events(uint32_t regions) {
  Script script;
  Chance chance(5);
  for (uint32_t i = 0; i < regions; ++i) {
    if (i % 9 == 4) {
      add_ragged_fragment(script, chance, 150, 1000);
      for (uint32_t fragment = 0; fragment < i; fragment += 9)
        add_ragged_fragment(script, chance, 3, 5);
    }
    add_ragged_region(script, chance, i % 5 == 0 ? 300 : 30, 1000);
    if (i % 3 == 0) script.layer(i);
    if (i % 17 == 0) script.skipped(i, 3, true);
  }
  return script.finish().events;
}

// A stream with a packet for every region.
std::vector<Bytes> packets_of_one_region(uint32_t regions) {
  Script script;
  for (uint32_t i = 0; i < regions; ++i)
    script.region(up).square({1, 2 * static_cast<int32_t>(i % 999), 0}, 1 + i % 50).region_end();
  Line line;
  Encoder encoder;
  reference::require_ok(begin_stream(encoder, any_header(), line.output()));
  for (const RecordedEvent& recorded : script.finish().events) {
    encode_all(encoder, {recorded});
    if (recorded.is(Kind::region_end) && encoder.flush() != Status::ok)
      throw std::runtime_error("a busy line");
  }
  return frames_of(line.bytes);
}

bool is_known(const Sent& sent, const Events& piece) {
  return std::any_of(sent.pieces.begin(), sent.pieces.end(),
                     [&](const Sent::Span& span) { return span.events == piece; });
}

const Sent& long_stream() {
  static const Sent sent(long_events(500));
  return sent;
}

}  // namespace

TEST_CASE("a single lost packet is counted, and only its contents are lost") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const Sent sent(sample.events, sample.header);
    const size_t stride = (1 + sent.frames.size() / 60) * reference::step(3);
    for (size_t i = 0; i < sent.frames.size(); i += stride) check_without(sent, i, 1);
    check_without(sent, sent.frames.size() - 1, 1);
  }
}

TEST_CASE("any run of lost packets before others is counted") {
  const Sent& sent = long_stream();
  const size_t total = sent.frames.size();
  REQUIRE(total > 600);
  const size_t after = detail::wire::header_interval + 2;  // one of them is a header
  for (const size_t count :
       {2U, 5U, 64U, 65U, 127U, 128U, 129U, 130U, 200U, 255U, 256U, 257U, 300U, 511U, 512U})
    for (size_t first = 0; first + count + after < total;
         first += (1 + total / 17) * reference::step(5))
      check_without(sent, first, count);
}

TEST_CASE("up to 127 packets lost before the trailer are counted") {
  const Sent& sent = long_stream();
  for (size_t count = 1; count < 128; count += 3 * reference::step(5))
    check_without(sent, sent.frames.size() - 1 - count, count);
}

TEST_CASE("a loss of 256 packets within a huge region is detected") {
  Script script;
  Chance chance(1);
  add_ragged_region(script, chance, 40000, 1000);
  const Sent sent(script.finish().events);
  REQUIRE(sent.frames.size() > 600);
  for (const size_t count : {256U, 257U, 300U, 512U}) check_without(sent, 67, count);
}

TEST_CASE("pieces in packets lost before the trailer are counted") {
  const Sent& sent = long_stream();
  for (size_t count = 128; count < sent.frames.size() - 1; count += 13 * reference::step(3)) {
    std::vector<Bytes> kept(sent.frames.begin(),
                            sent.frames.end() - static_cast<std::ptrdiff_t>(count) - 1);
    kept.push_back(sent.frames.back());
    const Received arrival = decode(joined(kept));
    CHECK(arrival.report.lost_pieces + arrival.report.regions + arrival.report.fragments ==
          sent.pieces.size());
    CHECK_FALSE(arrival.report.is_complete());
    CHECK(arrival.report.lost_packets % 256 == count % 256);
  }
}

TEST_CASE("the trailer reports exactly the number of pieces lost before the trailer") {
  std::vector<Bytes> frames = frames_of(encode(Script().finish().events));
  REQUIRE(frames.size() == 2);
  for (const uint32_t regions : {0U, 1U, 32767U, 32768U, 40000U, 65535U, 65536U, 1000000U})
    for (const uint32_t fragments : {1U, 32768U, 70000U}) {
      Packet trailer = packet_of(frames[1]);
      trailer.pieces = static_cast<uint16_t>(regions + fragments);
      // After the number of slices and the flag. The fragments are the seventh total.
      uint8_t* const totals = trailer.payload.data() + 4 + 1;
      detail::wire::put_long(totals + 3 * 8, regions);
      detail::wire::put_long(totals + 6 * 8, fragments);
      frames[1] = frame_of(trailer);
      const Received arrival = decode(joined(frames));
      CHECK(arrival.report.totals.regions == regions);
      CHECK(arrival.report.totals.fragments == fragments);
      CHECK(arrival.report.lost_pieces == regions + fragments);
      CHECK_FALSE(arrival.report.is_complete());
    }
}

TEST_CASE("a late receiver counts the packets and regions before its start") {
  const Sent& sent = long_stream();
  for (size_t first = 1; first + detail::wire::header_interval < sent.frames.size();
       first += 11 * reference::step(3))
    check_without(sent, 0, first);
}

TEST_CASE("a late receiver decodes all packets from its first one, for any count of pieces") {
  const Sample sample = samples()[4];
  for (const uint32_t before : {1U, 32767U, 32768U, 65000U}) {
    CAPTURE(before);
    std::vector<Bytes> frames = frames_of(encode(sample.events, sample.header));
    frames.erase(frames.begin());
    frames.pop_back();
    for (Bytes& frame : frames) {
      Packet packet = packet_of(frame);
      packet.pieces = static_cast<uint16_t>(packet.pieces + before);
      frame = frame_of(packet);
    }
    const Received arrival = decode(joined(frames));
    CHECK(arrival.report.packets == frames.size());
    CHECK(arrival.report.lost_pieces == before);
    CHECK(pieces_of(arrival.events) == pieces_of(sample.events));
  }
}

TEST_CASE("all lost packets are counted in any mixture of losses") {
  Chance chance(1);
  const Sent& sent = long_stream();
  for (uint32_t round = 0; round < 60; round += reference::step(3)) {
    CAPTURE(round);
    std::vector<bool> is_kept(sent.frames.size(), true);
    const uint32_t percent = chance.below(60);
    for (size_t i = 0; i + 1 < is_kept.size(); ++i) is_kept[i] = chance.below(100) >= percent;
    check_kept(sent, is_kept, chance.below(90));
  }
}

TEST_CASE("repeated packets are decoded once") {
  const Sent& sent = long_stream();
  const std::vector<bool> all(sent.frames.size(), true);
  for (const size_t back : {0U, 1U, 2U, 60U, 126U, 200U, 300U}) {
    CAPTURE(back);
    Bytes stream;
    for (size_t i = 0; i < sent.frames.size(); ++i) {
      const Bytes& frame = sent.frames[i];
      stream.insert(stream.end(), frame.begin(), frame.end());
      if (i < back || i % 7 != 0) continue;
      const Bytes& old = sent.frames[i - back];
      stream.insert(stream.end(), old.begin(), old.end());
    }
    const Received arrival = decode(stream);
    check_arrival(sent, all, arrival);
    CHECK(arrival.report.repeated_packets > 80);
  }
}

TEST_CASE("the later of two swapped packets is decoded, and the other counts as lost") {
  const Sent& sent = long_stream();
  for (size_t apart = 1; apart < 100; apart += 14)
    for (size_t i = 1; i + apart + 1 < sent.frames.size(); i += 53 * reference::step(5)) {
      INFO("apart ", apart, ", i ", i);
      // Packet i arrives too late, after packet i + apart.
      std::vector<Bytes> frames = sent.frames;
      std::rotate(frames.begin() + static_cast<std::ptrdiff_t>(i),
                  frames.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  frames.begin() + static_cast<std::ptrdiff_t>(i + apart) + 1);
      std::vector<bool> is_kept(frames.size(), true);
      is_kept[i] = false;
      const Received arrival = decode(joined(frames));
      check_arrival(sent, is_kept, arrival);
      CHECK(arrival.report.repeated_packets == 1);
    }
}

TEST_CASE("a stream cut off and restarted yields no repeated or wrong region") {
  const Sent& sent = long_stream();
  for (size_t cut = 1; cut < sent.frames.size(); cut += 37 * reference::step(3)) {
    CAPTURE(cut);
    const auto at = sent.frames.begin() + static_cast<std::ptrdiff_t>(cut);
    std::vector<Bytes> frames(sent.frames.begin(), at);
    frames.insert(frames.end(), sent.frames.begin(), sent.frames.end());
    check_arrival(sent, std::vector<bool>(sent.frames.size(), true), decode(joined(frames)));
  }
}

TEST_CASE("two spliced streams yield regions of each stream and no mixed regions") {
  const Sent& first = long_stream();
  const Sent second(long_events(77));
  for (size_t cut = 1; cut < first.frames.size(); cut += 97)
    for (size_t from = 0; from < second.frames.size(); from += 29 * reference::step(5)) {
      const auto end = first.frames.begin() + static_cast<std::ptrdiff_t>(cut);
      std::vector<Bytes> frames(first.frames.begin(), end);
      frames.insert(frames.end(), second.frames.begin() + static_cast<std::ptrdiff_t>(from),
                    second.frames.end());
      // A region in parts may be open at the cut. If the numbers match there, the cut is invisible.
      if (static_cast<uint8_t>(from - cut) == 0) continue;
      for (const Events& piece : pieces_of(decode(joined(frames)).events))
        CHECK((is_known(first, piece) || is_known(second, piece)));
    }
}

TEST_CASE(
    "two interleaved streams yield unmixed regions, and a complete result is of one stream only") {
  // Each region fits a packet. The owner of the next part of a region in parts is undefined.
  const Sample round = sample_of("", reference::ball({20, 20, 20}, {19, 19, 19}, 70));
  const Sample noise = sample_of("", reference::random({13, 11, 9}, 128, 1));
  const Sent first(round.events, round.header);
  const Sent second(noise.events, noise.header);
  Chance chance(8);
  for (uint32_t order = 0; order < 400; order += reference::step(3)) {
    CAPTURE(order);
    // Runs of losses, from single packets to most of a stream.
    const uint32_t longest = 1 + chance.below(1 + order / 8);
    std::vector<Bytes> frames;
    for (size_t a = 0, b = 0; a < first.frames.size() || b < second.frames.size();) {
      for (uint32_t i = chance.below(longest + 1); i > 0 && a < first.frames.size(); --i)
        frames.push_back(first.frames[a++]);
      for (uint32_t i = chance.below(longest + 1); i > 0 && b < second.frames.size(); --i)
        frames.push_back(second.frames[b++]);
    }
    const Received arrival = decode(joined(frames));
    const std::vector<Events> regions = pieces_of(arrival.events);
    for (const Events& region : regions)
      CHECK((is_known(first, region) || is_known(second, region)));
    if (!arrival.report.is_complete()) continue;
    CHECK((regions == pieces_of(round.events) || regions == pieces_of(noise.events)));
  }
}

TEST_CASE("losses are counted beyond 65,536 packets and regions") {
  const Sent sent(packets_of_one_region(66500));
  REQUIRE(sent.frames.size() > 66500);
  REQUIRE(sent.pieces.size() == 66500);
  std::vector<bool> is_kept(sent.frames.size(), true);
  for (size_t i = 777; i + 2 < is_kept.size(); i += 1111) is_kept[i] = false;
  std::fill_n(is_kept.begin() + 65400, 300, false);
  check_kept(sent, is_kept);
}
