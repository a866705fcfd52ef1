// Streams of slices with fractions: the decoded fractions equal those computed from the samples by
// definition.
#include <cstring>
#include <discmc/fraction.hpp>
#include <discmc/receiver.hpp>

#include "oracle/event_log.hpp"
#include "oracle/golden.hpp"
#include "oracle/slice_config.hpp"
#include "oracle/slice_stream.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using namespace discmc::reference;
using Kind = RowEvent::Kind;

namespace {

// A wave with noise around the middle of the samples' range.
template <class Sample>
SampleVolume<Sample> wave(const Size& size, int32_t middle, int32_t height) {
  SampleVolume<Sample> volume{size, {}};
  uint32_t noise = 1;
  for (uint32_t z = 0; z < size.depth; ++z)
    for (uint32_t y = 0; y < size.height; ++y)
      for (uint32_t x = 0; x < size.width; ++x) {
        noise = noise * 1664525 + 1013904223;
        const auto hill = static_cast<int32_t>((x * y + 3 * x * z + 5 * y * z) % 64) - 32;
        const auto roughness = static_cast<int32_t>((noise >> 24) % 16) - 8;
        volume.samples.push_back(static_cast<Sample>(middle + height * (hill + roughness) / 40));
      }
  return volume;
}

template <class Sample>
SliceEncoderConfig config_of(const SampleVolume<Sample>& volume, int32_t threshold,
                             uint8_t levels) {
  SliceEncoderConfig config{{volume.size.width, volume.size.height}, {threshold}};
  config.levels = levels;
  return config;
}

template <class Sample>
void check_all_plans(const SampleVolume<Sample>& volume, int32_t threshold) {
  for (const uint8_t levels : std::initializer_list<uint8_t>{2, 4})
    for (const uint32_t interval : {0U, 1U, 3U})
      for (const size_t bytes_at_once : std::initializer_list<size_t>{0, 5}) {
        INFO("levels ", levels, ", interval ", interval, ", bytes_at_once ", bytes_at_once);
        SlicePlan plan{interval};
        plan.portion = bytes_at_once > 0 ? 7 : 1000000;
        plan.bytes_at_once = bytes_at_once;
        plan.flush_every = bytes_at_once > 0 ? 3 : 0;
        SliceEncoderConfig config = config_of(volume, threshold, levels);
        config.key_slice_interval = interval;
        FractionSliceEncoder<Sample> encoder;
        const Bytes stream = encode_samples(encoder, config, volume.samples, plan);
        const ReceivedRows received =
            decode_slices(stream, volume.size, bytes_at_once, bytes_at_once > 0, 1, levels);
        CHECK(received.report.is_complete());
        CHECK(received.report.rows == volume.size.height * volume.size.depth);
        CHECK(have_fractions(received.rows, volume, threshold, levels));
      }
}

}  // namespace

TEST_CASE("decoded fractions equal the fractions of the samples, for every sample type") {
  for (const Size& size :
       {Size{67, 9, 5}, Size{30, 4, 3}, Size{1, 1, 4}, Size{1, 7, 2}, Size{7, 70, 2}}) {
    CAPTURE(size.width);
    check_all_plans(wave<uint8_t>(size, 100, 90), 100);
    check_all_plans(wave<uint16_t>(size, 500, 400), 500);
    check_all_plans(wave<uint16_t>(size, 32768, 30000), 32000);
    check_all_plans(wave<int16_t>(size, -200, 25000), -300);
  }
}

TEST_CASE("fractions arrive at the ends of sections of rows far below the threshold") {
  const auto check = [](auto volume, int32_t threshold) {
    using Sample = typename decltype(volume.samples)::value_type;
    for (size_t i = 0; i < volume.samples.size(); ++i)
      if (i % volume.size.width < 60) volume.samples[i] = std::numeric_limits<Sample>::min();
    check_all_plans(volume, threshold);
  };
  check(wave<uint8_t>({70, 5, 3}, 100, 90), 100);
  check(wave<uint16_t>({70, 5, 3}, 32768, 30000), 32000);
  check(wave<int16_t>({70, 5, 3}, -200, 25000), -300);
}

