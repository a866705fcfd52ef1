// Checkpoints: a scan resumed after a power failure makes the stream of an uninterrupted scan.
#include <discmc/slice_encoder.hpp>

#include "oracle/checkpointed_device.hpp"
#include "oracle/slice_config.hpp"
#include "oracle/stream_samples.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using namespace discmc::reference;

namespace {

template <class Index>
void check_every_row(size_t max_bytes) {
  for (const Scan& scan : scans()) {
    CAPTURE(scan.name);
    const Bytes whole = uninterrupted<Index>(scan);
    auto first = device_for<Index>(scan);
    first.store.max_bytes = max_bytes;
    first.start();
    for (uint32_t row = 0; row <= first.rows(); ++row) {
      CAPTURE(row);
      first.scan_to(row);
      const Image image = first.save();
      auto second = device_for<Index>(scan);
      REQUIRE(second.restore(image) == Status::ok);
      Bytes stream(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(second.position()));
      second.finish();
      stream.insert(stream.end(), second.store.bytes.begin(), second.store.bytes.end());
      REQUIRE(stream == whole);
    }
  }
}

}  // namespace

TEST_CASE("a checkpoint at any row continues the stream with the same bytes, on any output") {
  check_every_row<uint16_t>(SIZE_MAX);
  check_every_row<uint32_t>(SIZE_MAX);
  check_every_row<uint16_t>(5);  // bytes at a time
}

TEST_CASE("a scan saved and restored repeatedly yields the same stream") {
  for (const Scan& scan : scans()) {
    CAPTURE(scan.name);
    auto first = device_for<uint16_t>(scan);
    first.start();
    Image image = first.save();
    Bytes stream = first.store.bytes;
    for (uint32_t row = 3; row < first.rows(); row += 3) {
      auto device = device_for<uint16_t>(scan);
      REQUIRE(device.restore(image) == Status::ok);
      stream.resize(device.position());
      device.scan_to(row);
      image = device.save();
      device.scan_to(std::min(row + 7, first.rows()));  // lost by the failure
      stream.insert(stream.end(), device.store.bytes.begin(), device.store.bytes.end());
    }
    auto last = device_for<uint16_t>(scan);
    REQUIRE(last.restore(image) == Status::ok);
    stream.resize(last.position());
    last.finish();
    stream.insert(stream.end(), last.store.bytes.begin(), last.store.bytes.end());
    CHECK(stream == uninterrupted<uint16_t>(scan));
  }
}

TEST_CASE("a checkpoint in the middle of a frame continues at the beginning of the frame") {
  Store store;
  Encoder first, second;
  require_ok(begin_stream(first, any_header(), store.output()));
  Event layer{};
  layer.kind = Event::Kind::layer;
  REQUIRE(first.accept(layer) == SinkResult::accepted);
  const uint64_t frame = first.bytes();
  store.max_bytes = 3;
  store.pauses = false;
  REQUIRE(first.flush() == Status::suspended);
  REQUIRE(first.bytes() == frame + 3);
  Memory part;
  require_ok(first.save(&part));
  read_back(image_of({part}), {memory_of(second)});
  Line line;
  require_ok(second.restore(line.output()));
  CHECK(second.bytes() == frame);
  REQUIRE(second.flush() == Status::ok);
  CHECK(decode(line.bytes).events == Script().layer(0).events);
}

TEST_CASE("a flipped bit anywhere in a checkpoint is detected") {
  const Scan scan{"a ball", centred_ball(4), Border::closed, 0};
  auto device = device_for<uint16_t>(scan);
  device.start();
  device.scan_to(9);
  const Image image = device.save();
  auto other = device_for<uint16_t>(scan);
  CHECK(first_unnoticed_flip(image, other) == 8 * image.size());
  CHECK(other.restore(image) == Status::ok);
}

TEST_CASE("a checkpoint of a finished scan is restored as finished") {
  const Scan scan = scans().front();
  auto device = device_for<uint16_t>(scan);
  device.start();
  device.finish();
  const Image image = device.save();
  auto other = device_for<uint16_t>(scan);
  REQUIRE(other.restore(image) == Status::ok);
  CHECK(other.position() == device.store.bytes.size());
  other.finish();
  CHECK(other.store.bytes.empty());
}

TEST_CASE("save() of an extractor is suspended while an event is pending") {
  const BitVolume volume = random({5, 5, 5}, 128, 4);
  EventLog log(reference::refuses_first);
  std::set<Event::Kind> waited_for;
  constexpr Limits limits{5, 5};
  constexpr Capacities capacities{60, 2};
  Block block(Extractor16::bytes_for(limits, capacities));
  Extractor16 extractor;
  Memory parts[2];
  const auto wait = [&](Status status) {
    while (status == Status::suspended) {
      CHECK(extractor.save(parts) == Status::suspended);
      const size_t events_before = log.events.size();
      status = extractor.resume();
      if (log.events.size() > events_before) waited_for.insert(log.events[events_before].kind());
    }
    require_ok(status);
    CHECK(extractor.save(parts) == Status::ok);
  };
  wait(extractor.start(limits, capacities, 1, block.memory(), make_sink(log)));
  for (uint32_t row = 0; row < 25; ++row)
    wait(row % 12 == 0 ? extractor.skip_row(Substitute::previous_row).status
                       : extractor.push(&volume.on[size_t{row} * 5], 5).status);
  wait(extractor.finish());
  using Kind = Event::Kind;
  CHECK(waited_for == std::set<Kind>{Kind::region, Kind::ring, Kind::run, Kind::region_end,
                                     Kind::fragment, Kind::fragment_end, Kind::skipped, Kind::layer,
                                     Kind::finish});
}

