// Streams of version 1, written by the library of its time: what they tell is what it is today.
#include <algorithm>
#include <discmc/gradient_normals.hpp>
#include <discmc/plane.hpp>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "command.hpp"
#include "oracle/normal_events.hpp"
#include "oracle/ramp_ball.hpp"
#include "oracle/stream_samples.hpp"
#include "oracle/surface.hpp"
#include "oracle/thinned.hpp"
#include "oracle/version1_packets.hpp"
#include "streams/stream_file.hpp"
#include "streams/version1/decoder.hpp"

namespace {

using namespace discmc::test;
using discmc::Border;
using discmc::Event;
using discmc::StreamHeader;
using discmc::StreamReport;
using discmc::Vertex;
using discmc::host::StreamReader;
using discmc::host::VersionSearch;
using discmc::reference::ball;
using discmc::reference::BitVolume;
using discmc::reference::Collector;
using discmc::reference::random;
using discmc::reference::Region;
using Kind = Event::Kind;
namespace version1 = discmc::host::version1;
namespace mended = discmc::test::version1;

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::string golden_path(const std::string& name) {
  return DISCMC_SOURCE_DIR "/tests/golden/version1/" + name + ".dmc";
}

Bytes golden(const std::string& name) {
  std::ifstream file(golden_path(name), std::ios::binary);
  REQUIRE_MESSAGE(file, golden_path(name));
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  return {bytes.begin(), bytes.end()};
}

struct Read {
  Events events;
  StreamHeader header;
  StreamReport report;
};

// As the command reads a stream.
Read read(const Bytes& stream) {
  EventLog log;
  StreamReader reader(discmc::sink_to(log));
  std::istringstream in(text_of(stream));
  reader.read(in);
  return {log.events, reader.header(), reader.report()};
}

Read read_version1(const Bytes& stream, std::size_t most_bytes) {
  EventLog log;
  version1::Decoder decoder(discmc::sink_to(log), most_bytes);
  CHECK(decoder.push(stream.data(), stream.size()) == discmc::Status::ok);
  decoder.finish();
  return {log.events, decoder.header(), decoder.report()};
}

// The whole regions among events, lost ones left out.
std::vector<Region> whole_regions(const Events& events) {
  std::vector<Region> regions;
  Region region{0, {}};
  Vertex at{};
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    if (recorded.is(Kind::region)) region = {event.incidence, {}};
    if (recorded.is(Kind::region_end)) regions.push_back(region);
    if (recorded.is(Kind::ring)) region.rings.emplace_back();
    if (recorded.is(Kind::ring)) at = event.start;
    if (!recorded.is(Kind::run)) continue;
    for (const Vertex& vertex : discmc::reference::vertices_of(region.incidence, at, {event.run}))
      region.rings.back().push_back(vertex);
    at = discmc::after_run(region.incidence, at, event.run);
  }
  return regions;
}

std::vector<Region> simple(const std::vector<Region>& regions) {
  return canonical(discmc::reference::simple_rings(regions));
}

bool are_among(const std::vector<Region>& regions, const std::vector<Region>& all) {
  return std::all_of(regions.begin(), regions.end(), [&](const Region& region) {
    return std::find(all.begin(), all.end(), region) != all.end();
  });
}

// Whether a ring is the other, wherever it begins.
bool is_turned(discmc::reference::Ring ring, const discmc::reference::Ring& other) {
  if (ring.size() != other.size()) return false;
  ring.insert(ring.end(), other.size(), Vertex{});
  std::copy_n(ring.begin(), other.size(), ring.end() - static_cast<std::ptrdiff_t>(other.size()));
  return std::search(ring.begin(), ring.end(), other.begin(), other.end()) != ring.end();
}

std::vector<Sample> volumes() {
  const BitVolume round = ball({14, 14, 14}, {13, 13, 13}, 36);
  const BitVolume gaps = random({9, 8, 7}, 128, 5), short_scan = random({9, 8, 7}, 128, 6);
  const BitVolume bar = discmc::reference::box({32766, 1, 1}, {0, 0, 0}, {32765, 0, 0});
  return {sample_of("ball", round),
          sample_of("open", random({9, 8, 7}, 90, 7), Border::open),
          sample_of("sieve", sieve(25)),
          sample_of("sieve_fragments", sieve(17)),
          sample_of("bar", bar),
          sample_of("fragments", random({5, 4, 4}, 128, 3)),
          sample_of("noise", random({17, 14, 9}, 128, 1994)),
          sample_of("spiral", discmc::reference::spiral({70, 70, 2})),
          {"skipped", header_of(gaps), events_with_gaps(gaps, 0)},
          {"abandoned", header_of(short_scan), events_with_gaps(short_scan, 38)}};
}

