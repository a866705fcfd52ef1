// Fuzz target. The promise: on any bytes, as they are and as packets of version 1 under a correct
// checksum, the reader of streams finds out the version, nothing faults or goes on for ever or
// takes much memory, the events keep to their grammar, every region told has rings of runs, and
// what is called complete has all regions.
//
//   fuzz_version1 -max_len=1200 corpus/version1      with libFuzzer
//   fuzz_version1 corpus/version1                    with replay_main.cpp

#include <sstream>
#include <stdexcept>

#include "oracle/event_log.hpp"
#include "oracle/version1_packets.hpp"
#include "require.hpp"
#include "streams/stream_file.hpp"
#include "streams/version1/decoder.hpp"

using namespace discmc;
using reference::EventLog;
using reference::Events;
using reference::RecordedEvent;
using test::version1::Bytes;
using Kind = Event::Kind;

namespace {

// Cuts the bytes into packets, each led by its length, kind, number and count of regions.
Bytes framed(const uint8_t* data, size_t size) {
  Bytes stream = test::version1::frame_of(test::version1::any_header());
  for (size_t at = 0; at + 4 <= size;) {
    test::version1::Packet packet;
    const size_t left = size - at - 4;
    const size_t count = data[at] < left ? data[at] : left;
    // Mostly what an encoder would say of a packet, so that its records are looked at.
    packet.kind = data[at + 1] < 192 ? 2 : data[at + 1] % 5;
    packet.number = static_cast<uint8_t>(data[at + 2] + (at + 1) / 64);
    packet.regions = data[at + 3];
    packet.payload.assign(data + at + 4, data + at + 4 + count);
    if (count <= test::version1::max_payload) {
      const Bytes frame = test::version1::frame_of(packet);
      stream.insert(stream.end(), frame.begin(), frame.end());
    }
    at += 4 + count;
  }
  return stream;
}

void check_grammar(const Events& events, const StreamReport& report) {
  bool is_in_region = false;
  uint64_t regions = 0, rings = 0, runs_of_ring = 0;
  for (const RecordedEvent& event : events) {
    const bool ends_ring = rings > 0 && (event.is(Kind::ring) || event.is(Kind::region_end));
    require(!ends_ring || runs_of_ring > 0, "a ring without runs");
    require(!event.is(Kind::fragment) && !event.is(Kind::fragment_end), "a loose fragment");
    const bool is_of_region = event.is(Kind::ring) || event.is(Kind::run) ||
                              event.is(Kind::region_end) || event.is(Kind::lost);
    require(is_of_region == is_in_region, "an event out of its place");
    if (event.is(Kind::region)) rings = 0;
    if (event.is(Kind::ring)) ++rings, runs_of_ring = 0;
    if (event.is(Kind::run)) {
      require(rings > 0, "a run in no ring");
      ++runs_of_ring;
    }
    if (event.is(Kind::region_end)) ++regions;
    is_in_region = event.is(Kind::region) || event.is(Kind::ring) || event.is(Kind::run);
  }
  require(!is_in_region, "a region without end");
  require(regions == report.regions, "the report counts other regions");
  require(!report.is_complete() || regions == report.totals.regions, "complete, and regions lack");
}

struct Told {
  Events events;
  StreamReport report;
};

Told decode_version1(const Bytes& stream, size_t portion, size_t most_bytes) {
  EventLog log;
  host::version1::Decoder decoder(sink_to(log), most_bytes);
  Status status = Status::ok;
  for (size_t at = 0; at < stream.size() && status == Status::ok; at += portion) {
    const size_t left = stream.size() - at;
    status = decoder.push(stream.data() + at, left < portion ? left : portion);
  }
  decoder.finish();
  check_grammar(log.events, decoder.report());
  return {log.events, decoder.report()};
}

void check(const Bytes& stream, size_t portion) {
  const Told whole =
      decode_version1(stream, stream.size() + 1, host::version1::Decoder::default_most_bytes);
  const Told again = decode_version1(stream, portion, host::version1::Decoder::default_most_bytes);
  require(again.events == whole.events, "portions show");
  require(again.report.lost_pieces == whole.report.lost_pieces, "the report depends on them");
  decode_version1(stream, portion, 64 * portion);  // little memory

  EventLog log;
  host::StreamReader reader(sink_to(log));
  std::istringstream in(std::string(stream.begin(), stream.end()));
  try {
    reader.read(in);
  } catch (const std::runtime_error&) {
    return;  // of a version that is not known
  }
  require(reader.report().bytes == stream.size(), "bytes that were not read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const size_t portion = size_t{1} + data[0] % 16;
  check({data + 1, data + size}, portion);
  check(framed(data + 1, size - 1), portion);
  return 0;
}