TEST_CASE("save() of an encoder is suspended while its output has unsent bytes") {
  struct Radio {
    size_t queued = 0;
    ByteOutput output() {
      return {this,
              [](void* radio, const uint8_t*, size_t count) {
                static_cast<Radio*>(radio)->queued += count;
                return count;
              },
              [](void* radio) { return static_cast<Radio*>(radio)->queued; }};
    }
  } radio;
  Memory parts[2];
  Encoder encoder;
  require_ok(begin_stream(encoder, any_header(), radio.output()));
  CHECK(encoder.save(parts) == Status::suspended);
  radio.queued = 1;
  CHECK(encoder.save(parts) == Status::suspended);
  radio.queued = 0;
  CHECK(encoder.save(parts) == Status::ok);

  SharedOutput shared;
  shared.start(radio.output());
  require_ok(begin_stream(encoder, any_header(), shared.output()));
  CHECK(encoder.save(parts) == Status::suspended);
  radio.queued = 0;
  CHECK(encoder.save(parts) == Status::ok);

  const StreamHeader header{4, 1};
  SliceEncoder slices;
  Block block(SliceEncoder::minimum_bytes({{4, 1}}));
  require_ok(slices.start(slice_config(header), block.memory(), radio.output()));
  require_ok(slices.resume());
  CHECK(slices.save(parts) == Status::suspended);
  radio.queued = 0;
  CHECK(slices.save(parts) == Status::ok);
  radio.queued = 1;
  slices.set_output({});
  CHECK(slices.save(parts) == Status::ok);  // nothing is sent
}

TEST_CASE("an output that does not report unsent bytes cannot be saved") {
  const ByteOutput output{nullptr, [](void*, const uint8_t*, size_t count) { return count; }};
  Memory parts[2];
  Encoder encoder;
  require_ok(begin_stream(encoder, any_header(), output));
  CHECK(encoder.save(parts) == Status::bad_sink);
  SharedOutput shared;
  shared.start(output);
  require_ok(begin_stream(encoder, any_header(), shared.output()));
  CHECK(encoder.save(parts) == Status::bad_sink);
  const StreamHeader header{4, 1};
  SliceEncoder slices;
  Block block(SliceEncoder::minimum_bytes({{4, 1}}));
  require_ok(slices.start(slice_config(header), block.memory(), output));
  CHECK(slices.save(parts) == Status::bad_sink);
}

TEST_CASE("save() and restore() refuse invalid calls with a status") {
  Store store;
  Encoder encoder;
  Extractor16 extractor;
  const Sink sink = make_sink(encoder);
  Memory parts[3];
  CHECK(encoder.save(parts) == Status::not_started);
  CHECK(extractor.save(parts) == Status::not_started);
  CHECK(encoder.restore(store.output()) == Status::bad_checkpoint);

  constexpr Limits limits{4, 1};
  alignas(4) uint8_t memory[Extractor16::minimum_bytes(limits) + 1] = {};
  const Memory whole{memory, sizeof memory - 1};
  require_ok(encoder.start({}, store.output()));
  store.max_bytes = 0;  // the sink cannot accept the `layer` event
  require_ok(extractor.start(limits, 1, whole, sink));
  const uint8_t row[] = {0, 1, 1, 0};
  CHECK(extractor.push(row, 4).status == Status::suspended);
  CHECK(extractor.save(parts + 1) == Status::suspended);
  store.max_bytes = SIZE_MAX;
  require_ok(extractor.resume());
  require_ok(encoder.save(parts));
  require_ok(extractor.save(parts + 1));
  const Image image = image_of({parts, parts + 3});
  const auto back = [&] { read_back(image, {parts, parts + 3}); };

  const size_t used = extractor.bytes_used();
  CHECK(encoder.restore(ByteOutput{}) == Status::bad_sink);
  CHECK(encoder.restore(store.output()) == Status::ok);
  CHECK(extractor.restore({nullptr, used}, sink) == Status::too_little_memory);
  CHECK(extractor.restore(whole, Sink{}) == Status::bad_sink);
  CHECK(extractor.restore(whole, sink) == Status::ok);
  back();
  CHECK(extractor.restore({memory, used - 1}, sink) == Status::bad_checkpoint);
  CHECK(extractor.resume() == Status::not_started);
  back();
  CHECK(extractor.restore({memory, used}, sink) == Status::too_little_memory);
  CHECK(extractor.resume() == Status::not_started);
  back();
  std::memmove(memory + 1, memory, used);
  CHECK(extractor.restore({memory + 1, used}, sink) == Status::bad_checkpoint);
}
