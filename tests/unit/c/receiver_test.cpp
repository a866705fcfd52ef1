// Receivers and joiners in C deliver the same events as in C++.
#include <discmc/discmc.h>

#include <discmc/joiner.hpp>
#include <discmc/receiver.hpp>

#include "oracle/c_events.hpp"
#include "oracle/slice_config.hpp"
#include "oracle/slice_stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::Bytes;

namespace {

const BitVolume& volume() {
  static const BitVolume noise = random({20, 15, 10}, 128, 3);
  return noise;
}
constexpr discmc_limits limits = {20, 15, DISCMC_CLOSED};

// So little memory that most fragments are loose.
const Bytes& polygons() {
  static const Bytes stream =
      test::encode(test::events_of(volume(), Extractor32::default_capacities({20, 15}, 3000)),
                   test::header_of(volume()));
  return stream;
}
Bytes encoded_slices(uint8_t surface_count) {
  StreamHeader header = test::header_of(volume());
  header.surface_count = surface_count;
  int32_t next = 1;
  for (int32_t& threshold : header.thresholds) threshold = next++;
  std::vector<uint8_t> memory(20000);
  test::Line line;
  SliceEncoder encoder;
  require_ok(
      encoder.start(test::slice_config(header), {memory.data(), memory.size()}, line.output()));
  require_ok(encoder.push(volume().on.data(), static_cast<uint32_t>(volume().on.size())).status);
  require_ok(encoder.finish());
  return line.bytes;
}

struct ReceiverInC {
  ReceiverInC(const discmc_sink& sink, uint64_t bytes, uint8_t channel = DISCMC_ANY_CHANNEL)
      : memory(bytes) {
    const discmc_receiver_config config = {channel, {memory.memory().data, bytes}, sink};
    REQUIRE(discmc_receiver_start(&receiver, &config) == DISCMC_OK);
  }
  discmc_status push(const Bytes& stream, size_t chunk) {
    for (size_t at = 0; at < stream.size();) {
      const discmc_push_result result =
          discmc_receiver_push(receiver, stream.data() + at, std::min(chunk, stream.size() - at));
      at += result.accepted;
      if (result.status == DISCMC_FINISHED && at == stream.size()) return DISCMC_OK;
      if (result.status != DISCMC_OK && result.status != DISCMC_SUSPENDED) return result.status;
    }
    return completed(DISCMC_SUSPENDED, [this] { return discmc_receiver_finish(receiver); });
  }

  Block memory;
  discmc_receiver* receiver = nullptr;
};

void check_info(const discmc_receiver_info& in_c, const StreamHeader& header,
                const StreamReport& report) {
  CHECK(are_equal(from_c(in_c.header), header));
  CHECK(in_c.has_header == report.has_header);
  CHECK(in_c.has_trailer == report.has_trailer);
  CHECK(in_c.holds_slices == report.holds_slices);
  CHECK(in_c.is_abandoned == report.is_abandoned);
  CHECK(in_c.is_complete == report.is_complete());
  CHECK(in_c.is_unreadable == report.is_unreadable);
  CHECK(in_c.is_mixed == report.is_mixed);
  const std::vector<uint64_t> counts_in_c = {
      in_c.bytes,           in_c.packets,      in_c.repeated_packets, in_c.damaged_packets,
      in_c.foreign_packets, in_c.lost_packets, in_c.lost_pieces,      in_c.regions,
      in_c.fragments,       in_c.rows,         in_c.lost_rows,        in_c.total_rows,
      in_c.slices};
  const std::vector<uint64_t> counts_in_cpp = {
      report.bytes,           report.packets,      report.repeated_packets, report.damaged_packets,
      report.foreign_packets, report.lost_packets, report.lost_pieces,      report.regions,
      report.fragments,       report.rows,         report.lost_rows,        report.total_rows,
      report.slices};
  CHECK(counts_in_c == counts_in_cpp);
  CHECK(counts(from_c(in_c.totals)) == counts(report.totals));
}

void compare(const Bytes& stream, uint32_t surfaces, uint8_t channel) {
  const uint64_t spare = 1000;
  EventLog log(refuses_first), expected;
  ReceiverInC receiver(c_sink_to(log), discmc_receiver_bytes(&limits, surfaces, 0) + spare,
                       channel);
  REQUIRE(receiver.push(stream, 7) == DISCMC_OK);
  CHECK(receiver.memory.is_intact());

  std::vector<uint8_t> memory(Receiver::minimum_bytes({20, 15}, surfaces) + spare);
  Receiver decoder;
  require_ok(decoder.start({memory.data(), memory.size()}, make_sink(expected), channel));
  require_ok(test::push_stream(decoder, stream, 0));
  CHECK(log.events == expected.events);
  REQUIRE(log.starts.size() == 1);
  CHECK(are_equal(log.starts[0], expected.starts[0]));
  check_info(discmc_receiver_get_info(receiver.receiver), decoder.header(), decoder.report());
}

}  // namespace

