// The encoder of normals, and packets of records on their way between encoders and
// decoders, are through C what they are in C++, byte for byte.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <discmc/surface_decoder.hpp>
#include <vector>

#include "oracle/c_events.hpp"
#include "oracle/normal_events.hpp"
#include "oracle/stream_samples.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::c_sink_to;
using reference::from_c;
using reference::to_c;

namespace {

discmc_stream_label to_c(const StreamLabel& label) {
  return {label.depth,
          {label.spacing_nm[0], label.spacing_nm[1], label.spacing_nm[2]},
          label.scan,
          label.channel};
}
discmc_byte_output to_c(const ByteOutput& output) {
  return {output.context, output.write};
}

// An encoder of C in the place of one of C++.
struct NormalEncoderInC {
  discmc_normal_encoder object = {};

  Status start(const StreamLabel& label, const ByteOutput& output) {
    const discmc_stream_label in_c = to_c(label);
    return static_cast<Status>(discmc_normal_encoder_start(&object, &in_c, to_c(output)));
  }
  Answer take(const Event& event) {
    return static_cast<Answer>(discmc_normal_encoder_take(&object, reference::to_c(event)));
  }
  bool flush() { return discmc_normal_encoder_flush(&object) != 0; }
  uint64_t bytes() const { return discmc_normal_encoder_bytes(&object); }
};

// Events whose runs have normals.
Events with_normals(const Events& events) {
  Events result;
  Chance chance(5);
  for (const RecordedEvent& recorded : events) {
    Event event = recorded.event();
    if (event.kind == Event::Kind::run)
      event.normal = {static_cast<uint8_t>(1 + chance.below(255)), chance.byte()};
    result.emplace_back(event);
  }
  return result;
}

Events small_regions(uint32_t count) {
  Script script;
  Chance chance(1);
  for (uint32_t i = 0; i < count; ++i) add_ragged_region(script, chance, 12, 1000);
  return script.finish().events;
}

}  // namespace

TEST_CASE("normals are encoded through C as in C++, whenever the output takes") {
  const Events events = with_normals(monstrous_events());
  const Bytes expected = encode<NormalEncoder>(events);
  for (const size_t bytes_a_time : {size_t{0}, size_t{7}})
    CHECK(encode<NormalEncoderInC>(events, any_header(), bytes_a_time) == expected);
  CHECK(expected.size() > encode<Encoder>(events).size() + 10000);
}

TEST_CASE("a stream with normals goes on from a checkpoint, to another output, through C") {
  const Events events = with_normals(small_regions(200));
  const size_t half = events.size() / 2;
  const Bytes expected = encode<NormalEncoder>(events);
  Line first_line, second_line;
  NormalEncoderInC first, second;
  discmc_normal_encoder_checkpoint checkpoint;
  CHECK(discmc_normal_encoder_save(&first.object, &checkpoint) == DISCMC_NOT_STARTED);
  reference::require_ok(begin_stream(first, any_header(), first_line.output()));
  take_all(first, Events(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(half)));
  REQUIRE(discmc_normal_encoder_save(&first.object, &checkpoint) == DISCMC_OK);
  CHECK(discmc_normal_encoder_restore(&second.object, &checkpoint, {nullptr, nullptr}) ==
        DISCMC_BAD_SINK);
  REQUIRE(discmc_normal_encoder_restore(&second.object, &checkpoint, to_c(second_line.output())) ==
          DISCMC_OK);
  first_line.bytes.resize(second.bytes());
  take_all(second, Events(events.begin() + static_cast<std::ptrdiff_t>(half), events.end()));
  CHECK(second.flush());
  Bytes all = first_line.bytes;
  all.insert(all.end(), second_line.bytes.begin(), second_line.bytes.end());
  CHECK(all == expected);
  checkpoint.head[0] ^= 1;
  CHECK(discmc_normal_encoder_restore(&second.object, &checkpoint, to_c(second_line.output())) ==
        DISCMC_BAD_CHECKPOINT);
}

TEST_CASE("an encoder of normals tells records and changes its output through C") {
  const uint8_t told[201] = {7, 0, 9};
  const discmc_application_record record = {11, 2, 3, told, 3}, too_long = {11, 2, 3, told, 201};
  NormalEncoderInC in_c;
  NormalEncoder in_cpp;
  Line line_c, line_cpp, other_c, other_cpp;
  CHECK(discmc_normal_encoder_tell(&in_c.object, &record) == DISCMC_NOT_STARTED);
  CHECK(in_c.start({}, {}) == Status::bad_sink);
  reference::require_ok(begin_stream(in_c, any_header(), line_c.output()));
  reference::require_ok(begin_stream(in_cpp, any_header(), line_cpp.output()));
  CHECK(discmc_normal_encoder_tell(&in_c.object, &too_long) == DISCMC_BAD_RECORD);
  discmc_normal_encoder_set_output(&in_c.object, to_c(other_c.output()));
  in_cpp.set_output(other_cpp.output());
  CHECK(discmc_normal_encoder_tell(&in_c.object, &record) == DISCMC_OK);
  reference::require_ok(in_cpp.tell({11, 2, 3, told, 3}));
  CHECK(line_c.bytes == line_cpp.bytes);
  CHECK(other_c.bytes.size() > 20);
  CHECK(other_c.bytes == other_cpp.bytes);
}