void check_header(const StreamHeader& a, const StreamHeader& b) {
  CHECK(a.width == b.width);
  CHECK(a.height == b.height);
  CHECK(a.depth == b.depth);
  CHECK(std::equal(a.spacing_nm, a.spacing_nm + 3, b.spacing_nm));
  CHECK(a.threshold == b.threshold);
  CHECK(a.border == b.border);
}

// Of corners that have one.
std::map<std::tuple<int, int, int>, std::set<int>> normals_of(const Events& events) {
  std::map<std::tuple<int, int, int>, std::set<int>> normals;
  for_each_start(events, [&](const Vertex& at, discmc::OctahedralNormal normal, bool) {
    if (!normal.is_none()) normals[{at.x, at.y, at.z}].insert(normal.u << 8 | normal.v);
  });
  return normals;
}

struct NormalScan {
  StreamHeader header;
  Events events;
};

// A ball of samples that fall evenly, or are disturbed.
NormalScan scan_with_normals(uint32_t extent, double radius, bool is_disturbed) {
  using Normals = discmc::GradientNormals<uint8_t>;
  const auto volume = discmc::reference::ramp_ball(extent, radius, {20, 100, 255});
  std::vector<uint8_t> samples(volume.samples.begin(), volume.samples.end());
  for (std::size_t i = 0; is_disturbed && i < samples.size(); ++i)
    samples[i] = static_cast<uint8_t>(samples[i] ^ (i * i * 7 >> 3 & 31));
  NormalScan scan;
  scan.header = header_of(BitVolume({extent, extent, extent}));
  scan.header.threshold = 100;
  std::copy_n(uneven_spacing, 3, scan.header.spacing_nm);
  const discmc::Limits limits{extent, extent};
  discmc::reference::Block block(
      discmc::bytes_for<uint32_t, Normals>(limits, discmc::reference::ample));
  EventLog log;
  discmc::NormalExtractor32<uint8_t> extractor;
  extractor.set_spacing(uneven_spacing);
  discmc::reference::require_ok(
      extractor.start(limits, discmc::reference::ample, 100, block.memory(), discmc::sink_to(log)));
  discmc::reference::push_all(extractor, samples);
  discmc::reference::finish_all(extractor);
  scan.events = log.events;
  return scan;
}