TEST_CASE("samples at the limits of their type have fractions for every threshold") {
  const Size size{40, 5, 4};
  SampleVolume<uint16_t> ends = wave<uint16_t>(size, 32768, 1);
  for (size_t i = 0; i < ends.samples.size(); ++i)
    ends.samples[i] = i * 7 % 3 == 0 ? 0 : i * 5 % 2 == 0 ? UINT16_MAX : 1;
  for (const int32_t threshold : {INT32_MIN, -1, 0, 1, 2, 65535, 65536, INT32_MAX})
    check_all_plans(ends, threshold);
}

TEST_CASE("samples with a stride have the same fractions as contiguous samples") {
  const SampleVolume<int16_t> volume = wave<int16_t>({33, 6, 4}, 0, 500);
  const SliceEncoderConfig config = config_of(volume, 10, 4);
  std::vector<int16_t> apart(3 * volume.samples.size());
  for (size_t i = 0; i < volume.samples.size(); ++i) apart[3 * i] = volume.samples[i];
  Block block(FractionSliceEncoder<int16_t>::minimum_bytes(config));
  Line line;
  FractionSliceEncoder<int16_t> encoder;
  REQUIRE(encoder.start(config, block.memory(), line.output()) == Status::ok);
  const auto count = static_cast<uint32_t>(volume.samples.size());
  CHECK(encoder.push(apart.data(), count, 3).samples == count);
  REQUIRE(encoder.finish() == Status::ok);
  const ReceivedRows received = decode_slices(line.bytes, volume.size, 0, false, 1, 4);
  CHECK(have_fractions(received.rows, volume, 10, 4));
}

TEST_CASE("skipped rows, and edges to skipped rows, have no fractions") {
  const auto check = [](const Size& size, uint32_t interval) {
    CAPTURE(size.height);
    const SampleVolume<uint8_t> volume = wave<uint8_t>(size, 100, 90);
    SliceEncoderConfig config = config_of(volume, 100, 4);
    config.key_slice_interval = interval;
    Block block(FractionSliceEncoder<uint8_t>::minimum_bytes(config));
    Line line;
    FractionSliceEncoder<uint8_t> encoder;
    REQUIRE(encoder.start(config, block.memory(), line.output()) == Status::ok);
    for (uint32_t z = 0; z < volume.size.depth; ++z)
      for (uint32_t y = 0; y < volume.size.height; ++y) {
        const uint32_t place = (z * volume.size.height + y) % 5;
        const PushResult result = place == 2   ? encoder.skip_row(Substitute::off)
                                  : place == 4 ? encoder.skip_row(Substitute::previous_row)
                                               : encoder.push(volume.row(y, z), volume.size.width);
        REQUIRE(result.samples == volume.size.width);
      }
    REQUIRE(encoder.finish() == Status::ok);
    const ReceivedRows received = decode_slices(line.bytes, volume.size, 0, true, 1, 4);
    CHECK(received.report.is_complete());
    CHECK(have_fractions(received.rows, volume, 100, 4));
  };
  for (const uint32_t interval : {0U, 2U}) {
    check({35, 7, 9}, interval);
    check({6, 71, 3}, interval);
  }
}

