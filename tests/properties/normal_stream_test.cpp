// Normals in streams: the decoder delivers the encoder's normals, and a receiver without normals
// decodes the rest unchanged.
#include <discmc/normal_extractor.hpp>
#include <discmc/stream/record_writing.hpp>

#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using namespace discmc::test;

namespace {

using Kind = Event::Kind;

Bytes encode_normals(const Events& events, size_t bytes_at_once = 0) {
  return encode<NormalEncoder>(events, any_header(), bytes_at_once);
}

// Returns the events with normals for the runs, made by `normal_of(number of the run)`.
template <class NormalOf>
Events with_normals(const Events& events, NormalOf normal_of) {
  Events result;
  uint32_t runs = 0;
  for (const RecordedEvent& recorded : events) {
    Event event = recorded.event();
    if (recorded.is(Kind::run)) event.normal = normal_of(runs++);
    result.emplace_back(event);
  }
  return result;
}

Events pressed(const BitVolume& volume) {
  return events_of(volume, Capacities{200, 12}, {});
}

// A run of a ring that alternates between two directions.
Run run_to_and_fro(uint32_t i) {
  return Run::straight(static_cast<Direction>(4 * (i % 2)), 1 + i / 2 % 5);
}

void add_region(Script& script, uint32_t runs) {
  script.region(up).ring({1, 0, 0});
  for (uint32_t i = 0; i < runs; ++i) script.run(run_to_and_fro(i));
  script.region_end();
}

// Regions of one ring with 2 to 200 runs: whole, or in parts.
Events long_rings() {
  Script script;
  for (uint32_t runs = 2; runs <= 200; runs += 6) add_region(script, runs);
  return script.events;
}

const OctahedralNormal none{0, 0};

// ---- handwritten payloads ----

void add_region(Payload& payload, uint32_t runs = 2) {
  detail::stream::Record record;
  record.begin(up);
  record.add_ring({1, 0, 0});
  for (uint32_t i = 0; i < runs; ++i) record.add_run(run_to_and_fro(i));
  record.is_last = true;
  REQUIRE(encode_region(payload.model, record));
}

// lacking: the number of announced bytes that are missing at the end.
void add_normals(Payload& payload, uint32_t type, const Bytes& bytes, uint32_t lacking = 0) {
  payload.model.record_kind(detail::stream::RecordKind::extension);
  payload.model.raw_bits(8, type);
  payload.model.raw_bits(8, static_cast<uint32_t>(bytes.size()) + lacking);
  for (const uint8_t byte : bytes) payload.model.raw_bits(8, byte);
}

using List = std::vector<std::vector<int>>;

// Returns the normals of the runs in packets of records with these payloads.
List normals_of(const std::vector<Bytes>& payloads) {
  Bytes stream = frames_of(encode({}))[0];
  uint8_t number = 0;
  for (const Bytes& payload : payloads)
    for (const uint8_t byte : frame_of({2, ++number, 0, payload})) stream.push_back(byte);
  List normals;
  for (const RecordedEvent& recorded : decode(stream).events)
    if (recorded.is(Kind::run))
      normals.push_back({recorded.event().normal.u, recorded.event().normal.v});
  return normals;
}

}  // namespace

TEST_CASE("normals with any differences are decoded unchanged, in whole regions and in parts") {
  Chance chance(5);
  const Events balls = events_of(ball({20, 20, 20}, {19, 19, 19}, 64));
  const Events noise = pressed(random({20, 16, 9}, 128, 6));
  for (const Events& events : {balls, noise, long_rings()})
    for (uint32_t spread = 0; spread <= 256; spread = spread * 2 + 1)
      for (const size_t bytes_at_once : {size_t{0}, size_t{7}}) {
        uint8_t u = 100, v = 200;
        const Events sent = with_normals(events, [&](uint32_t) {
          u = static_cast<uint8_t>(u + chance.below(spread + 1) - spread / 2);
          v = static_cast<uint8_t>(v + chance.below(spread + 1) - spread / 2);
          return u == 0 ? none : OctahedralNormal{u, v};
        });
        const Received arrival = decode(encode_normals(sent, bytes_at_once), 0, bytes_at_once > 0);
        REQUIRE(arrival.report.damaged_packets == 0);
        REQUIRE(arrival.report.lost_packets == 0);
        REQUIRE(arrival.events == sent);
      }
}

TEST_CASE("a missing normal among other normals is decoded as missing") {
  const Events events = pressed(random({20, 16, 9}, 128, 7));
  Chance chance(8);
  const Events with_gaps = with_normals(events, [&](uint32_t) {
    const auto u = static_cast<uint8_t>(1 + chance.below(255));
    return chance.below(3) == 0 ? none : OctahedralNormal{u, chance.byte()};
  });
  CHECK(decode(encode_normals(with_gaps)).events == with_gaps);
}

TEST_CASE("both encoders write the same bytes for events without normals") {
  const Events events = pressed(random({20, 16, 9}, 128, 9));
  CHECK(encode_normals(events) == encode(events));
}

TEST_CASE("an encoder with normals disabled omits only the normals") {
  const Events plain = pressed(random({20, 16, 9}, 128, 10));
  const Events sent = with_normals(plain, [](uint32_t i) {
    return OctahedralNormal{static_cast<uint8_t>(1 + i % 255), 77};
  });
  CHECK(encode(sent) == encode(plain));
}