// The corners of all triangles of an STL file, each triangle from its least corner on, sorted.
std::vector<std::string> triangles(const std::string& stl) {
  constexpr std::size_t head = 84, facet = 50, normal = 12, corner = 12;
  std::vector<std::string> all;
  for (std::size_t at = head; at + facet <= stl.size(); at += facet) {
    std::string turned = stl.substr(at + normal, 3 * corner);
    std::string least = turned;
    for (int i = 0; i < 2; ++i) {
      std::rotate(turned.begin(), turned.begin() + corner, turned.end());
      least = std::min(least, turned);
    }
    all.push_back(least);
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("a stream of version 1 tells the regions of today, ring for ring, and the same totals") {
  for (const Sample& sample : volumes()) {
    CAPTURE(sample.name);
    const Read then = read(golden(sample.name));
    CHECK(then.report.is_complete());
    CHECK(then.report.damaged_packets == 0);
    check_header(then.header, sample.header);
    const Collector told = discmc::reference::collected(then.events);
    const Collector today = discmc::reference::collected(sample.events);
    CHECK(describe_difference(simple(told.regions()), simple(today.regions())).empty());
    CHECK(told.split_sides() == today.split_sides());
    CHECK(discmc::reference::counts(told.statistics()) ==
          discmc::reference::counts(today.statistics()));
    CHECK(told.was_abandoned() == today.was_abandoned());
    CHECK(told.layers().size() == today.layers().size());
    REQUIRE(told.skipped().size() == today.skipped().size());
    for (std::size_t i = 0; i < told.skipped().size(); ++i) {
      CHECK(told.skipped()[i].slice == today.skipped()[i].slice);
      CHECK(told.skipped()[i].row == today.skipped()[i].row);
      CHECK(told.skipped()[i].repeated == today.skipped()[i].repeated);
    }
  }
}

TEST_CASE("its report counts the fragments that were put back") {
  CHECK(read(golden("ball")).report.fragments == 0);
  CHECK(read(golden("fragments")).report.fragments == 220);
  CHECK(read(golden("fragments")).report.totals.fragments == 220);
}

TEST_CASE(
    "where memory was too short even for fragments, regions are cut and the surface is right") {
  const Read then = read(golden("cuts"));
  CHECK(then.report.is_complete());
  const Collector told = discmc::reference::collected(then.events);
  const BitVolume volume = ball({14, 14, 14}, {13, 13, 13}, 36);
  CHECK(discmc::reference::surface_of(told.regions()) ==
        discmc::reference::surface_of_cells(volume, true));
}

TEST_CASE("its normals are those of today, at the same corners") {
  const NormalScan ramp = scan_with_normals(12, 4.6, false);
  const NormalScan disturbed = scan_with_normals(7, 2.6, true);
  const Read of_ramp = read(golden("normals")), of_disturbed = read(golden("normal_fragments"));
  CHECK(of_disturbed.report.fragments > 100);
  CHECK(normals_of(ramp.events).size() > 100);
  check_header(of_ramp.header, ramp.header);
  CHECK(normals_of(of_ramp.events) == normals_of(ramp.events));
  CHECK(normals_of(of_disturbed.events) == normals_of(disturbed.events));
}

TEST_CASE("fragments that no packet holds, one in the other, come back where they belong") {
  std::vector<discmc::Run> outer, hole;
  const auto zigzag = [](std::vector<discmc::Run>& runs, uint32_t from, uint32_t to) {
    for (uint32_t i = from; i < to; ++i)
      runs.push_back(
          discmc::Run::straight(static_cast<discmc::Direction>(4 * (i % 2)), 1 + i / 2 % 5));
  };
  outer.push_back(discmc::Run::straight(2, 5));
  zigzag(outer, 500, 700);
  zigzag(outer, 0, 500);
  zigzag(outer, 700, 730);
  outer.push_back(discmc::Run::straight(2, 70000));
  outer.push_back(discmc::Run::straight(6, 70005));
  zigzag(hole, 730, 1200);
  const Region whole{up,
                     {discmc::reference::vertices_of(up, {1, 2, 4}, outer),
                      discmc::reference::vertices_of(up, {3, 4, 4}, hole)}};

  const Read then = read(golden("long_fragments"));
  CHECK(then.report.is_complete());
  const std::vector<Region> regions = whole_regions(then.events);
  REQUIRE(regions.size() == 1);
  const Region& told = regions.front();
  REQUIRE(told.rings.size() == 2);
  CHECK(is_turned(told.rings[0], whole.rings[0]));
  CHECK(is_turned(told.rings[1], whole.rings[1]));
}

TEST_CASE("a fragment is put back into a ring of its own incidence alone") {
  using discmc::host::version1::Chain;
  using discmc::host::version1::Side;
  const auto axis = discmc::incidence_of({0, 0, 1}), corner = discmc::incidence_of({1, 1, 1});
  discmc::host::version1::Fragments fragments;
  fragments.add(7, axis, Chain(3, Side(discmc::Run::straight(7, 1))));  // no direction of a corner
  Chain chain{Side::stand_in(7)};
  CHECK_FALSE(fragments.put_back(corner, chain));
  CHECK(chain.empty());
  chain = {Side::stand_in(7)};
  CHECK(fragments.put_back(axis, chain));
  CHECK(chain.size() == 3);
  CHECK(fragments.bytes() == 0);
}

TEST_CASE("where a fragment starts its stand-in has the normal") {
  std::set<int> normals;
  for (const auto& [corner, told] : normals_of(read(golden("long_fragments")).events))
    normals.insert(told.begin(), told.end());
  const auto of_item = [](int item) { return (1 + item % 255) << 8 | item / 2 % 256; };
  constexpr int first_of_one = 1, last_of_one = 500, stand_in_for_one = 701;
  constexpr int first_of_other = 501, stand_in_for_other = 733;
  CHECK(normals.count(of_item(stand_in_for_one)) == 1);
  CHECK(normals.count(of_item(stand_in_for_other)) == 1);
  CHECK(normals.count(of_item(last_of_one)) == 1);
  CHECK(normals.count(of_item(first_of_one)) == 0);
  CHECK(normals.count(of_item(first_of_other)) == 0);
}

// ---- losses ----

TEST_CASE(
    "a stream of version 1 that ends at any byte is not complete, and is right as far as it goes") {
  const Bytes stream = golden("fragments");
  const std::vector<Region> all = whole_regions(read(stream).events);
  for (std::size_t count = 0; count < stream.size(); ++count) {
    CAPTURE(count);
    const Read part = read(Bytes(stream.data(), stream.data() + count));
    REQUIRE_FALSE(part.report.is_complete());
    const std::vector<Region> regions = whole_regions(part.events);
    REQUIRE(regions.size() == part.report.regions);
    REQUIRE(std::equal(regions.begin(), regions.end(), all.begin()));
  }
}

TEST_CASE("of a stream of version 1 with any bit changed nothing wrong is told") {
  const Bytes stream = golden("fragments");
  const std::vector<Region> all = simple(whole_regions(read(stream).events));
  for (std::size_t bit = 0; bit < 8 * stream.size(); bit += discmc::reference::step(5)) {
    CAPTURE(bit);
    Bytes changed = stream;
    changed[bit / 8] = static_cast<uint8_t>(changed[bit / 8] ^ 1 << bit % 8);
    const Read part = read(changed);
    REQUIRE_FALSE(part.report.is_complete());
    if (!part.report.has_header) continue;  // what is none of its version is not used
    REQUIRE(are_among(simple(whole_regions(part.events)), all));
  }
}

TEST_CASE("a lost packet costs the regions that have a piece in it, all of them counted at once") {
  for (const char* name : {"fragments", "sieve_fragments", "sieve", "spiral", "long_fragments"}) {
    CAPTURE(name);
    const std::vector<Bytes> frames = frames_of(golden(name));
    const std::vector<Region> all = whole_regions(read(golden(name)).events);
    for (std::size_t lost = 1; lost + 1 < frames.size(); ++lost) {
      CAPTURE(lost);
      std::vector<Bytes> others = frames;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(lost));
      const Read part = read(joined(others));
      REQUIRE(part.report.lost_packets == 1);
      REQUIRE_FALSE(part.report.is_complete());
      REQUIRE(part.report.regions + part.report.lost_pieces == all.size());
      const std::vector<Region> regions = whole_regions(part.events);
      REQUIRE(regions.size() == part.report.regions);
      REQUIRE(are_among(regions, all));
      REQUIRE(part.events.back().is(Kind::finish));
      // With one more packet than the one behind the gap, what has passed is known in full.
      if (lost + 2 >= frames.size()) continue;
      others.resize(lost + 1);
      const StreamReport then = read(joined(others)).report;
      REQUIRE(then.regions + then.lost_pieces == mended::packet_of(frames[lost + 2]).regions);
    }
  }
}

TEST_CASE("parts do not go on with another fragment or region, whatever the packets' numbers say") {
  const std::vector<Bytes> frames = frames_of(golden("long_fragments"));
  const auto fragments_in = [&](std::size_t first_frames) {
    return read(joined({frames.data(), frames.data() + first_frames})).report.fragments;
  };
  // The header and the first part of one fragment, then all from a part of the other on: its first
  // part, with which it is whole, or a later one.
  std::size_t spliced = 0;
  for (std::size_t next = 3; next + 1 < frames.size(); ++next) {
    if (fragments_in(next) != 1 || fragments_in(next + 1) != 1) continue;
    CAPTURE(next);
    Bytes stream = joined({frames[0], frames[1]});
    for (std::size_t i = next; i < frames.size(); ++i) {
      mended::Packet packet = mended::packet_of(frames[i]);
      packet.number = static_cast<uint8_t>(packet.number - (next - 2));
      for (const uint8_t byte : mended::frame_of(packet)) stream.push_back(byte);
    }
    const Read part = read(stream);
    CHECK(part.report.lost_packets == 0);
    CHECK(part.report.fragments == (fragments_in(next - 1) == 0 ? 1 : 0));
    CHECK(part.report.regions == 0);
    CHECK(part.report.lost_pieces == 1);
    CHECK_FALSE(part.report.is_complete());
    ++spliced;
  }
  CHECK(spliced > 1);
}

TEST_CASE("a region that does not go on before another record is told to be lost") {
  const std::vector<Bytes> frames = frames_of(golden("sieve"));
  const std::vector<Region> all = whole_regions(read(golden("sieve")).events);
  std::size_t told_lost = 0;
  for (std::size_t gone = 1; gone + 2 < frames.size(); ++gone) {
    // One packet is gone, and the numbers of the next hide it.
    const mended::Packet hidden = mended::packet_of(frames[gone]);
    mended::Packet next = mended::packet_of(frames[gone + 1]);
    next.number = hidden.number;
    next.regions = hidden.regions;
    std::vector<Bytes> sent(frames.data(), frames.data() + gone);
    sent.push_back(mended::frame_of(next));
    const Read part = read(joined(sent));
    for (const RecordedEvent& event : part.events) told_lost += event.is(Kind::lost) ? 1U : 0U;
    REQUIRE(are_among(whole_regions(part.events), all));
  }
  CHECK(told_lost > 0);
}

TEST_CASE("records that are cut short under a right checksum are unreadable") {
  const std::vector<Bytes> frames = frames_of(golden("ball"));
  const std::vector<Region> all = whole_regions(read(golden("ball")).events);
  std::size_t unreadable = 0, made_up = 0, lengths = 0;
  for (std::size_t i = 1; i + 1 < frames.size(); ++i)
    for (std::size_t bytes = 0; bytes < mended::packet_of(frames[i]).payload.size(); ++bytes) {
      std::vector<Bytes> cut = frames;
      mended::Packet packet = mended::packet_of(frames[i]);
      packet.payload.resize(bytes);
      cut[i] = mended::frame_of(packet);
      const Read part = read(joined(cut));
      REQUIRE_FALSE(part.report.is_complete());
      unreadable += part.report.is_unreadable ? 1U : 0U;
      const std::vector<Region> regions = whole_regions(part.events);
      made_up += static_cast<std::size_t>(
          std::count_if(regions.begin(), regions.end(),
                        [&](const Region& region) { return !are_among({region}, all); }));
      ++lengths;
    }
  CHECK(unreadable > lengths * 9 / 10);
  CHECK(made_up < 2 * lengths);  // of the four bytes of zeros that a code may end with
}

TEST_CASE("half of the numbers lie behind, and nothing follows the trailer") {
  const auto report_of = [](uint8_t number, uint16_t regions) {
    std::vector<Bytes> frames = frames_of(golden("ball"));
    mended::Packet packet = mended::packet_of(frames[1]);
    packet.kind = 9;  // not known: it is counted
    packet.number = number;
    packet.regions = regions;
    frames = {frames[0], mended::frame_of(packet)};
    return read(joined(frames)).report;
  };
  CHECK(report_of(1, 0).lost_packets == 0);
  CHECK(report_of(128, 0).lost_packets == 127);
  CHECK(report_of(129, 0).repeated_packets == 1);
  CHECK(report_of(129, 1).lost_packets == 128);
  CHECK(report_of(1, 0x7FFF).lost_pieces == 0x7FFF);
  CHECK(report_of(1, 0x8000).repeated_packets == 1);

  std::vector<Bytes> frames = frames_of(golden("ball"));
  mended::Packet more = mended::packet_of(frames[1]);
  more.number = static_cast<uint8_t>(frames.size());
  more.regions = 80;
  frames.push_back(mended::frame_of(more));
  const Read whole = read(joined(frames));
  CHECK(whole.report.is_complete());
  CHECK(whole.report.repeated_packets == 1);
  CHECK(whole.events == read(golden("ball")).events);
}

TEST_CASE("packets that come twice or late, or after the end, change nothing") {
  const std::vector<Bytes> frames = frames_of(golden("fragments"));
  std::vector<Bytes> sent;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    sent.push_back(frames[i]);
    sent.push_back(frames[i / 2]);
  }
  const Read twice = read(joined(sent));
  CHECK(twice.events == read(joined(frames)).events);
  CHECK(twice.report.is_complete());
  CHECK(twice.report.repeated_packets == frames.size());
}

