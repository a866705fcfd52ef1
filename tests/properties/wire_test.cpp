// Streams as a whole: decoding returns the encoded events for any portions, and golden files fix
// the bytes.
#include "oracle/golden.hpp"
#include "oracle/stream_samples.hpp"
#include "oracle/surface.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using Kind = Event::Kind;

namespace {

uint64_t count_of(const Events& events, Kind kind) {
  return static_cast<uint64_t>(std::count_if(events.begin(), events.end(),
                                             [&](const RecordedEvent& t) { return t.is(kind); }));
}

// The surface of a stream, assembled by the tests' own collector.
reference::Surface surface_in(const Bytes& stream) {
  reference::Collector collector;
  for (const RecordedEvent& recorded : decode(stream).events)
    (void)collector.accept(recorded.event());
  return reference::surface_of(collector.regions());
}

BitVolume golden_noise() {
  return reference::random({7, 6, 5}, 100, 1994);
}

void check_golden(const char* name, const BitVolume& volume) {
  const Bytes bytes = golden_of(name, encode(events_of(volume), header_of(volume)));
  const Received arrival = decode(bytes);
  CHECK(arrival.report.is_complete());
  CHECK(reference::are_equal(arrival.header, header_of(volume)));
  CHECK(surface_in(bytes) == reference::surface_of_cells(volume, true));
}

}  // namespace

TEST_CASE(
    "the test streams contain fragments, skipped rows, holes and rings longer than a record") {
  uint64_t fragments = 0, skipped = 0, holes = 0, longest_ring = 0, runs = 0;
  for (const Sample& sample : samples()) {
    fragments += count_of(sample.events, Kind::fragment);
    skipped += count_of(sample.events, Kind::skipped);
    for (const RecordedEvent& recorded : sample.events) {
      runs = recorded.is(Kind::run) ? runs + 1 : 0;
      longest_ring = std::max(longest_ring, runs);
      holes += recorded.is(Kind::ring) && recorded.event().is_hole;
    }
    if (sample.name == "noise with fragments") CHECK(count_of(sample.events, Kind::fragment) > 50);
    if (sample.name == "a spiral, whose rings are long")
      CHECK(longest_ring > detail::stream::Record::max_words);
  }
  CHECK(fragments > 100);
  CHECK(skipped > 10);
  CHECK(holes > 200);
}

TEST_CASE("every event, the header and the totals are decoded unchanged") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const Bytes stream = encode(sample.events, sample.header);
    const Received arrival = decode(stream);
    CHECK(arrival.events == sample.events);
    CHECK(arrival.status == Status::ok);
    CHECK(reference::are_equal(arrival.header, sample.header));
    const StreamReport& report = arrival.report;
    CHECK(report.is_complete());
    CHECK(report.bytes == stream.size());
    CHECK(report.packets == frames_of(stream).size());
    CHECK(report.repeated_packets + report.damaged_packets == 0);
    CHECK(report.regions == count_of(sample.events, Kind::region_end));
    CHECK(report.slices == sample.events.back().event().slice);
    CHECK(report.is_abandoned == (sample.name == "an abandoned scan"));
    CHECK(report.totals.links == sample.events.back().event().statistics->links);
  }
}

TEST_CASE("encoding the decoded events yields the bytes of the original stream") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const Bytes stream = encode(sample.events, sample.header);
    const Received arrival = decode(stream);
    CHECK(encode(arrival.events, arrival.header) == stream);
  }
}

TEST_CASE("the bytes of a stream do not depend on the portions that the output accepts") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const Bytes stream = encode(sample.events, sample.header);
    for (const size_t bytes_at_once : {1U, 2U, 7U, 100U, 1000U}) {
      CAPTURE(bytes_at_once);
      CHECK(encode(sample.events, sample.header, bytes_at_once) == stream);
    }
  }
}

TEST_CASE("decoded events do not depend on the portions of the input or on refusals") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const Bytes stream = encode(sample.events, sample.header);
    for (const bool refuses : {false, true})
      for (const size_t portion : {0U, 1U, 2U, 63U, 256U}) {
        const Received arrival = decode(stream, portion, refuses);
        CHECK(arrival.events == sample.events);
        CHECK(arrival.report.is_complete());
        CHECK(arrival.report.bytes == stream.size());
      }
  }
}