TEST_CASE("a receiver in C delivers the events of a C++ Receiver for both kinds of streams") {
  compare(polygons(), 1, DISCMC_ANY_CHANNEL);
  compare(encoded_slices(1), 1, 0);
  compare(encoded_slices(3), 3, 1);
  Bytes cut = encoded_slices(1);
  cut.erase(cut.begin() + 300, cut.begin() + 400);
  compare(cut, 1, 0);
  cut = polygons();
  cut.erase(cut.begin() + 3000, cut.begin() + 3100);
  compare(cut, 1, 0);
}

TEST_CASE("a receiver in C accepts memory for slices late and needs no memory for polygons") {
  const Bytes stream = encoded_slices(1);
  EventLog log, expected;
  ReceiverInC receiver(c_sink_to(log), discmc_receiver_bytes(nullptr, 0, 0));
  discmc_push_result result = discmc_receiver_push(receiver.receiver, stream.data(), stream.size());
  REQUIRE(result.status == DISCMC_TOO_LITTLE_MEMORY);
  const discmc_receiver_info info = discmc_receiver_get_info(receiver.receiver);
  const discmc_limits found = {info.header.width, info.header.height, info.header.border};
  Block memory(discmc_receiver_bytes(&found, info.header.surface_count, info.header.levels));
  const discmc_memory given = {memory.memory().data, memory.memory().bytes};
  CHECK(discmc_receiver_set_memory(receiver.receiver, {given.data, 100}) ==
        DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_receiver_set_memory(receiver.receiver, given) == DISCMC_OK);
  result = discmc_receiver_push(receiver.receiver, stream.data() + result.accepted,
                                stream.size() - result.accepted);
  CHECK(result.status == DISCMC_FINISHED);
  CHECK(discmc_receiver_finish(receiver.receiver) == DISCMC_OK);
  CHECK(memory.is_intact());
  CHECK(discmc_receiver_get_info(receiver.receiver).is_complete == 1);

  ReceiverInC bare(c_sink_to(expected), discmc_receiver_bytes(nullptr, 0, 0));
  CHECK(bare.push(polygons(), 1000) == DISCMC_OK);
  CHECK(discmc_receiver_get_info(bare.receiver).is_complete == 1);
}