TEST_CASE("every surface in a stream of several surfaces has its fractions") {
  const SampleVolume<int16_t> volume = wave<int16_t>({50, 8, 6}, 0, 300);
  SliceEncoderConfig config = config_of(volume, 0, 2);
  const int32_t thresholds[] = {0, 40, -70, 200};
  for (int i = 0; i < 4; ++i) config.thresholds[i] = thresholds[i];
  config.surface_count = 4;
  config.key_slice_interval = 2;
  FractionSliceEncoder<int16_t> encoder;
  const Bytes stream = encode_samples(encoder, config, volume.samples, {2, 11, 7});
  const ReceivedRows received = decode_slices(stream, volume.size, 13, true, 4, 2);
  CHECK(received.report.is_complete());
  for (uint8_t channel = 0; channel < 4; ++channel) {
    CHECK(have_fractions(received.rows, volume, thresholds[channel], 2, channel));
    Bytes memory(Receiver::minimum_bytes(config.limits, 4, 2) + 4000);
    EventLog log;
    Receiver receiver;
    reference::require_ok(receiver.start(memory_of(memory), make_sink(log), channel));
    reference::require_ok(push_stream(receiver, stream, 0));
    const auto rows = std::count_if(log.events.begin(), log.events.end(), [](const auto& event) {
      return event.is(Event::Kind::fractions);
    });
    CHECK(rows == std::count_if(received.rows.begin(), received.rows.end(),
                                [channel](const RecordedRow& row) {
                                  return !row.fractions.empty() && row.event.channel == channel;
                                }));
  }
}

TEST_CASE("a checkpoint after any rows continues a stream with fractions with the same bytes") {
  const SampleVolume<uint16_t> volume = wave<uint16_t>({67, 5, 6}, 500, 300);
  for (const uint32_t interval : {0U, 2U}) {
    SliceEncoderConfig config = config_of(volume, 500, 4);
    config.key_slice_interval = interval;
    FractionSliceEncoder<uint16_t> encoder;
    const Bytes whole = encode_samples(encoder, config, volume.samples, {interval});
    Block block(FractionSliceEncoder<uint16_t>::minimum_bytes(config));
    Line line;
    REQUIRE(encoder.start(config, block.memory(), line.output()) == Status::ok);
    for (uint32_t z = 0; z < volume.size.depth; ++z)
      for (uint32_t y = 0; y < volume.size.height; ++y) {
        lose_power(encoder, block, line);
        push_rows(encoder, volume.row(y, z), volume.size.width, 40);
      }
    until_done([&] { return encoder.finish(); });
    CHECK(line.bytes == whole);
  }
}

TEST_CASE("only an encoder of the same samples, with fractions, restores their checkpoint") {
  const SampleVolume<uint16_t> volume = wave<uint16_t>({20, 5, 1}, 100, 90);
  const SliceEncoderConfig config = config_of(volume, 100, 2);
  Block block(FractionSliceEncoder<uint16_t>::minimum_bytes(config));
  Line line;
  FractionSliceEncoder<uint16_t> encoder;
  REQUIRE(encoder.start(config, block.memory(), line.output()) == Status::ok);
  Memory parts[2];
  REQUIRE(encoder.save(parts) == Status::ok);
  CHECK(parts[0].bytes == sizeof encoder);
  CHECK(parts[1].bytes == FractionSliceEncoder<uint16_t>::minimum_bytes(config));
  const auto restored = [&](auto other) {
    static_assert(sizeof other == sizeof encoder);
    std::memcpy(static_cast<void*>(&other), &encoder, sizeof encoder);
    return other.restore(block.memory(), line.output());
  };
  CHECK(restored(FractionSliceEncoder<uint8_t>()) == Status::bad_checkpoint);
  CHECK(restored(FractionSliceEncoder<int16_t>()) == Status::bad_checkpoint);
  CHECK(restored(FractionSliceEncoder<uint16_t>()) == Status::ok);
  SliceEncoder& without = encoder;
  CHECK(without.restore(block.memory(), line.output()) == Status::bad_checkpoint);
  FractionSliceEncoder<uint16_t> unsaved;
  CHECK(unsaved.restore(block.memory(), line.output()) == Status::bad_checkpoint);
}

