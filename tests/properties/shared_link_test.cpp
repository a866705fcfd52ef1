// Streams that share a link are separated, and a mixture is never accepted as a single stream.
#include <discmc/byte_output.hpp>
#include <discmc/normal_extractor.hpp>
#include <discmc/receiver.hpp>
#include <discmc/surface_group.hpp>

#include "oracle/slice_stream.hpp"
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;

using reference::BitVolume;
using reference::require_ok;

namespace {

StreamHeader named(const BitVolume& volume, uint16_t scan, uint8_t channel) {
  StreamHeader header = header_of(volume);
  header.scan = scan;
  header.channel = channel;
  return header;
}

// Alternates the frames of two streams.
Bytes mixed(const Bytes& first, const Bytes& second) {
  const std::vector<Bytes> a = frames_of(first), b = frames_of(second);
  std::vector<Bytes> frames;
  for (size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i < a.size()) frames.push_back(a[i]);
    if (i < b.size()) frames.push_back(b[i]);
  }
  return joined(frames);
}

Bytes slices_of(const StreamHeader& header, const BitVolume& volume) {
  Line line;
  StartedSliceEncoder encoder(header, line.output());
  require_ok(encoder.push(volume.on.data(), static_cast<uint32_t>(volume.voxels())).status);
  require_ok(encoder.finish());
  return line.bytes;
}

/// Returns the scans that a receiver reports.
struct ReportedScan {
  Events events;
  StreamReport report;
};

std::vector<ReportedScan> scans_on(uint8_t channel, const Bytes& link, size_t chunk,
                                   EventLog::Refuses refuses = {}) {
  std::vector<ReportedScan> scans;
  EventLog log(std::move(refuses));
  Bytes memory(Receiver::minimum_bytes({20, 20}) + 100000);
  Receiver receiver;
  require_ok(receiver.start(memory_of(memory), make_sink(log), channel));
  for (size_t at = 0; at < link.size();) {
    const size_t left = link.size() - at;
    Decoded decoded = receiver.push(link.data() + at, std::min(chunk, left));
    at += decoded.bytes;
    while (decoded.status == Status::suspended) decoded.status = receiver.resume();
    if (decoded.status == Status::finished) {
      scans.push_back({log.events, receiver.report()});
      log.events.clear();
      continue;
    }
    require_ok(decoded.status);
  }
  until_done([&] { return receiver.finish(); });
  if (!log.events.empty()) scans.push_back({log.events, receiver.report()});
  return scans;
}

// Extractors of threshold 1 in a group, each with a log.
template <uint32_t count>
struct Group {
  explicit Group(const Limits& limits) : surfaces(extractors, count, limits.width) {
    for (uint32_t i = 0; i < count; ++i) {
      memory[i].resize(5000);
      require_ok(extractors[i].start(limits, 1, memory_of(memory[i]), make_sink(logs[i])));
    }
  }
  Bytes memory[count];
  EventLog logs[count];
  Extractor16 extractors[count];
  SurfaceGroup<Extractor16> surfaces;
};

const BitVolume first_volume = reference::random({20, 20, 20}, 40, 1);
const BitVolume second_volume = reference::random({20, 20, 20}, 40, 2);

}  // namespace

TEST_CASE("a decoder of two mixed scans receives the first scan completely") {
  const Events first = events_of(first_volume);
  const Bytes link = mixed(encode(first, named(first_volume, 7, 0)),
                           encode(events_of(second_volume), named(second_volume, 8, 0)));
  const Received received = decode(link);
  CHECK(received.events == first);
  CHECK(received.header.scan == 7);
  CHECK(received.report.is_complete());
  CHECK(received.report.foreign_packets > 10);
  CHECK(received.report.lost_packets == 0);
  CHECK(received.report.repeated_packets == 0);
}