TEST_CASE("invalid calls of receivers in C return their status") {
  EventLog log;
  Block memory(discmc_receiver_bytes(nullptr, 0, 0));
  discmc_receiver_config config = {0, {memory.memory().data, memory.memory().bytes}, {}};
  discmc_receiver* receiver = nullptr;
  CHECK(discmc_receiver_start(&receiver, &config) == DISCMC_BAD_SINK);
  config.sink = c_sink_to(log);
  --config.memory.bytes;
  CHECK(discmc_receiver_start(&receiver, &config) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(receiver == nullptr);
  ReceiverInC later(c_sink_to(log), discmc_receiver_bytes(nullptr, 0, 0));
  CHECK(later.push(test::with_version(77, polygons()), 1000) == DISCMC_WRONG_VERSION);
  const auto refuse = [](void*, const discmc_event*) {
    return static_cast<discmc_sink_result>(DISCMC_SINK_NOT_STARTED);
  };
  ReceiverInC refused({nullptr, refuse}, discmc_receiver_bytes(nullptr, 0, 0));
  CHECK(refused.push(polygons(), 1000) == DISCMC_BAD_SINK);
}

TEST_CASE("a joiner behind a receiver in C delivers the events of a Joiner") {
  for (const uint32_t fragments : {1U, 500U}) {
    EventLog log(refuses_first), expected;
    Block memory(DISCMC_JOINER_BYTES(fragments));
    const discmc_joiner_config config = {
        DISCMC_SWEEP_ORDER, {memory.memory().data, memory.memory().bytes}, c_sink_to(log)};
    discmc_joiner* joiner = nullptr;
    REQUIRE(discmc_joiner_start(&joiner, &config) == DISCMC_OK);
    ReceiverInC receiver({joiner, discmc_joiner_accept}, discmc_receiver_bytes(nullptr, 0, 0));
    REQUIRE(receiver.push(polygons(), 1000) == DISCMC_OK);
    const discmc_status status =
        completed(DISCMC_SUSPENDED, [&] { return discmc_joiner_finish(joiner); });
    CHECK(status == (fragments == 1 ? DISCMC_TOO_LITTLE_MEMORY : DISCMC_OK));
    CHECK(memory.is_intact());

    const discmc_joiner_info info = discmc_joiner_get_info(joiner);
    CHECK(info.fragments >= fragments);
    CHECK(info.runs == 8 * info.fragments);
    std::vector<uint8_t> other(Joiner::bytes_for({info.fragments, info.runs}));
    Joiner in_cpp;
    require_ok(in_cpp.start({info.fragments, info.runs}, {other.data(), other.size()},
                            make_sink(expected), InputOrder::sweep));
    for (const RecordedEvent& event : test::decode(polygons()).events)
      REQUIRE(in_cpp.accept(event.event()) == SinkResult::accepted);
    CHECK(static_cast<discmc_status>(in_cpp.finish()) == status);
    CHECK(log.events == expected.events);
    const JoinReport& report = in_cpp.report();
    CHECK(info.received == report.received);
    CHECK(info.received > 100);
    CHECK(info.invalid == report.invalid);
    CHECK(info.regions == report.regions);
    CHECK(info.rings == report.rings);
    CHECK(info.unmatched == report.unmatched);
    CHECK(info.short_of_memory == report.short_of_memory);
    CHECK(info.peak_fragments == in_cpp.peaks().fragments);
    CHECK(info.peak_runs == in_cpp.peaks().runs);
  }
}

TEST_CASE("invalid calls of joiners in C return their status") {
  EventLog log;
  Block memory(DISCMC_JOINER_BYTES(1));
  discmc_joiner_config config = {
      DISCMC_ANY_ORDER, {memory.memory().data, memory.memory().bytes}, {nullptr, nullptr}};
  discmc_joiner* joiner = nullptr;
  CHECK(discmc_joiner_start(&joiner, &config) == DISCMC_BAD_SINK);
  config.sink = c_sink_to(log);
  for (const size_t bytes : {size_t{0}, size_t{100}, sizeof(void*) * 10 + 240}) {
    config.memory.bytes = bytes;
    CHECK(discmc_joiner_start(&joiner, &config) == DISCMC_TOO_LITTLE_MEMORY);
  }
  CHECK(joiner == nullptr);
  const discmc_event event{};
  CHECK(discmc_joiner_accept(nullptr, &event) == DISCMC_SINK_NOT_STARTED);
}