TEST_CASE("all fractions that arrive after a lost packet are right") {
  const Size size{40, 20, 9};  // with more edges than a queue has room for
  const BitVolume volume = reference::random(size, 128, 3);
  for (const uint8_t levels : std::initializer_list<uint8_t>{2, 4}) {
    SlicePlan plan{3};
    plan.levels = levels;
    const std::vector<Bytes> frames = frames_of(encode_slices(volume, plan));
    REQUIRE(frames.size() > 10);
    for (size_t i = 1; i + 1 < frames.size(); ++i) {
      CAPTURE(i);
      std::vector<Bytes> kept = frames;
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
      const ReceivedRows received = decode_slices(joined(kept), size, 0, false, 1, levels);
      CHECK(received.report.lost_rows > 0);
      CHECK(received.report.lost_rows <= 3 * size.height);
      CHECK_FALSE(received.report.is_unreadable);
      CHECK(have_fractions(received.rows, reference::samples_with(volume), 100, levels));
    }
  }
}

TEST_CASE("a code of fractions that no encoder writes is reported as damaged") {
  const Size size{12, 4, 6};
  SlicePlan plan{2};
  plan.levels = 4;
  const std::vector<Bytes> frames = frames_of(encode_slices(reference::random(size, 128, 3), plan));
  size_t unreadable = 0;
  for (size_t i = 1; i + 1 < frames.size(); ++i)
    for (size_t byte = 0; byte < packet_of(frames[i]).payload.size(); ++byte)
      for (const uint8_t flipped : std::initializer_list<uint8_t>{1, 16, 255}) {
        std::vector<Bytes> changed = frames;
        Packet packet = packet_of(frames[i]);
        packet.payload[byte] ^= flipped;
        changed[i] = frame_of(packet);
        const StreamReport report = decode_slices(joined(changed), size, 0, false, 1, 4).report;
        CHECK_FALSE(report.is_complete());
        if (report.is_unreadable) ++unreadable;
      }
  CHECK(unreadable > 100);
}

TEST_CASE("a late receiver skips fractions of edges from a missed slice") {
  const Size size{40, 6, 12};
  const BitVolume volume = reference::random(size, 128, 3);
  SlicePlan plan{1};
  plan.levels = 4;
  const std::vector<Bytes> frames = frames_of(encode_slices(volume, plan));
  for (size_t first = 1; first + 2 < frames.size(); ++first) {
    std::vector<Bytes> kept(frames.begin() + static_cast<std::ptrdiff_t>(first), frames.end());
    kept.insert(kept.begin(), frames[0]);
    const ReceivedRows received = decode_slices(joined(kept), size, 0, false, 1, 4);
    CHECK_FALSE(received.report.is_unreadable);
    CHECK(received.report.rows + received.report.lost_rows == size.height * size.depth);
    CHECK(have_fractions(received.rows, reference::samples_with(volume), 100, 4));
  }
}

TEST_CASE("an encoder with fractions starts only with 2 or 4 levels, enough memory and an output") {
  SliceEncoderConfig config{{8, 8}, {100}};
  std::vector<uint8_t> memory(10000);
  Line line;
  FractionSliceEncoder<uint8_t> encoder;
  for (const uint8_t levels : std::initializer_list<uint8_t>{0, 1, 3, 5, 8}) {
    config.levels = levels;
    CHECK(encoder.start(config, memory_of(memory), line.output()) == Status::bad_label);
  }
  config.levels = 4;
  CHECK(encoder.start(config, memory_of(memory), {}) == Status::bad_sink);
  const size_t minimum = FractionSliceEncoder<uint8_t>::minimum_bytes(config);
  CHECK(encoder.start(config, {memory.data(), minimum - 1}, line.output()) ==
        Status::too_little_memory);
  CHECK(encoder.push(memory.data(), 1).status == Status::not_started);
  CHECK(encoder.start(config, {memory.data(), minimum}, line.output()) == Status::ok);
  CHECK(encoder.start(config, memory_of(memory), line.output()) == Status::ok);
  CHECK(encoder.bytes_used() <= minimum);
  config.limits.width = 0;
  CHECK(encoder.start(config, memory_of(memory), line.output()) == Status::bad_limits);
}

