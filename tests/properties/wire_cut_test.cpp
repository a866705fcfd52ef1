// A stream that ends at any byte, as in a power failure. Everything that is certain has been
// delivered, and nothing else.
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::Collector;
using reference::LayerMark;
using reference::Region;

namespace {

// Decodes a stream byte by byte, each from a block of its own, so that address sanitizers detect
// reads beyond. Calls check() before every byte. Its arguments: the bytes and events so far, the
// report of a stream that ends there, and whether an open piece was reported as lost.
template <class Check>
Events decode_cutting(const Bytes& stream, Check check) {
  EventLog log;
  Decoder decoder;
  reference::require_ok(decoder.start(make_sink(log)));
  for (size_t count = 0; count < stream.size(); ++count) {
    // A copy is valid here, because a decoder that waits for bytes has no pointers to itself.
    Decoder cut;
    std::memcpy(static_cast<void*>(&cut), &decoder, sizeof cut);
    const size_t event_count = log.events.size();
    reference::require_ok(cut.finish());
    const bool is_lost = log.events.size() > event_count;
    log.events.erase(log.events.begin() + static_cast<std::ptrdiff_t>(event_count),
                     log.events.end());
    check(count, log.events, cut.report(), is_lost);
    const Bytes one(1, stream[count]);
    reference::require_ok(decoder.push(one.data(), 1).status);
  }
  CHECK(decoder.report().is_complete());
  return log.events;
}

int32_t top_of(const Region& region) {
  int32_t top = INT32_MIN;
  for (const reference::Ring& ring : region.rings)
    for (const Vertex& vertex : ring) top = std::max(top, vertex.z);
  return top;
}

// By slice: the number of regions that must have arrived at its mark, so that no region below it is
// missing.
std::vector<size_t> regions_by_mark(const Collector& whole) {
  std::vector<size_t> needed(whole.layers().size(), 0);
  for (const LayerMark& mark : whole.layers())
    for (size_t i = 0; i < whole.regions().size(); ++i)
      if (top_of(whole.regions()[i]) < 2 * static_cast<int32_t>(mark.slice))
        needed[mark.slice] = i + 1;
  return needed;
}

}  // namespace

TEST_CASE("a stream truncated at any byte is incomplete and yields all pieces that arrived whole") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const std::vector<Bytes> frames = frames_of(encode(sample.events, sample.header));
    const std::vector<Events> brought = events_by_frame(frames);
    size_t frame = 0, end = 0, whole = 0;
    const Events decoded = decode_cutting(
        joined(frames),
        [&](size_t count, const Events& events, const StreamReport& report, bool is_lost) {
          if (count == end + frames[frame].size()) {
            end = count;
            whole += brought[frame++].size();
          }
          CAPTURE(count);
          REQUIRE(events.size() == whole);
          REQUIRE_FALSE(report.is_complete());
          REQUIRE(report.damaged_packets == (count == end ? 0 : 1));
          REQUIRE(report.packets == frame);
          const bool is_open = whole > 0 && !events.back().is(Event::Kind::region_end) &&
                               !events.back().is(Event::Kind::fragment_end) &&
                               !events.back().is(Event::Kind::layer) &&
                               !events.back().is(Event::Kind::skipped);
          REQUIRE(is_lost == is_open);
        });
    CHECK(decoded == sample.events);
  }
}

TEST_CASE("a scan truncated at any byte yields every region below the last layer mark") {
  size_t certain = 0;
  for (const Sample& sample : samples()) {
    if (sample.name == "monstrous records") continue;  // no surface
    CAPTURE(sample.name);
    const Collector whole = collected(sample.events);
    const std::vector<size_t> needed = regions_by_mark(whole);
    Collector arrived;
    size_t collected_events = 0, compared = 0;
    decode_cutting(encode(sample.events, sample.header),
                   [&](size_t count, const Events& events, const StreamReport& report, bool) {
                     for (; collected_events < events.size(); ++collected_events)
                       (void)arrived.accept(events[collected_events].event());
                     CAPTURE(count);
                     REQUIRE(arrived.regions().size() == report.regions);
                     for (; compared < arrived.regions().size(); ++compared)
                       REQUIRE(arrived.regions()[compared] == whole.regions()[compared]);
                     if (arrived.layers().empty()) return;
                     REQUIRE(compared >= needed[arrived.layers().back().slice]);
                   });
    if (!needed.empty()) certain += needed.back();
  }
  CHECK(certain > 1000);
}