TEST_CASE("two mixed scans with equal numbers never form a complete surface") {
  uint32_t mixtures = 0;
  for (uint32_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const BitVolume one = reference::random({5, 5, 5}, 60, 2 * seed);
    const BitVolume other = reference::random({5, 5, 5}, 60, 2 * seed + 1);
    const std::vector<Bytes> a = frames_of(encode(events_of(one), header_of(one)));
    const std::vector<Bytes> b = frames_of(encode(events_of(other), header_of(other)));
    if (a.size() != b.size()) continue;
    // Each packet is from either stream, but not all are from one.
    Chance chance(seed);
    for (int tries = 0; tries < 50; ++tries) {
      std::vector<Bytes> frames;
      size_t of_a = 0;
      for (size_t i = 0; i < a.size(); ++i) {
        const bool is_a = chance.below(2) == 0;
        of_a += is_a && i > 0;
        frames.push_back(is_a ? a[i] : b[i]);
      }
      if (of_a == 0 || of_a == frames.size() - 1) continue;
      CHECK_FALSE(decode(joined(frames)).report.is_complete());
      ++mixtures;
    }
  }
  CHECK(mixtures > 200);
}

TEST_CASE("the digest detects packets of another scan even if all packet numbers match") {
  // The same volume except for one voxel in the middle, so all numbers agree.
  BitVolume other = first_volume;
  other.on[other.voxels() / 2] ^= 1;
  std::vector<Bytes> frames = frames_of(slices_of(header_of(first_volume), first_volume));
  const std::vector<Bytes> others = frames_of(slices_of(header_of(other), other));
  REQUIRE(frames.size() == others.size());
  REQUIRE(frames.size() > 4);
  const ReceivedRows whole = decode_slices(joined(frames), {20, 20, 20});
  CHECK(whole.report.is_complete());
  frames[frames.size() - 2] = others[frames.size() - 2];
  const ReceivedRows received = decode_slices(joined(frames), {20, 20, 20});
  CHECK(received.report.lost_packets == 0);
  CHECK(received.report.is_mixed);
  CHECK_FALSE(received.report.is_complete());
}

TEST_CASE("three channels of one link are separated, for any kind of stream") {
  const BitVolume volumes[] = {first_volume, second_volume,
                               reference::ball({20, 20, 20}, {20, 20, 20}, 300)};
  const Bytes link = mixed(mixed(encode(events_of(volumes[0]), named(volumes[0], 7, 0)),
                                 encode(events_of(volumes[1]), named(volumes[1], 7, 1))),
                           slices_of(named(volumes[2], 7, 63), volumes[2]));
  for (const uint8_t channel : {uint8_t{0}, uint8_t{1}}) {
    const Received received = decode(link, 0, false, channel);
    CHECK(received.events == events_of(volumes[channel]));
    CHECK(received.header.channel == channel);
    CHECK(received.report.is_complete());
  }
  const Received slices = decode_surface(link, {20, 20}, 0, false, 63);
  CHECK(slices.status == Status::ok);
  CHECK(slices.events == events_of(volumes[2]));
  CHECK(slices.report.is_complete());
  const Received nothing = decode(link, 0, false, 2);
  CHECK(nothing.events.empty());
  CHECK_FALSE(nothing.report.has_header);
}

TEST_CASE("a scan of which only the header arrives is received") {
  std::vector<Bytes> frames = frames_of(encode(events_of(first_volume), named(first_volume, 7, 0)));
  frames.pop_back();  // without its trailer, the first scan ends when the next header arrives
  frames.push_back(frames_of(encode(events_of(second_volume), named(second_volume, 8, 0))).front());
  const Bytes link = joined(frames);
  EventLog log;
  Receiver receiver;
  require_ok(receiver.start({}, make_sink(log)));
  const Decoded decoded = receiver.push(link.data(), link.size());
  CHECK(decoded.status == Status::finished);
  CHECK(decoded.bytes == link.size());
  CHECK(receiver.header().scan == 7);
  CHECK(log.starts.size() == 1);
  require_ok(receiver.finish());
  CHECK(receiver.header().scan == 8);
  CHECK(receiver.report().packets == 1);
  CHECK(log.starts.size() == 2);
}

TEST_CASE("an encoder increments the scan number for each further scan") {
  const BitVolume voxel = reference::from_bits({1, 1, 1}, 1);
  Line line;
  Encoder encoder;
  require_ok(encoder.start({1, {}, 65534, 9}, line.output()));
  Bytes memory(2000);
  Extractor16 extractor;
  require_ok(extractor.start({1, 1}, 1, memory_of(memory), make_sink(encoder)));
  for (const uint16_t scan : {uint16_t{65534}, uint16_t{65535}, uint16_t{0}}) {
    reference::push_all(extractor, voxel.on);
    reference::finish_all(extractor);
    const Received received = decode(line.bytes);
    CHECK(received.report.is_complete());
    CHECK(received.header.scan == scan);
    CHECK(received.header.channel == 9);
    line.bytes.clear();
    require_ok(extractor.reset());
  }
}