namespace {

Events events_of(const Bytes& stream, const Size& size, uint32_t levels, size_t extra,
                 bool refuses) {
  Block block(Receiver::minimum_bytes({size.width, size.height}, 1, levels) + extra);
  EventLog log(refuses ? EventLog::Refuses(refuses_first) : EventLog::Refuses());
  Receiver receiver;
  reference::require_ok(receiver.start(block.memory(), make_sink(log)));
  reference::require_ok(push_stream(receiver, stream, 0));
  CHECK(block.is_intact());
  return log.events;
}

// Returns the number of vertices that arrive before the fractions of their edges.
size_t early_vertices(const Events& events, const Size& size) {
  std::set<std::pair<uint32_t, uint32_t>> rows;
  size_t early = 0;
  Vertex position{};
  Incidence incidence{};
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    if (recorded.is(Event::Kind::fractions)) rows.insert({event.row, event.slice});
    if (recorded.is(Event::Kind::region) || recorded.is(Event::Kind::fragment))
      incidence = event.incidence;
    if (recorded.is(Event::Kind::ring) || recorded.is(Event::Kind::fragment))
      position = event.start;
    if (!recorded.is(Event::Kind::run)) continue;
    for (uint32_t link = 0; link < event.run.length(); ++link) {
      translate(position, incidence, event.run.direction(), 1);
      if (position.x % 2 + position.y % 2 + position.z % 2 != 1) continue;
      const auto row = static_cast<uint32_t>((position.y + 1) / 2);
      const auto slice = static_cast<uint32_t>((position.z + 1) / 2);
      const bool has_fractions = row < size.height && slice < size.depth;
      if (has_fractions && rows.count({row, slice}) == 0) ++early;
    }
  }
  return early;
}

}  // namespace

TEST_CASE("a receiver delivers the fractions of an edge before its vertex, and the same polygons") {
  const Size size{20, 8, 8};
  const BitVolume volume = reference::random(size, 128, 5);
  SlicePlan plan;
  const Bytes without = encode_slices(volume, plan);
  plan.levels = 4;
  const Bytes with = encode_slices(volume, plan);
  for (const size_t extra : std::initializer_list<size_t>{0, 4000})
    for (const bool refuses : {false, true}) {
      const Events expected = events_of(without, size, 0, extra, false);
      Events polygons;
      size_t rows = 0;
      const Events received = events_of(with, size, 4, extra, refuses);
      for (const RecordedEvent& event : received) {
        if (event.is(Event::Kind::fractions))
          ++rows;
        else
          polygons.push_back(event);
      }
      CHECK(polygons == expected);
      CHECK(rows == size.height * size.depth);
      CHECK(early_vertices(received, size) == 0);
    }
}

namespace {

// ---- rows with many bytes pending a carry ----

constexpr uint32_t long_width = 1000;

// The bits and the fractions of a row.
struct LongRow {
  std::vector<uint8_t> on = std::vector<uint8_t>(long_width);
  std::vector<uint16_t> entries = std::vector<uint16_t>(long_width + 2);
};

// Codes the only row of a key slice, with 2 levels. A writer reads the row, a reader fills it.
// Returns the number of bytes written before the fractions.
template <class Coder>
size_t code_long_row(Coder& coder, LongRow& row) {
  using namespace detail::slices;
  const StreamHeader header{long_width, 1, 1, {}, {100}, Border::closed, 0, 0, 1, 2};
  Block block(detail::trace::bit_row_bytes(long_width, 4) + SliceModel::bytes_for(false) +
              Fractions::bytes_for({long_width, 1}, 1, 2) + Arena::alignment);
  Arena arena(block.memory());
  CodedSurfaces surfaces;
  surfaces.start(arena, header, 4);
  Fractions fractions;
  fractions.start(arena, header);
  surfaces.clear();
  fractions.clear();
  surfaces.begin_key_slice();
  fractions.begin_models();
  coder.code_bit(surfaces.note(), false);
  Bytes bits((long_width + 7) / 8);
  for (uint32_t x = 0; x < long_width; ++x)
    bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | row.on[x] << x % 8);
  detail::trace::BitRows& rows = surfaces[0].rows;
  constexpr bool reads = std::is_same_v<Coder, RowReader>;
  rows.append_bits(bits.data());
  RowCode voxels;
  surfaces.begin_row(voxels, 0, long_width);
  while (!voxels.is_done()) REQUIRE(voxels.step(coder, surfaces[0].model));
  size_t bytes = 0;
  if constexpr (reads)
    voxels.complete(rows.words());
  else
    bytes = coder.range.final_bytes();
  FractionRow around = fractions.around(rows, 0, false);
  around.entries = &row.entries[1];
  FractionCode code;
  code.begin(around, fractions.model(0), FractionCode::KeyEdges::none, rows.off());
  while (!code.is_done()) REQUIRE(code.step(coder));
  rows.write_bits(bits.data());
  for (uint32_t x = 0; x < long_width; ++x) row.on[x] = bits[x / 8] >> x % 8 & 1;
  return bytes;
}