TEST_CASE("random volumes in random memory are decoded unchanged") {
  Chance chance(1);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const BitVolume volume =
        reference::random({1 + chance.below(20), 1 + chance.below(12), 1 + chance.below(9)},
                          chance.below(257), chance.next());
    reference::Plan plan;
    plan.border = chance.below(2) == 0 ? Border::open : Border::closed;
    const Capacities capacities{minimum_capacities().slots + chance.below(1000), chance.below(20)};
    const Events events = events_of(volume, capacities, plan);
    const Bytes stream = encode(events, header_of(volume, plan.border));
    const Received arrival = decode(stream, chance.below(50));
    CHECK(arrival.events == events);
    CHECK(arrival.report.is_complete());
    CHECK(encode(events, header_of(volume, plan.border), 1 + chance.below(9)) == stream);
  }
}

TEST_CASE("headers with extreme values in every field are decoded unchanged") {
  StreamHeader header = any_header();
  header.width = Limits::max_extent;
  header.height = 1;
  header.depth = UINT32_MAX;
  header.spacing_nm[0] = INT32_MIN;
  header.spacing_nm[1] = INT32_MAX;
  header.spacing_nm[2] = -1;
  header.thresholds[0] = INT32_MIN;
  header.border = Border::open;
  CHECK(reference::are_equal(decode(encode(Script().finish().events, header)).header, header));
  header.height = Limits::max_extent;
  header.thresholds[0] = INT32_MAX;
  CHECK(reference::are_equal(decode(encode(Script().finish().events, header)).header, header));
}

TEST_CASE("the ball in DESIGN.md needs at most 9,000 bytes") {
  const BitVolume volume = reference::ball({100, 100, 100}, {100, 100, 100}, 1002);
  const Events events = events_of(volume);
  CHECK(count_of(events, Kind::region) == 2328);
  CHECK(encode(events, header_of(volume)).size() <= 9000);
}

TEST_CASE("rings in a stream begin at their last vertex, which is a corner") {
  Incidence incidence = no_incidence;
  Vertex start{0, 0, 0}, at{0, 0, 0};
  for (const RecordedEvent& recorded : events_of(golden_noise())) {
    const Event event = recorded.event();
    if (event.kind == Kind::region) incidence = event.incidence;
    if (event.kind == Kind::ring) start = at = event.start;
    if (event.kind != Kind::run) continue;
    CHECK_FALSE(precedes(start, at));
    at = at + displacement(incidence, &event.run, 1);
  }
}

TEST_CASE("a single voxel matches its golden stream") {
  check_golden("single_voxel.dmc", reference::from_bits({1, 1, 1}, 1));
}

TEST_CASE("a small random volume matches its golden stream") {
  check_golden("noise.dmc", golden_noise());
}

TEST_CASE("loose fragments match their golden stream") {
  const Events events = with_loose_fragments(events_of(golden_noise()), 3);
  CHECK(count_of(events, Kind::fragment) > 100);
  const Bytes bytes = golden_of("loose_fragments.dmc", encode(events, header_of(golden_noise())));
  CHECK(decode(bytes).events == events);
}

TEST_CASE("parts of regions, fragments and layer marks match their golden stream") {
  const Bytes stream = encode(monstrous_events());
  CHECK(stream.size() == 21928);
  CHECK(crc32(stream.data(), stream.size()) == 0x2124030A);
}

TEST_CASE("integers of one to eight bytes are read back as written, and as zeros beyond the end") {
  Bytes bytes(1 + 2 + 4 + 8);
  uint8_t* place = detail::wire::put(bytes.data(), 0xFE, 1);
  place = detail::wire::put(place, 0x1234, 2);
  place = detail::wire::put(place, 0x89ABCDEF, 4);
  place = detail::wire::put_long(place, 0x0123456789ABCDEF);
  CHECK(place == bytes.data() + bytes.size());
  CHECK(bytes == Bytes{0xFE, 0x34, 0x12, 0xEF, 0xCD, 0xAB, 0x89,  //
                       0xEF, 0xCD, 0xAB, 0x89, 0x67, 0x45, 0x23, 0x01});
  detail::wire::ByteReader reader(bytes.data(), bytes.size());
  CHECK(reader.get(1) == 0xFE);
  CHECK(reader.get(2) == 0x1234);
  CHECK(reader.get(4) == 0x89ABCDEF);
  CHECK(reader.get(8) == 0x0123456789ABCDEF);
  CHECK(reader.get(4) == 0);
  const uint8_t three[] = {1, 2, 3, 0xFF};  // the reader may read two bytes of them
  CHECK(detail::wire::ByteReader(three, 2).get(4) == 0x0201);
}
