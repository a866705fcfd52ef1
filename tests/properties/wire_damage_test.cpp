// Bytes that no encoder wrote: flipped, random, or hostile with a correct checksum. None does harm,
// and none is accepted as valid.
#include "oracle/stream_samples.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using Kind = Event::Kind;

namespace {

// Decodes, checks the grammar, and encodes the events. An encoder must accept all events of a
// decoder and encode them unchanged.
Received survive(const Bytes& bytes, size_t portion = 0) {
  const Received arrival = decode(bytes, portion);
  const std::vector<Events> pieces = pieces_of(arrival.events);
  CHECK(pieces.size() == arrival.report.regions + arrival.report.fragments);
  const Bytes again = encode<NormalEncoder>(arrival.events);  // hostile bytes may contain normals
  for (const Bytes& frame : frames_of(again)) CHECK(frame.size() <= detail::wire::max_frame);
  CHECK(pieces_of(decode(again).events) == pieces);
  return arrival;
}

// Whether `part` is `whole` without some of its pieces.
bool is_subsequence(const std::vector<Events>& part, const std::vector<Events>& whole) {
  size_t at = 0;
  for (const Events& piece : part) {
    while (at < whole.size() && whole[at] != piece) ++at;
    if (at++ == whole.size()) return false;
  }
  return true;
}

Bytes random_bytes(Chance& chance, size_t count) {
  const uint32_t most = 1 + chance.below(256);
  Bytes bytes(count);
  for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(chance.below(most));
  return bytes;
}

void mutate(Chance& chance, Bytes& bytes) {
  const uint32_t changes = 1 + chance.below(4);
  for (uint32_t i = 0; i < changes && !bytes.empty(); ++i) {
    uint8_t& byte = bytes[chance.below(static_cast<uint32_t>(bytes.size()))];
    const uint32_t way = chance.below(4);
    if (way == 0) byte = chance.byte();
    if (way == 1) byte = static_cast<uint8_t>(byte ^ 1 << chance.below(8));
    if (way == 2) bytes.resize(chance.below(static_cast<uint32_t>(bytes.size()) + 1));
    if (way == 3 && bytes.size() < detail::wire::max_payload) bytes.push_back(chance.byte());
  }
}

// Small streams with more than one packet of records.
std::vector<Sample> small_samples() {
  Script script;
  Chance chance(3);
  add_ragged_region(script, chance, 150, 1000);
  script.fragment(up, {1, 0, 0}, 3).run(1, 2).fragment_end().layer(1);
  add_ragged_fragment(script, chance, 100, 1000);
  script.skipped(2, 0, true).layer(2);
  std::vector<Sample> small{{"parts and marks", any_header(), script.finish().events}};
  for (const Sample& sample : samples())
    if (encode(sample.events, sample.header).size() < 1000) small.push_back(sample);
  small.push_back(sample_of("noise", reference::random({5, 5, 5}, 128, 3)));
  return small;
}

}  // namespace

TEST_CASE("a flipped bit anywhere is detected and loses only its own packet") {
  for (const Sample& sample : small_samples()) {
    CAPTURE(sample.name);
    const Bytes stream = encode(sample.events, sample.header);
    const std::vector<Events> sent = pieces_of(sample.events);
    for (size_t bit = 0; bit < 8 * stream.size(); bit += reference::step(5)) {
      CAPTURE(bit);
      Bytes flipped = stream;
      flipped[bit / 8] = static_cast<uint8_t>(flipped[bit / 8] ^ 1 << bit % 8);
      const Received arrival = decode(flipped);
      REQUIRE_FALSE(arrival.report.is_complete());
      CHECK(arrival.report.damaged_packets >= 1);
      const std::vector<Events> arrived = pieces_of(arrival.events);
      REQUIRE(is_subsequence(arrived, sent));
      if (arrival.report.has_trailer)
        REQUIRE(arrival.report.lost_pieces == sent.size() - arrived.size());
    }
  }
}

