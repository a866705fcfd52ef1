// The regions of a part as packets, and which packets a join may pass on.
#include "extraction/encoded_part.hpp"

#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc::test;
using discmc::Status;
using discmc::detail::wire::PacketKind;
using discmc::meshing::EncodedPart;

namespace {

// The stream of a volume of one part, with whole regions only.
Bytes stream_of(const Events& regions) {
  EncodedPart part;
  const discmc::StreamHeader header = any_header();
  discmc::Event start{};
  start.kind = discmc::Event::Kind::start;
  start.header = &header;
  REQUIRE(part.accept(start) == discmc::SinkResult::accepted);
  encode_all(part, regions);
  Line line;
  discmc::Encoder encoder;
  REQUIRE(begin_stream(encoder, header, line.output()) == Status::ok);
  part.append_to(encoder);
  encode_all(encoder, Script().finish().events);
  return line.bytes;
}

Script& add_small_regions(Script& script, Chance& chance, int count) {
  for (int i = 0; i < count; ++i) add_ragged_region(script, chance, 12, 1000);
  return script;
}

}  // namespace

TEST_CASE("an encoded part is decoded to the same regions") {
  Script script;
  Chance chance(5);
  add_small_regions(script, chance, 700);
  add_ragged_region(script, chance, 2000, 1000);
  add_small_regions(script, chance, 700);
  CHECK(pieces_of(decode(stream_of(script.events)).events) == pieces_of(script.events));
}

TEST_CASE("an encoded part without regions has no packets") {
  CHECK(frames_of(stream_of({})).size() == 2);
}

TEST_CASE(
    "packets of an encoded part contain whole regions, unless a region is longer than a packet") {
  using Kind = discmc::Event::Kind;
  Script script;
  Chance chance(5);
  add_small_regions(script, chance, 100);
  add_ragged_region(script, chance, 2000, 1000);
  add_small_regions(script, chance, 100);
  const std::vector<Bytes> frames = frames_of(stream_of(script.events));
  const std::vector<Events> brought = events_by_frame(frames);
  std::size_t whole = 0, others = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Packet packet = packet_of(frames[i]);
    const bool is_whole = packet.is(PacketKind::whole_regions);
    if (!is_whole && !packet.is(PacketKind::records)) continue;
    const bool has_room =
        is_whole || packet.payload.size() <= discmc::detail::wire::max_whole_regions;
    CHECK(is_whole == (has_room && brought[i].front().is(Kind::region) &&
                       brought[i].back().is(Kind::region_end)));
    ++(is_whole ? whole : others);
  }
  CHECK(whole > 10);
  CHECK(others > 10);
}
