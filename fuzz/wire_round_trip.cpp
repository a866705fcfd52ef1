// Fuzz target. Any small volume in any memory, and any script of events within the limits of the
// format, is decoded unchanged, with normals or without. After losses the events that arrive are a
// part of those sent, and the missing ones are counted.
//
//   fuzz_wire_round_trip -max_len=400 corpus/wire_round_trip      with libFuzzer
//   fuzz_wire_round_trip corpus/wire_round_trip                   with replay_main.cpp
#include "input.hpp"
#include "little_memory.hpp"
#include "oracle/stream_samples.hpp"
#include "require.hpp"
#include "small_volume.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;

namespace {

Events read_scan(Input& input, StreamHeader& header) {
  reference::Plan plan;
  const uint32_t flags = input.byte();
  plan.border = (flags & 1) != 0 ? Border::open : Border::closed;
  const Capacities capacities = read_little_memory(input);
  const BitVolume volume = read_small_volume(input, {12, 8, 6});
  header = header_of(volume, plan.border);
  const Events events = events_of(volume, capacities, plan);
  return (flags & 4) != 0 ? with_loose_fragments(events, 1 + flags / 8) : events;
}

void read_runs(Input& input, Script& script, Incidence incidence) {
  const uint32_t count = 1 + (input.below(8) == 0 ? input.byte() : input.below(8));
  const uint32_t directions = direction_count(incidence);
  for (uint32_t i = 0; i < count; ++i) {
    const auto direction = static_cast<Direction>(input.below(directions));
    script.run(direction, 1 + input.number(Run::max_length - 1));
  }
}

Vertex read_start(Input& input) {
  Vertex start{static_cast<int32_t>(input.number(UINT32_MAX)),
               static_cast<int32_t>(input.number(UINT32_MAX)),
               -static_cast<int32_t>(input.number(INT32_MAX))};
  if (((start.x ^ start.y ^ start.z) & 1) == 0) start.x ^= 1;
  return start;
}

// Events that follow the grammar, without any other meaning.
Events read_script(Input& input) {
  Script script;
  uint32_t slice = 0;
  while (!input.is_empty()) {
    auto incidence = static_cast<Incidence>(input.below(26));
    if (incidence >= no_incidence) ++incidence;
    const uint32_t kind = input.below(8);
    if (kind == 0) {
      slice += input.number(1000000);
      script.layer(slice);
    } else if (kind == 1) {
      script.skipped(input.number(UINT32_MAX - 1), input.number(UINT32_MAX - 1), kind % 2 == 1);
    } else if (kind == 2) {
      const Vertex start = read_start(input);
      script.fragment(incidence, start,
                      static_cast<Direction>(input.below(direction_count(incidence))));
      read_runs(input, script, incidence);
      script.fragment_end();
    } else if (kind == 3) {
      script.region(up).square(read_start(input), 1 + input.number(70000)).region_end();
    } else {
      script.region(incidence);
      const uint32_t rings = 1 + (input.below(4) == 0 ? input.below(40) : 0);
      for (uint32_t ring = 0; ring < rings; ++ring) {
        script.ring(read_start(input), ring > 0);
        read_runs(input, script, incidence);
      }
      script.region_end();
    }
  }
  return script.finish().events;
}

// Adds normals to some runs, near that of the run before or arbitrary.
void add_normals(Input& input, Events& events) {
  uint8_t u = 1, v = 0;
  for (RecordedEvent& recorded : events) {
    if (!recorded.is(Event::Kind::run) || input.is_empty()) continue;
    const uint32_t kind = input.byte();
    u = static_cast<uint8_t>(kind < 200 ? u + kind % 8 : input.byte());
    v = static_cast<uint8_t>(kind < 200 ? v - kind / 8 % 8 : input.byte());
    Event event = recorded.event();
    if (u != 0) event.normal = {u, v};
    recorded = RecordedEvent(event);
  }
}

// The remaining events of a stream with lost packets are a part of it, and the rest is counted.
void check_losses(const Bytes& stream, const std::vector<Events>& sent, uint32_t pattern) {
  Bytes left;
  uint32_t at = 0;
  const std::vector<Bytes> frames = frames_of(stream);
  for (const Bytes& frame : frames) {
    ++at;
    if ((pattern >> at % 8 & 1) != 0 && at != frames.size()) continue;
    left.insert(left.end(), frame.begin(), frame.end());
  }
  const Received arrival = decode(left);
  const std::vector<Events> arrived = pieces_of(arrival.events);
  size_t place = 0;
  for (const Events& piece : arrived) {
    while (place < sent.size() && sent[place] != piece) ++place;
    require(place++ < sent.size(), "a region or fragment that was never sent");
  }
  require(arrival.report.lost_pieces == sent.size() - arrived.size(), "losses not counted");
  require(arrival.report.is_complete() == (left.size() == stream.size()), "a loss not noticed");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  const uint32_t flags = input.byte();
  const size_t portion = size_t{1} + input.below(32);
  const uint32_t pattern = input.byte();
  StreamHeader header = any_header();
  Events events = (flags & 1) != 0 ? read_script(input) : read_scan(input, header);
  if ((flags & 2) != 0) add_normals(input, events);
  const Bytes stream = encode<NormalEncoder>(events, header);
  require(encode<NormalEncoder>(events, header, portion) == stream, "the output's portions show");
  const Received arrival = decode(stream);
  require(arrival.events == events, "what comes out is not what went in");
  require(arrival.report.is_complete(), "a whole stream is not complete");
  require(decode(stream, portion, true).events == events, "the input's portions show");
  check_losses(stream, pieces_of(events), pattern);
  return 0;
}