TEST_CASE("a burst of errors anywhere is detected") {
  Chance chance(1);
  for (const Sample& sample : small_samples()) {
    CAPTURE(sample.name);
    const Bytes stream = encode(sample.events, sample.header);
    const std::vector<Events> sent = pieces_of(sample.events);
    for (int round = 0; round < 2000; ++round) {
      Bytes burst = stream;
      const uint32_t at = chance.below(static_cast<uint32_t>(burst.size()));
      const uint32_t end =
          std::min(at + 1 + chance.below(300), static_cast<uint32_t>(burst.size()));
      for (uint32_t i = at; i < end; ++i) burst[i] = chance.below(4) == 0 ? 0 : chance.byte();
      if (burst == stream) continue;
      const Received arrival = decode(burst);
      CHECK_FALSE(arrival.report.is_complete());
      CHECK(is_subsequence(pieces_of(arrival.events), sent));
    }
  }
}

TEST_CASE("a decoder rejects random bytes") {
  Chance chance(2);
  for (int round = 0; round < 2000; ++round) {
    const Received arrival = survive(random_bytes(chance, chance.below(1500)), chance.below(5));
    CHECK(arrival.events.empty());
    CHECK(arrival.report.packets == 0);
  }
}

TEST_CASE(
    "decoding random payloads with a correct checksum terminates and yields only valid events") {
  Chance chance(3);
  size_t events = 0;
  for (int round = 0; round < 1500; ++round) {
    Bytes stream;
    for (uint8_t number = 0; number < 8; ++number) {
      const Bytes payload = random_bytes(chance, chance.below(detail::wire::max_payload + 1));
      const uint8_t kind = chance.below(5) == 0 ? chance.byte() : 2;
      const auto pieces = static_cast<uint16_t>(chance.below(3) == 0 ? chance.next() : 0);
      const Bytes frame =
          frame_of({kind, chance.below(4) == 0 ? chance.byte() : number, pieces, payload});
      stream.insert(stream.end(), frame.begin(), frame.end());
    }
    events += survive(stream).events.size();
  }
  CHECK(events > 10000);
}

TEST_CASE(
    "decoding modified packets with a correct checksum terminates and yields only valid events") {
  Chance chance(4);
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    std::vector<Bytes> frames = frames_of(encode(sample.events, sample.header));
    if (frames.size() > 12) frames.erase(frames.begin() + 6, frames.end() - 6);
    for (int round = 0; round < 60; ++round) {
      CAPTURE(round);
      std::vector<Bytes> changed = frames;
      for (Bytes& frame : changed) {
        Packet packet = packet_of(frame);
        if (chance.below(2) == 0) mutate(chance, packet.payload);
        if (chance.below(12) == 0) packet.number = chance.byte();
        if (chance.below(12) == 0) packet.pieces = static_cast<uint16_t>(chance.next());
        if (chance.below(20) == 0) packet.kind = static_cast<uint8_t>(chance.below(5));
        frame = frame_of(packet);
      }
      survive(joined(changed));
    }
  }
}

TEST_CASE("decoding hostile payloads with cheap decisions terminates") {
  Chance chance(5);
  for (int round = 0; round < 300; ++round) {
    // All ones or all zeros select the most or least likely decisions.
    Bytes payload(detail::wire::max_payload, chance.below(2) == 0 ? 0xFF : 0);
    for (uint32_t i = chance.below(6); i > 0; --i) payload[chance.below(8)] = chance.byte();
    const Received arrival = survive(frame_of({2, 0, 0, payload}));
    CHECK(arrival.events.size() < 400000);
  }
}

TEST_CASE("frames of any length with a correct checksum are safe, even above the maximum") {
  Chance chance(6);
  for (size_t count = 0; count <= detail::wire::max_payload + 1; ++count)
    for (uint8_t kind = 0; kind < 5; ++kind) {
      const Received arrival = survive(frame_of({kind, 0, 0, random_bytes(chance, count)}));
      CHECK(arrival.report.packets + arrival.report.damaged_packets >= 1);
      if (count > detail::wire::max_payload) CHECK(arrival.report.packets == 0);
    }
  Bytes endless(100000, 0x77);
  endless.push_back(0);
  CHECK(survive(endless).report.damaged_packets == 1);
}