// Samples with this row for threshold 20,000. Their distances from the threshold give the
// fractions.
std::vector<uint16_t> samples_of(const LongRow& row) {
  std::vector<uint32_t> rising(long_width), falling(long_width);
  for (uint32_t x = 1; x < long_width; ++x)
    if (row.entries[x + 1] == 2) rising[x] = rising[x - 1] + 1;
  for (uint32_t x = long_width - 1; x > 0; --x)
    if (row.entries[x + 1] == 6) falling[x - 1] = falling[x] + 1;
  std::vector<uint16_t> samples;
  for (uint32_t x = 0; x < long_width; ++x) {
    const uint32_t distance = std::max(rising[x], falling[x]);
    samples.push_back(static_cast<uint16_t>(row.on[x] != 0 ? 20000 + distance : 19999 - distance));
  }
  return samples;
}

// A row of which the first bytes, of voxels and some fractions, are followed by a long pending
// carry.
LongRow row_on_the_edge(uint32_t seed) {
  LongRow row;
  Chance chance(seed);
  for (uint32_t x = 0; x < long_width; ++x) row.on[x] = chance.below(2) != 0 ? 1 : 0;
  for (uint32_t x = 1; x < long_width; ++x)
    if (row.on[x] != row.on[x - 1]) row.entries[x + 1] = chance.below(2) != 0 ? 2 : 6;
  Bytes number(60000);
  detail::slices::RowWriter written{RangeEncoder(number.data(), number.size())};
  const size_t voxel_bytes = code_long_row(written, row);
  std::fill(number.begin() + static_cast<std::ptrdiff_t>(voxel_bytes + 20), number.end(),
            uint8_t{0});
  detail::slices::RowReader read{RangeDecoder(number.data(), number.size())};
  row = LongRow();
  code_long_row(read, row);
  return row;
}

// In short frames, which have room for few bytes that a carry may change.
Bytes stream_on_the_edge(uint32_t seed) {
  SliceEncoderConfig config{{long_width, 1}, {20000}};
  config.levels = 2;
  FractionSliceEncoder<uint16_t> encoder;
  Block block(FractionSliceEncoder<uint16_t>::minimum_bytes(config));
  Line line;
  ByteOutput output = line.output();
  output.max_frame = ByteOutput::min_frame_limit;
  reference::require_ok(encoder.start(config, block.memory(), output));
  const std::vector<uint16_t> samples = samples_of(row_on_the_edge(seed));
  reference::require_ok(encoder.push(samples.data(), long_width).status);
  reference::require_ok(encoder.finish());
  return line.bytes;
}

}  // namespace