TEST_CASE("the header contains the extractor's limits and threshold, and the values of the label") {
  Line line;
  Encoder encoder;
  require_ok(encoder.start({5, {1000, -2000, 3000}, 77, 3}, line.output()));
  Bytes memory(20000);
  Extractor16 extractor;
  require_ok(extractor.start({40, 30, Border::open}, -9, memory_of(memory), make_sink(encoder)));
  CHECK(encoder.flush() == Status::ok);
  EventLog log;
  Decoder decoder;
  require_ok(decoder.start(make_sink(log)));
  require_ok(decoder.push(line.bytes.data(), line.bytes.size()).status);
  const StreamHeader expected{40, 30, 5, {1000, -2000, 3000}, {-9}, Border::open, 3, 77};
  CHECK(reference::are_equal(decoder.header(), expected));
  REQUIRE(log.starts.size() == 1);
  CHECK(reference::are_equal(log.starts[0], expected));
}

TEST_CASE("a stream has the spacing set at its extractor") {
  using Normals = detail::trace::GradientIntake<uint8_t>;
  Line line;
  discmc::test::NormalEncoder encoder;
  require_ok(encoder.start({0, {5, 5, 5}}, line.output()));
  Bytes memory(detail::sizing::minimum_bytes<uint16_t, Normals>({8, 8}));
  NormalExtractor16<uint8_t> extractor;
  extractor.set_spacing({1000, 2000, -3000});
  require_ok(extractor.start({8, 8}, 1, memory_of(memory), make_sink(encoder)));
  CHECK(encoder.flush() == Status::ok);
  const StreamHeader header = decode(line.bytes).header;
  CHECK(header.spacing_nm[0] == 1000);
  CHECK(header.spacing_nm[1] == 2000);
  CHECK(header.spacing_nm[2] == -3000);
}

TEST_CASE("several surfaces of a scan share a link frame by frame, even if the link is busy") {
  constexpr int32_t thresholds[] = {60, 90, 200};
  const reference::Size size{20, 16, 12};
  Bytes samples;
  Chance chance(9);
  for (uint32_t i = 0; i < size.width * size.height * size.depth; ++i)
    samples.push_back(chance.byte());
  for (const size_t bytes_at_once : {size_t{0}, size_t{1}, size_t{7}, size_t{300}}) {
    CAPTURE(bytes_at_once);
    Line line(bytes_at_once);
    SharedOutput link;
    Encoder encoders[3];
    Extractor16 extractors[3];
    Bytes memory[3];
    link.start(line.output());
    for (uint8_t i = 0; i < 3; ++i) {
      memory[i].resize(20000 + 30000U * i);
      require_ok(encoders[i].start({size.depth, {}, 4, i}, link.output()));
      require_ok(extractors[i].start({size.width, size.height}, thresholds[i], memory_of(memory[i]),
                                     make_sink(encoders[i])));
    }
    SurfaceGroup<Extractor16> surfaces(extractors, 3, size.width);
    const auto all = static_cast<uint32_t>(samples.size());
    for (uint32_t pushed = 0; pushed < all;) {
      const uint32_t some = std::min(all - pushed, 1 + chance.below(50));
      const PushResult result = surfaces.push(&samples[pushed], some);
      REQUIRE((result.status == Status::ok || result.status == Status::suspended));
      pushed += result.samples;
    }
    reference::finish_all(surfaces);
    while (link.flush() == Status::suspended) continue;
    for (uint8_t i = 0; i < 3; ++i) {
      BitVolume volume(size);
      for (uint32_t at = 0; at < all; ++at) volume.on[at] = samples[at] >= thresholds[i] ? 1 : 0;
      const Received received = decode(line.bytes, 0, false, i);
      CHECK(received.report.is_complete());
      CHECK(received.header.thresholds[0] == thresholds[i]);
      EventLog alone;
      reference::scan_into<uint16_t>(alone, volume, {}, uint64_t{memory[i].size()});
      CHECK(received.events == alone.events);
    }
  }
}