TEST_CASE("a normal belongs only to the next record") {
  Payload payload;
  SUBCASE("normals, then two regions") {
    add_normals(payload, 1, {5, 6});  // differences of 0 bits
    add_region(payload);
    add_region(payload);
    CHECK(normals_of({payload.finish()}) == List{{5, 6}, {5, 6}, {0, 0}, {0, 0}});
  }
  SUBCASE("a layer mark between normals and region") {
    add_normals(payload, 1, {5, 6});
    payload.model.record_kind(detail::stream::RecordKind::layer);
    payload.model.layer(3);
    add_region(payload);
    CHECK(normals_of({payload.finish()}) == List{{0, 0}, {0, 0}});
  }
  SUBCASE("fewer normals than runs, and an extension of another type") {
    add_normals(payload, 9, {5, 6});
    add_region(payload);
    add_normals(payload, 10, {1, 2, 3});
    add_region(payload);
    add_normals(payload, 0, {1, 2, 3});
    add_region(payload);
    add_normals(payload, 3, {});
    add_region(payload);
    CHECK(normals_of({payload.finish()}) ==
          List{{5, 6}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}});
  }
  SUBCASE("differences of four bits, and more normals than runs") {
    add_normals(payload, 5, {100, 100, 0x21, 0xFF, 0xFF});  // +1 -1, then more than the runs
    add_region(payload);
    CHECK(normals_of({payload.finish()}) == List{{100, 100}, {101, 99}});
  }
  SUBCASE("an empty list of normals, for any second byte") {
    add_normals(payload, 1, {0, 6});
    add_region(payload);
    CHECK(normals_of({payload.finish()}) == List{{0, 0}, {0, 0}});
  }
  SUBCASE("more normals than a record has runs") {
    Bytes bytes(200, 0xFF);
    bytes[0] = bytes[1] = 96;  // one less in each, so that the first surplus difference is missing
    add_normals(payload, 2, bytes);
    add_region(payload);
    CHECK(normals_of({payload.finish()}) == List{{96, 96}, {95, 95}});
  }
  SUBCASE("too few bytes for the first") {
    add_normals(payload, 3, {0xFF});
    add_region(payload);
    CHECK(normals_of({payload.finish()}) == List{{0, 0}, {0, 0}});
  }
  SUBCASE("repeated normals: the later list counts") {
    add_normals(payload, 1, {1, 2});
    add_normals(payload, 1, {5, 6});
    add_region(payload);
    CHECK(normals_of({payload.finish()}) == List{{5, 6}, {5, 6}});
  }
  SUBCASE("the packet ends before the record") {
    Payload broken;
    add_normals(broken, 1, {5, 6}, 200);
    add_region(payload);
    CHECK(normals_of({broken.close(), payload.finish()}) == List{{0, 0}, {0, 0}});
  }
}

TEST_CASE("normals use as few bits as their largest difference needs, without an extra byte") {
  Script script;
  Payload payload;
  std::vector<OctahedralNormal> normals;
  const auto add = [&](const std::vector<OctahedralNormal>& run_normals, uint32_t type,
                       const Bytes& bytes) {
    const auto runs = static_cast<uint32_t>(run_normals.size());
    normals.insert(normals.end(), run_normals.begin(), run_normals.end());
    add_region(script, runs);
    add_normals(payload, type, bytes);
    add_region(payload, runs);
  };
  add({{9, 8}, {9, 8}, {9, 8}, {9, 8}}, 1, {9, 8});
  add({{100, 100}, {101, 99}}, 3, {100, 100, 0x90});  // +1 -1, and zeros
  add({{100, 100}, {105, 98}}, 5, {100, 100, 0xA3});  // +5 -2
  const Events sent = with_normals(script.events, [&](uint32_t run) { return normals[run]; });
  CHECK(packet_of(frames_of(encode_normals(sent))[1]).payload == payload.finish());
}

TEST_CASE("normals are decoded unchanged in records that exceed a packet") {
  Chance chance(13);
  const Events sent = with_normals(monstrous_events(), [&](uint32_t) {
    return OctahedralNormal{static_cast<uint8_t>(1 + chance.below(255)), chance.byte()};
  });
  CHECK(decode(encode_normals(sent)).events == sent);
}

TEST_CASE("the stream of an extractor with normals is decoded unchanged") {
  const Limits limits{24, 20};
  const Capacities capacities{300, 20};
  Chance chance(12);
  std::vector<uint8_t> samples(24 * 20 * 10);
  for (uint8_t& sample : samples) sample = chance.byte();
  for (size_t i = 1; i + 24 < samples.size(); ++i)
    samples[i] = static_cast<uint8_t>((samples[i - 1] + samples[i] + samples[i + 24]) / 3);
  Block block(detail::sizing::bytes_for<uint16_t, detail::trace::GradientIntake<uint8_t>>(
      limits, capacities));
  EventLog log;
  NormalExtractor16<uint8_t> extractor;
  require_ok(extractor.start(limits, capacities, 120, block.memory(), make_sink(log)));
  push_all(extractor, samples);
  finish_all(extractor);
  CHECK(decode(encode_normals(log.events)).events == log.events);
}