TEST_CASE("codes with fractions can be cut at any pending carry") {
  uint32_t cuts = 0;
  for (uint32_t seed = 1; seed < 20; ++seed) {
    const Bytes stream = stream_on_the_edge(seed);
    for (const Bytes& frame : frames_of(stream)) {
      const Packet packet = packet_of(frame);
      if (packet.kind < 16 || (packet.kind & detail::wire::SliceBits::cut) == 0) continue;
      const uint8_t part = packet.payload.at(packet.payload.size() - 3);
      CHECK(part == 1);  // next is a fraction along x
      ++cuts;
    }
    const Size size{long_width, 1, 1};
    const ReceivedRows received = decode_slices(stream, size, 0, false, 1, 2);
    CHECK(received.report.is_complete());
    const SampleVolume<uint16_t> volume{size, samples_of(row_on_the_edge(seed))};
    CHECK(have_fractions(received.rows, volume, 20000, 2));
  }
  CHECK(cuts > 3);
}

namespace {

template <class Sample>
void check_golden(const char* name, const Bytes& made, const SampleVolume<Sample>& volume,
                  std::initializer_list<int32_t> thresholds, uint32_t levels) {
  const Bytes bytes = golden_of(name, made);
  const auto surfaces = static_cast<uint32_t>(thresholds.size());
  const ReceivedRows received = decode_slices(bytes, volume.size, 0, false, surfaces, levels);
  CHECK(received.report.is_complete());
  uint8_t channel = 0;
  for (const int32_t threshold : thresholds)
    CHECK(have_fractions(received.rows, volume, threshold, levels, channel++));
}

}  // namespace

TEST_CASE("fractions of two surfaces with key slices and skipped rows match their golden stream") {
  const SampleVolume<uint8_t> volume = wave<uint8_t>({35, 9, 10}, 100, 60);
  SliceEncoderConfig config = config_of(volume, 100, 4);
  config.thresholds[1] = 110;
  config.surface_count = 2;
  config.key_slice_interval = 3;
  Block block(FractionSliceEncoder<uint8_t>::minimum_bytes(config));
  Line line;
  FractionSliceEncoder<uint8_t> encoder;
  REQUIRE(encoder.start(config, block.memory(), line.output()) == Status::ok);
  for (uint32_t row = 0; row < volume.size.height * volume.size.depth; ++row) {
    const uint32_t y = row % volume.size.height, z = row / volume.size.height;
    const PushResult result = row % 11 == 7   ? encoder.skip_row(Substitute::off)
                              : row % 11 == 4 ? encoder.skip_row(Substitute::previous_row)
                                              : encoder.push(volume.row(y, z), volume.size.width);
    REQUIRE(result.status == Status::ok);
  }
  REQUIRE(encoder.finish() == Status::ok);
  check_golden("fractions_quarters.dmc", line.bytes, volume, {100, 110}, 4);
}

TEST_CASE("fractions with 2 levels match their golden stream") {
  const SampleVolume<int16_t> volume = wave<int16_t>({40, 12, 6}, -200, 900);
  SliceEncoderConfig config = config_of(volume, -150, 2);
  FractionSliceEncoder<int16_t> encoder;
  check_golden("fractions_halves.dmc", encode_samples(encoder, config, volume.samples, {}), volume,
               {-150}, 2);
}

TEST_CASE("codes cut amid fractions match their golden stream") {
  const SampleVolume<uint16_t> volume{{long_width, 1, 1}, samples_of(row_on_the_edge(2))};
  check_golden("fractions_cut.dmc", stream_on_the_edge(2), volume, {20000}, 2);
}

TEST_CASE("edge_midpoint() and fraction_of() return the midpoint and the fraction of an edge") {
  CHECK(edge_midpoint(4, 5, 6, 0) == Vertex{7, 10, 12});
  CHECK(edge_midpoint(4, 5, 6, 1) == Vertex{8, 9, 12});
  CHECK(edge_midpoint(4, 5, 6, 2) == Vertex{8, 10, 11});
  constexpr uint16_t entry = 5 | 3 << 3 | 7 << 6;
  CHECK(fraction_of(entry, 0) == 5);
  CHECK(fraction_of(entry, 1) == 3);
  CHECK(fraction_of(entry, 2) == 7);
}