TEST_CASE("a group pushes rows of bits and skips rows for all of its extractors") {
  const Limits limits{9, 2};
  Group<2> group(limits);
  EventLog alone[2];
  const uint8_t bits[] = {0xF0, 1, 0x18, 0};
  CHECK(group.surfaces.push_bits(bits).samples == 9);
  CHECK(group.surfaces.skip_row(Substitute::previous_row).samples == 9);
  CHECK(group.surfaces.push(bits, 3).samples == 3);
  const PushResult early = group.surfaces.push_bits(bits);
  CHECK(early.status == Status::row_in_progress);
  CHECK(early.samples == 0);
  CHECK(group.surfaces.finish() == Status::slice_in_progress);
  require_ok(group.surfaces.abandon());
  const PushResult late = group.surfaces.push(bits, 3);
  CHECK(late.status == Status::finished);
  CHECK(late.samples == 0);
  for (int i = 0; i < 2; ++i) {
    Bytes other(5000);
    Extractor16 extractor;
    require_ok(extractor.start(limits, 1, memory_of(other), make_sink(alone[i])));
    require_ok(extractor.push_bits(bits + 2 * i).status);
    require_ok(extractor.skip_row(Substitute::previous_row).status);
    require_ok(extractor.push(bits, 3).status);
    require_ok(extractor.abandon());
    CHECK(group.logs[i].events == alone[i].events);
  }
}

TEST_CASE("a group accepts many rows of samples at once, with a stride") {
  const BitVolume volume = reference::random({7, 5, 3}, 110, 5);
  Bytes apart(2 * volume.on.size());
  for (size_t i = 0; i < volume.on.size(); ++i) apart[2 * i] = volume.on[i];
  Group<2> group({7, 5});
  CHECK(group.surfaces.push(apart.data(), 100, 2).samples == 100);
  CHECK(group.surfaces.push(apart.data() + 200, 5, 2).samples == 5);
  require_ok(group.surfaces.finish());
  for (const EventLog& log : group.logs) CHECK(log.events == events_of(volume));
}

TEST_CASE("a group accepts contiguous rows of bits if a row has a whole number of bytes") {
  Group<2> group({8, 1});
  const uint8_t bits[] = {0x01, 0xF8, 0};
  require_ok(group.surfaces.push_bits(bits).status);
  require_ok(group.surfaces.finish());
  CHECK(group.logs[0].events == events_of(reference::from_bits({8, 1, 1}, 0x01)));
  CHECK(group.logs[1].events == events_of(reference::from_bits({8, 1, 1}, 0xF8)));
}

TEST_CASE("a group waits for any busy sink, and counts only rows accepted by all extractors") {
  const Limits limits{9, 4};
  const BitVolume noise = reference::random({9, 4, 6}, 110, 4);
  for (const size_t busy : {size_t{0}, size_t{1}, size_t{2}}) {
    CAPTURE(busy);
    Group<3> group(limits);
    group.logs[busy] = EventLog(reference::refuses_first);
    const uint8_t bits[6] = {0xAA, 0, 0xAA, 0, 0xAA, 0};
    uint32_t waits = 0;
    for (uint32_t row = 0; row < 24; ++row) {
      uint32_t pushed = 0;
      while (pushed < 9) {
        const PushResult result =
            row % 5 == 2   ? group.surfaces.push_bits(bits)
            : row % 5 == 4 ? group.surfaces.skip_row(Substitute::previous_row)
                           : group.surfaces.push(&noise.on[row * 9 + pushed], 9 - pushed);
        REQUIRE((result.status == Status::ok || result.status == Status::suspended));
        if (result.samples == 0) ++waits;
        pushed += result.samples;
      }
      REQUIRE(pushed == 9);
    }
    CHECK(waits > 20);
    reference::finish_all(group.surfaces);
    EventLog alone;
    Bytes other(5000);
    Extractor16 extractor;
    require_ok(extractor.start(limits, 1, memory_of(other), make_sink(alone)));
    for (uint32_t row = 0; row < 24; ++row)
      require_ok((row % 5 == 2   ? extractor.push_bits(bits)
                  : row % 5 == 4 ? extractor.skip_row(Substitute::previous_row)
                                 : extractor.push(&noise.on[row * 9], 9))
                     .status);
    require_ok(extractor.finish());
    for (const EventLog& log : group.logs) CHECK(log.events == alone.events);
  }
}

TEST_CASE("encoders of an unstarted shared link are unstarted") {
  SharedOutput link;
  Encoder encoder;
  CHECK(encoder.start({}, link.output()) == Status::bad_sink);
  link.start({});
  CHECK(encoder.start({}, link.output()) == Status::bad_sink);
  CHECK(link.flush() == Status::ok);
  Line line;
  link.start(line.output());
  CHECK(encoder.start({}, link.output()) == Status::ok);
}