// ---- packets of records ----

namespace {

struct Packets {
  std::vector<Bytes> payloads;
  std::vector<uint32_t> pieces;

  static void take(void* context, const discmc_records_packet* packet) {
    auto& packets = *static_cast<Packets*>(context);
    CHECK(packet->is_whole == 1);
    packets.payloads.emplace_back(packet->payload, packet->payload + packet->bytes);
    packets.pieces.push_back(packet->pieces);
  }
};

// A stream of regions in packets that pass from one encoder to another, and how many they are.
struct Appended {
  Bytes stream;
  size_t packets = 0;
};

template <class Append>
Appended appended(const Events& events, Append append) {
  std::vector<Packet> all;
  for (const Bytes& frame : frames_of(encode(events))) all.push_back(packet_of(frame));
  Line line;
  Appended result;
  discmc_encoder encoder = {};
  const discmc_stream_label label = {};
  REQUIRE(discmc_encoder_start(&encoder, &label, to_c(line.output())) == DISCMC_OK);
  const StreamHeader header = any_header();
  Event start{};
  start.header = &header;
  REQUIRE(discmc_encoder_take(&encoder, reference::to_c(start)) == DISCMC_TAKEN);
  for (size_t i = 0; i + 1 < all.size(); ++i) {
    if (!all[i].is(wire::PacketKind::records)) continue;
    const auto pieces = static_cast<uint16_t>(all[i + 1].pieces - all[i].pieces);
    const discmc_records_packet packet = {all[i].payload.data(), all[i].payload.size(), pieces, 1};
    REQUIRE(append(&encoder, &packet) == DISCMC_OK);
    ++result.packets;
  }
  const Event finish = events.back().event();
  REQUIRE(discmc_encoder_take(&encoder, reference::to_c(finish)) == DISCMC_TAKEN);
  result.stream = line.bytes;
  return result;
}

}  // namespace

TEST_CASE("packets of whole regions go through C from a part to a stream, and on from there") {
  const Events regions = small_regions(1000);
  const Appended sent = appended(regions, discmc_encoder_append);
  CHECK(pieces_of(decode(sent.stream).events) == pieces_of(regions));

  const auto passed_by = [&](auto& decoder, auto start, auto pass, auto push) {
    EventLog log;
    Packets packets;
    const discmc_records_packet_sink to = {&packets, Packets::take};
    const discmc_sink sink = c_sink_to(log);
    REQUIRE(start(&decoder, &sink) == DISCMC_OK);
    pass(&decoder, &to);
    REQUIRE(push(&decoder, sent.stream.data(), sent.stream.size()).status == DISCMC_OK);
    CHECK(packets.payloads.size() == sent.packets);
    CHECK(pieces_of(log.events).empty());
    CHECK(log.events.back().is(Event::Kind::finish));

    log.events.clear();
    REQUIRE(start(&decoder, &sink) == DISCMC_OK);
    pass(&decoder, nullptr);
    REQUIRE(push(&decoder, sent.stream.data(), sent.stream.size()).status == DISCMC_OK);
    CHECK(packets.payloads.size() == sent.packets);
    CHECK(pieces_of(log.events).size() == 1000);
  };
  discmc_decoder decoder = {};
  passed_by(
      decoder,
      [](discmc_decoder* of, const discmc_sink* sink) {
        return discmc_decoder_start(of, sink, DISCMC_ANY_CHANNEL);
      },
      discmc_decoder_pass_whole_regions_to, discmc_decoder_push);
  discmc_surface_decoder surface_decoder = {};
  passed_by(
      surface_decoder,
      [](discmc_surface_decoder* of, const discmc_sink* sink) {
        return discmc_surface_decoder_start(of, {nullptr, 0}, sink, DISCMC_ANY_CHANNEL);
      },
      discmc_surface_decoder_pass_whole_regions_to, discmc_surface_decoder_push);
}

TEST_CASE("a packet that cannot be sent is refused through C, by either encoder") {
  const Bytes payload(DISCMC_MAX_APPENDED + 1);
  const discmc_records_packet longest = {payload.data(), DISCMC_MAX_APPENDED, 0xFFFF, 1};
  const discmc_records_packet too_long = {payload.data(), DISCMC_MAX_APPENDED + 1, 1, 1};
  Line line;
  NormalEncoderInC normals;
  discmc_encoder plain = {};
  CHECK(discmc_encoder_append(&plain, &longest) == DISCMC_NOT_STARTED);
  CHECK(discmc_normal_encoder_append(&normals.object, &longest) == DISCMC_NOT_STARTED);
  reference::require_ok(begin_stream(normals, any_header(), line.output()));
  CHECK(discmc_normal_encoder_append(&normals.object, &too_long) == DISCMC_BAD_RECORD);
  CHECK(discmc_normal_encoder_append(&normals.object, &longest) == DISCMC_OK);
}
