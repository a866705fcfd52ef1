// Fuzz target. The decoder accepts any bytes, as they are and as packets under a correct checksum,
// so that the decoder of regions receives hostile bits. It never faults and always ends, and the
// events follow their grammar. Portions and refusals do not change the events. An encoder accepts
// all of them.
//
//   fuzz_wire_decode -max_len=1200 corpus/wire_decode      with libFuzzer
//   fuzz_wire_decode corpus/wire_decode                    with replay_main.cpp

#include "oracle/stream.hpp"
#include "require.hpp"

using namespace discmc;
using namespace discmc::test;

namespace {

// Cuts the bytes into packets. Each begins with its length, kind, number and count of pieces.
Bytes framed(const uint8_t* data, size_t size) {
  Bytes stream;
  for (size_t at = 0; at + 4 <= size;) {
    Packet packet;
    const size_t left = size - at - 4;
    const size_t count = data[at] < left ? data[at] : left;
    // Mostly the packet kind of an encoder, so that records are decoded.
    packet.kind = data[at + 1] < 192 ? 2 : data[at + 1] % 8;
    packet.number = static_cast<uint8_t>(data[at + 2] + (at + 1) / 64);
    packet.pieces = data[at + 3];
    packet.payload.assign(data + at + 4, data + at + 4 + count);
    if (count <= detail::wire::max_payload) {
      const Bytes frame = frame_of(packet);
      stream.insert(stream.end(), frame.begin(), frame.end());
    }
    at += 4 + count;
  }
  return stream;
}

// The events of a decoder that passes packets of whole regions on to an encoder.
Events events_beside_packets(const Bytes& stream) {
  Line line;
  Encoder encoder;
  require(begin_stream(encoder, any_header(), line.output()) == Status::ok, "no stream begins");
  EventLog log;
  Decoder decoder;
  require(decoder.start(make_sink(log)) == Status::ok, "no decoder starts");
  decoder.set_packet_passthrough({&encoder, [](void* to, const RecordsPacket& packet) {
                                    const Status status = static_cast<Encoder*>(to)->append(packet);
                                    require(status == Status::ok, "a packet is not taken");
                                  }});
  static_cast<void>(decoder.push(stream.data(), stream.size()));
  static_cast<void>(decoder.finish());
  return log.events;
}

void check(const Bytes& stream, size_t portion) {
  const Received arrival = decode(stream);
  const std::vector<Events> pieces = pieces_of(arrival.events);
  require(pieces.size() == arrival.report.regions + arrival.report.fragments,
          "the report counts other pieces");
  const Received again = decode(stream, portion, true);
  require(again.events == arrival.events, "portions or refusals show");
  require(again.report.lost_pieces == arrival.report.lost_pieces, "the report depends on them");
  static_cast<void>(pieces_of(events_beside_packets(stream)));  // throws on grammar errors
  const Bytes copy = encode<NormalEncoder>(arrival.events);
  for (const Bytes& frame : frames_of(copy))
    require(frame.size() <= detail::wire::max_frame, "a frame too long");
  require(pieces_of(decode(copy).events) == pieces, "a copy has other pieces");
  require(encode<NormalEncoder>(arrival.events, any_header(), portion) == copy,
          "the output's portions show");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const size_t portion = size_t{1} + data[0] % 16;
  check({data + 1, data + size}, portion);
  check(framed(data + 1, size - 1), portion);
  return 0;
}