TEST_CASE("a restarted shared link sends no earlier bytes") {
  Line line;
  SharedOutput link;
  const ByteOutput dead{nullptr, [](void*, const uint8_t*, size_t) { return size_t{0}; }};
  link.start(dead);
  const ByteOutput output = link.output();
  const uint8_t frame[] = {3, 1, 2, 0};
  CHECK(output.write(output.context, frame, 4) == 4);
  CHECK(link.flush() == Status::suspended);
  CHECK(output.write(output.context, frame, 4) == 0);
  link.start(line.output());
  CHECK(link.flush() == Status::ok);
  CHECK(line.bytes.empty());
  CHECK(output.write(output.context, frame, 4) == 4);
  CHECK(line.bytes == Bytes(frame, frame + 4));
  const Bytes longest(detail::wire::max_frame, 7);
  CHECK(output.write(output.context, longest.data(), longest.size()) == longest.size());
  CHECK(line.bytes.size() == 4 + longest.size());
}

TEST_CASE("a receiver receives scan after scan, whether or not a trailer is lost") {
  const BitVolume volumes[] = {first_volume, second_volume, second_volume, first_volume};
  constexpr size_t none = 4;
  const std::vector<Bytes> scans[] = {
      frames_of(encode(events_of(volumes[0]), named(volumes[0], 1, 0))),
      frames_of(slices_of(named(volumes[1], 2, 0), volumes[1])),
      frames_of(encode(events_of(volumes[2]), named(volumes[2], 3, 0))),
      frames_of(slices_of(named(volumes[3], 4, 0), volumes[3]))};
  for (const size_t lost : {none, size_t{0}, size_t{1}, size_t{2}})
    for (const size_t chunk : {size_t{1}, size_t{50}, size_t{100000}}) {
      INFO("lost ", lost, ", chunk ", chunk);
      Bytes link;
      for (size_t scan = 0; scan < 4; ++scan)
        for (const Bytes& frame : scans[scan])
          if (scan != lost || &frame != &scans[scan].back())
            link.insert(link.end(), frame.begin(), frame.end());
      const std::vector<ReportedScan> reported = scans_on(
          any_channel, link, chunk, chunk == 50 ? reference::refuses_first : EventLog::Refuses{});
      REQUIRE(reported.size() == 4);
      for (size_t scan = 0; scan < 4; ++scan) {
        CAPTURE(scan);
        CHECK(reported[scan].report.is_complete() == (scan != lost));
        CHECK(reported[scan].report.lost_packets == 0);
        if (scan != lost) CHECK(reported[scan].events == events_of(volumes[scan]));
      }
    }
}

TEST_CASE(
    "repeated packets of a finished scan begin no scan, but a new stream with its number does") {
  const Events events = events_of(first_volume);
  const std::vector<Bytes> first = frames_of(encode(events, named(first_volume, 1, 0)));
  const std::vector<Bytes> second = frames_of(encode(events, named(first_volume, 2, 0)));
  const std::vector<Bytes> repeated(first.begin() + 3, first.end());
  Bytes link;
  for (const auto& frames : {first, repeated, first, repeated, second})
    for (const Bytes& frame : frames) link.insert(link.end(), frame.begin(), frame.end());
  const std::vector<ReportedScan> reported = scans_on(0, link, 100);
  REQUIRE(reported.size() == 3);
  for (const ReportedScan& scan : reported) {
    CHECK(scan.events == events);
    CHECK(scan.report.is_complete());
  }
}

TEST_CASE("a receiver of any channel stays on the channel of its first packet") {
  Bytes link;
  for (uint16_t scan = 1; scan <= 3; ++scan) {
    const Bytes both = mixed(encode(events_of(first_volume), named(first_volume, scan, 5)),
                             encode(events_of(second_volume), named(second_volume, scan, 6)));
    link.insert(link.end(), both.begin(), both.end());
  }
  const std::vector<ReportedScan> reported = scans_on(any_channel, link, 1000);
  REQUIRE(reported.size() == 3);
  for (const ReportedScan& scan : reported) {
    CHECK(scan.events == events_of(first_volume));
    CHECK(scan.report.is_complete());
  }
}