TEST_CASE("a listener who is late hears what is left, and learns how much he has missed") {
  std::vector<Bytes> frames = frames_of(golden("noise"));
  frames.erase(frames.begin(), frames.begin() + 40);
  const Read late = read(joined(frames));
  CHECK(late.report.has_header);
  CHECK(late.report.lost_packets == 40);
  CHECK(late.report.regions + late.report.lost_pieces == 2876);
  CHECK(whole_regions(late.events).size() == late.report.regions);
  CHECK(late.report.regions > 500);
}

TEST_CASE("what finds no room in memory is lost, and counted") {
  for (const char* name : {"fragments", "sieve", "spiral", "long_fragments"}) {
    CAPTURE(name);
    const Read whole = read(golden(name));
    for (const uint32_t most_bytes : {0U, 300U, 1000U, 3000U, 10000U}) {
      CAPTURE(most_bytes);
      const Read part = read_version1(golden(name), most_bytes);
      REQUIRE(part.report.regions + part.report.lost_pieces == whole.report.regions);
      REQUIRE((part.report.lost_pieces > 0) == !part.report.is_complete());
      if (most_bytes == 0) REQUIRE(part.report.lost_pieces > 0);
    }
    CHECK(read_version1(golden(name), std::size_t{1} << 20).events == whole.events);
  }
}

// ---- which version ----

TEST_CASE("the first whole header decides, and what comes before it is not lost") {
  for (const Bytes& stream : {golden("fragments"), encode(volumes()[5].events)}) {
    const Read whole = read(stream);
    REQUIRE(whole.report.is_complete());
    std::vector<Bytes> frames = frames_of(stream);
    std::rotate(frames.begin(), frames.begin() + 1, frames.begin() + 3);
    const Read late = read(joined(frames));  // two packets of records, then the header
    CHECK(late.report.has_header);
    CHECK(whole_regions(late.events) == whole_regions(whole.events));
    Bytes noisy(5000, 'x');
    noisy.push_back(0);
    noisy.insert(noisy.end(), stream.begin(), stream.end());
    const Read behind_noise = read(noisy);
    CHECK(behind_noise.events == whole.events);
    CHECK(behind_noise.report.damaged_packets == 1);
    CHECK(behind_noise.report.bytes == noisy.size());
  }
}

TEST_CASE("a header of a version that is not known ends a stream of either") {
  mended::Packet packet = mended::packet_of(frames_of(golden("ball"))[0]);
  packet.payload[3] = 3;
  const Bytes unknown = mended::frame_of(packet);
  for (const Bytes& stream : {Bytes{}, golden("ball"), encode(volumes()[0].events)}) {
    std::vector<Bytes> frames = frames_of(stream);
    if (!frames.empty()) frames.pop_back();  // the trailer
    frames.push_back(unknown);
    EventLog log;
    StreamReader reader(discmc::sink_to(log));
    std::istringstream in(text_of(joined(frames)));
    CHECK_THROWS_WITH(reader.read(in),
                      "the stream is of a version that this program does not know (it knows 1 to "
                      "2): use a newer discmc");
  }
}

TEST_CASE("the search for a header ends") {
  VersionSearch search;
  std::size_t bytes = 0;
  for (; !search.is_over(); ++bytes) search.take(static_cast<uint8_t>(bytes));
  CHECK(bytes == VersionSearch::most_bytes);
  CHECK(!search.is_version1());
}

// ---- the command ----

TEST_CASE("the command takes a stream of version 1 as any other, without being told") {
  const command::Workshop workshop;
  workshop.write("then.dmc", text_of(golden("noise")));
  workshop.write("v.nrrd", random({17, 14, 9}, 128, 1994));
  workshop.done("extract v.nrrd --iso 100 -o today.dmc");
  auto then = workshop.info("then.dmc"), today = workshop.info("today.dmc");
  CHECK(then["fragments"] == "1344");
  for (const char* key : {"dimensions", "border", "regions", "rings", "holes", "links", "corners",
                          "three", "four", "more", "skipped_rows", "complete"})
    CHECK(then[key] == today[key]);
  for (const std::string name : {"then", "today"}) {
    workshop.done("decode " + name + ".dmc -o " + name + ".stl");
    workshop.done("render " + name + ".dmc -o " + name + ".png --size 30,20");
  }
  workshop.done("extract v.nrrd --iso 100 -o volume.stl");
  CHECK(workshop.read("today.stl") == workshop.read("volume.stl"));
  CHECK(!triangles(workshop.read("then.stl")).empty());
  CHECK(triangles(workshop.read("then.stl")) == triangles(workshop.read("today.stl")));
  CHECK(!workshop.read("then.png").empty());
}

TEST_CASE("packed anew it is a stream of today with the same regions and normals") {
  const command::Workshop workshop;
  for (const char* name : {"noise", "normal_fragments", "open"}) {
    CAPTURE(name);
    const Read then = read(golden(name));
    workshop.write("then.dmc", text_of(golden(name)));
    workshop.done("decode then.dmc -o anew.dmc");
    const std::string bytes = workshop.read("anew.dmc");
    const Read anew = read(Bytes(bytes.begin(), bytes.end()));
    CHECK(anew.report.is_complete());
    CHECK(anew.report.totals.fragments == 0);
    CHECK(anew.events == then.events);
    check_header(anew.header, then.header);
  }
}
