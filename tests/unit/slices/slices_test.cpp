// Streams of slices: every volume arrives unchanged, for any portions, line and receiver.
#include <discmc/receiver.hpp>

#include "oracle/slice_config.hpp"
#include "oracle/slice_stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using Kind = RowEvent::Kind;

namespace {

// Checks that all rows of a volume have arrived, and then the end.
void check_rows(const BitVolume& volume, const ReceivedRows& received) {
  CHECK(received.status == Status::ok);
  CHECK(received.report.is_complete());
  const uint32_t rows = volume.height * volume.depth;
  REQUIRE(received.rows.size() == rows + 1);
  uint32_t wrong = 0;
  for (uint32_t i = 0; i < rows; ++i) {
    const RecordedRow& row = received.rows[i];
    const uint8_t* const first = &volume.on[size_t{i} * volume.width];
    if (!row.is(Kind::row) || row.event.slice != i / volume.height ||
        row.event.row != i % volume.height || row.bits != Bytes(first, first + volume.width))
      ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(received.rows.back().is(Kind::finish));
  CHECK(received.rows.back().event.slice == volume.depth);
  CHECK_FALSE(received.rows.back().event.is_abandoned);
}

void check_round_trip(const BitVolume& volume, const SlicePlan& plan = {}) {
  INFO("width ", volume.width, ", height ", volume.height, ", interval ", plan.key_slice_interval);
  check_rows(volume, decode_slices(encode_slices(volume, plan),
                                   {volume.width, volume.height, volume.depth}));
}

BitVolume ball(uint32_t size) {
  const auto middle = static_cast<int32_t>(size - 1);
  return reference::ball({size, size, size}, {middle, middle, middle}, middle * middle * 3 / 4);
}

struct Device {
  explicit Device(const Limits& limits, uint32_t key_slice_interval = 0, size_t bytes_at_once = 0)
      : memory(SliceEncoder::minimum_bytes({limits, {}, key_slice_interval})), line(bytes_at_once) {
    const StreamHeader header{limits.width, limits.height, 0, {}, {1}};
    reference::require_ok(encoder.start(slice_config(header, key_slice_interval),
                                        {memory.data(), memory.size()}, line.output()));
  }
  Bytes memory;
  Line line;
  SliceEncoder encoder;
};

}  // namespace

TEST_CASE("all volumes of 3x3x2 voxels are decoded unchanged") {
  BitVolume volume({3, 3, 2});
  uint32_t wrong = 0;
  for (uint32_t bits = 0; bits < 1U << 18; ++bits) {
    for (uint32_t i = 0; i < 18; ++i) volume.on[i] = bits >> i & 1;
    const ReceivedRows received = decode_slices(encode_slices(volume), {3, 3, 2});
    if (!received.report.is_complete() || received.rows.size() != 7) ++wrong;
    for (uint32_t i = 0; i < 6 && wrong == 0; ++i)
      if (received.rows[i].bits != Bytes(&volume.on[i * 3], &volume.on[i * 3] + 3)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("volumes of any width and height are decoded unchanged") {
  for (uint32_t width = 1; width < 100; width += width < 35 ? 1 : 7)
    for (const uint32_t height : {1U, 2U, 3U, 4U, 9U})
      for (const uint32_t density : {2U, 40U, 128U, 250U})
        for (const uint32_t interval : {0U, 1U, 2U})
          check_round_trip(reference::random({width, height, 3}, density, width), {{interval}});
}

TEST_CASE("rows that are all off, all on or nearly all off or on are decoded unchanged") {
  for (const uint32_t width : {1U, 29U, 30U, 31U, 59U, 60U, 100U, 1000U}) {
    BitVolume volume({width, 6, 4});
    check_round_trip(volume);
    for (uint32_t x = 0; x < width; x += 1 + width / 13) {
      volume.on[volume.index(x, 2, 1)] = 1;
      check_round_trip(volume);
    }
    std::fill(volume.on.begin(), volume.on.end(), uint8_t{1});
    check_round_trip(volume);
    for (uint32_t x = 0; x < width; x += 1 + width / 13) {
      volume.on[volume.index(x, 2, 2)] = 0;
      check_round_trip(volume);
    }
  }
}

TEST_CASE("a stream of slices does not depend on portions or on the speed of the line") {
  const BitVolume volume = reference::random({37, 11, 9}, 90, 5);
  for (const uint32_t interval : {0U, 1U, 4U}) {
    const Bytes stream = encode_slices(volume, {{interval}});
    for (const uint32_t portion : {1U, 7U, 36U, 38U, 400U})
      for (const size_t bytes : {1U, 3U, 250U, 1000U})
        CHECK(encode_slices(volume, {{interval}, portion, bytes}) == stream);
  }
}

TEST_CASE("decoded rows do not depend on portions of the stream or on refusals") {
  const BitVolume volume = reference::random({45, 9, 30}, 128, 6);
  const Bytes stream = encode_slices(volume, {{8}});
  for (const size_t chunk : {0U, 1U, 2U, 13U, 300U})
    for (const bool refuses : {false, true})
      check_rows(volume, decode_slices(stream, {45, 9, 30}, chunk, refuses));
}

TEST_CASE("every row pushed before a flush arrives") {
  const BitVolume volume = ball(20);
  for (const uint32_t rows : {1U, 3U, 20U, 77U}) {
    SlicePlan plan{{5}};
    plan.flush_every = rows;
    check_round_trip(volume, plan);
  }
  Device device({20, 20});
  RowLog log(false);
  SliceDecoder decoder;
  Bytes memory(SliceDecoder::minimum_bytes({20, 20}));
  reference::require_ok(decoder.start({memory.data(), memory.size()}, make_row_sink(log)));
  size_t sent = 0;
  for (uint32_t row = 0; row < 60; ++row) {
    push_rows(device.encoder, &volume.on[row * 20], 20, 20);
    until_done([&] { return device.encoder.flush(); });
    const Bytes& bytes = device.line.bytes;
    CHECK(decoder.push(bytes.data() + sent, bytes.size() - sent).status == Status::ok);
    sent = bytes.size();
    CHECK(log.rows.size() == row + 1);
  }
}

TEST_CASE("samples with a stride are compared with the threshold in the header") {
  const StreamHeader header{40, 2, 0, {}, {-5}};
  Line line;
  StartedSliceEncoder encoder(header, line.output());
  int16_t samples[160];
  for (int i = 0; i < 160; ++i) samples[i] = static_cast<int16_t>(i % 4 == 0 ? i % 9 - 9 : 100);
  const PushResult result = encoder.push(samples, 40, 4);
  CHECK(result.status == Status::ok);
  CHECK(result.samples == 40);
  const uint8_t bits[5] = {1, 2, 3, 4, 0x85};
  CHECK(encoder.push_bits(bits).samples == 40);
  reference::require_ok(encoder.finish());
  const ReceivedRows received = decode_slices(line.bytes, {40, 2, 1});
  REQUIRE(received.rows.size() == 3);
  for (uint32_t x = 0; x < 40; ++x) {
    CHECK(received.rows[0].bits[x] == (samples[4 * x] >= -5 ? 1 : 0));
    CHECK(received.rows[1].bits[x] == (bits[x / 8] >> x % 8 & 1));
  }
}

TEST_CASE("a stride continues from one row to the next") {
  const BitVolume volume = reference::random({33, 5, 2}, 128, 11);
  std::vector<uint8_t> apart(3 * volume.on.size());
  for (size_t i = 0; i < volume.on.size(); ++i) apart[3 * i] = volume.on[i];
  Device device({33, 5}), other({33, 5});
  CHECK(device.encoder.push(apart.data(), 330, 3).samples == 330);
  CHECK(other.encoder.push(volume.on.data(), 330).samples == 330);
  reference::require_ok(device.encoder.finish());
  reference::require_ok(other.encoder.finish());
  CHECK(device.line.bytes == other.line.bytes);
}

TEST_CASE("a skipped row is reported with its kind of substitute") {
  const BitVolume volume = reference::random({33, 5, 4}, 128, 7);
  for (const size_t bytes_at_once : {0U, 1U}) {
    Device device({33, 5}, {3}, bytes_at_once);
    for (uint32_t row = 0; row < 20; ++row) {
      if (row % 3 == 2) {
        const Substitute substitute = row % 2 == 0 ? Substitute::off : Substitute::previous_row;
        PushResult result{Status::suspended, 0};
        while (result.samples == 0) result = device.encoder.skip_row(substitute);
      } else {
        push_rows(device.encoder, &volume.on[row * 33], 33, 33);
      }
    }
    until_done([&] { return device.encoder.finish(); });
    const ReceivedRows received = decode_slices(device.line.bytes, {33, 5, 4});
    CHECK(received.report.is_complete());
    CHECK(received.report.totals.skipped_rows == 6);
    REQUIRE(received.rows.size() == 21);
    Bytes before(33);
    for (uint32_t row = 0; row < 20; ++row) {
      CAPTURE(row);
      const RecordedRow& got = received.rows[row];
      CHECK(got.is(row % 3 == 2 ? Kind::skipped : Kind::row));
      if (row % 3 != 2) {
        before = Bytes(&volume.on[row * 33], &volume.on[row * 33] + 33);
      } else {
        CHECK(got.event.is_repeated == (row % 2 != 0));
        if (row % 2 == 0) before = Bytes(33);
      }
      CHECK(got.bits == before);
    }
  }
}

TEST_CASE("an abandoned scan of slices ends at its last row") {
  const BitVolume volume = ball(12);
  Device device({12, 12});
  push_rows(device.encoder, volume.on.data(), 12 * 30 + 5, 100);
  CHECK(device.encoder.finish() == Status::slice_in_progress);
  CHECK(device.encoder.slices() == 2);
  CHECK(device.encoder.rows() == 6);
  until_done([&] { return device.encoder.abandon(); });
  CHECK(device.encoder.push(volume.on.data(), 12).status == Status::finished);
  const ReceivedRows received = decode_slices(device.line.bytes, {12, 12, 3});
  CHECK(received.report.is_complete());
  CHECK(received.report.is_abandoned);
  CHECK(packet_of(frames_of(device.line.bytes).back()).payload[4] == 1);
  REQUIRE(received.rows.size() == 31);
  CHECK(received.rows.back().is(Kind::finish));
  CHECK(received.rows.back().event.is_abandoned);
  CHECK(received.rows.back().event.slice == 3);
}

TEST_CASE("a started slice counts as a slice from its first row") {
  const BitVolume volume = ball(12);
  for (const uint32_t rows : {0U, 1U, 12U, 13U}) {
    CAPTURE(rows);
    Device device({12, 12});
    push_rows(device.encoder, volume.on.data(), 12 * rows, 100);
    reference::require_ok(device.encoder.abandon());
    const ReceivedRows received = decode_slices(device.line.bytes, {12, 12, 2});
    CHECK(received.report.is_complete());
    CHECK(received.rows.back().event.slice == (rows + 11) / 12);
  }
}

TEST_CASE("skipped rows fill packets in the same way as other rows") {
  const BitVolume volume = reference::random({3, 4000, 1}, 128, 12);
  for (const size_t bytes_at_once : {0U, 100U, 1000U}) {
    CAPTURE(bytes_at_once);
    Device device({3, 4000}, {}, bytes_at_once);
    for (uint32_t row = 0; row < 4000; ++row) {
      PushResult result{Status::suspended, 0};
      while (result.samples == 0)
        result = row % 2 == 0 ? device.encoder.push(&volume.on[row * 3], 3)
                              : device.encoder.skip_row(Substitute::off);
    }
    until_done([&] { return device.encoder.finish(); });
    CHECK(frames_of(device.line.bytes).size() > 10);
    const ReceivedRows received = decode_slices(device.line.bytes, {3, 4000, 1});
    CHECK(received.report.is_complete());
    CHECK(received.report.rows == 4000);
    CHECK(received.report.totals.skipped_rows == 2000);
  }
}

TEST_CASE("a push_bits() that returns ok has encoded its row, even on a busy line") {
  // Rows of several packets, and rows before each of which a packet ends.
  for (const reference::Size& size : {reference::Size{6000, 2, 3}, {30, 1, 50}}) {
    CAPTURE(size.width);
    const BitVolume volume = reference::random(size, 128, 13);
    Device device({size.width, size.height}, {1}, 1000);
    for (uint32_t row = 0; row < size.height * size.depth; ++row) {
      Bytes bits((size.width + 7) / 8);
      for (uint32_t x = 0; x < size.width; ++x)
        bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | volume.on[row * size.width + x] << x % 8);
      PushResult result = device.encoder.push_bits(bits.data());
      while (result.samples == 0) {
        REQUIRE(result.status == Status::suspended);
        result = device.encoder.push_bits(bits.data());
      }
      if (result.status == Status::ok)
        CHECK(device.encoder.slices() * size.height + device.encoder.rows() == row + 1);
    }
    until_done([&] { return device.encoder.finish(); });
    check_rows(volume, decode_slices(device.line.bytes, size));
  }
}

TEST_CASE("the header is repeated after 64 packets, but not after the trailer") {
  for (uint32_t packets = 62; packets < 67; ++packets) {
    CAPTURE(packets);
    const BitVolume volume({3, packets, 1});
    SlicePlan plan;
    plan.flush_every = 1;
    const std::vector<Bytes> frames = frames_of(encode_slices(volume, plan));
    size_t headers = 0;
    for (const Bytes& frame : frames)
      if (packet_of(frame).is(detail::wire::PacketKind::header)) ++headers;
    CHECK(headers == (packets < 64 ? 1 : 2));
    CHECK(frames.size() == headers + packets + 1);
    CHECK(packet_of(frames.back()).is(detail::wire::PacketKind::slices_trailer));
  }
  // A code with a header in it.
  const BitVolume long_slice = reference::random({400, 400, 1}, 128, 8);
  CHECK(packet_of(frames_of(encode_slices(long_slice))[65]).is(detail::wire::PacketKind::header));
  check_round_trip(long_slice);
}

TEST_CASE("a run longer than its row is refused") {
  for (const uint32_t width : {3U, 5U})
    for (uint32_t length = width; length < (width == 3 ? 4 : 8); ++length) {
      INFO("width ", width, ", length ", length);
      const BitVolume volume({width, 1, 1});
      std::vector<Bytes> frames = frames_of(encode_slices(volume));
      Packet packet = packet_of(frames[1]);
      reference::Block block(detail::slices::SliceModel::bytes_for(false) + Arena::alignment);
      Arena arena(block.memory());
      detail::slices::SliceModel model;
      model.start(arena, false);
      model.begin(detail::slices::SliceKind::key);
      packet.payload.resize(detail::wire::max_payload);
      detail::slices::RowWriter code{RangeEncoder(&packet.payload[4], 200)};
      code.code_bit(model[detail::slices::context::note], false);
      const uint32_t bits_of_width = width == 3 ? 2 : 3;
      code.code_bit(model[detail::slices::context::run + 2 * (bits_of_width - 1) + 1], false);
      code.raw_bits(bits_of_width, length);
      code.raw_bits(32, 0x5A5A5A5A);
      packet.payload.resize(4 + code.range.finish());
      frames[1] = frame_of(packet);
      const ReceivedRows received = decode_slices(joined(frames), {width, 1, 1});
      CHECK(received.report.is_unreadable);
      CHECK(received.report.rows == 0);
      CHECK(received.report.lost_rows == 1);
    }
}

TEST_CASE("after a change of output only the next slice becomes a key slice") {
  const BitVolume volume = ball(12);
  Device device({12, 12});
  push_rows(device.encoder, volume.on.data(), 144 * 3 + 30, 1000);
  Line other;
  device.encoder.set_output(other.output());
  push_rows(device.encoder, &volume.on[144 * 3 + 30], 144 * 9 - 30, 1000);
  reference::require_ok(device.encoder.finish());
  Bytes keys;  // the first of them was in a packet that had not been sent
  for (const Bytes& frame : frames_of(other.bytes)) {
    const Packet packet = packet_of(frame);
    if (packet.kind >= 16 && (packet.kind & detail::wire::SliceBits::key) != 0)
      keys.push_back(packet.payload[0]);
  }
  CHECK(keys == Bytes{0, 4});
}

TEST_CASE("a slice encoder refuses invalid calls with a status") {
  Line line;
  SliceEncoder encoder;
  uint8_t samples[8] = {};
  CHECK(encoder.push(samples, 8).status == Status::not_started);
  const auto refuses_rows = [&](Status status) {
    for (const PushResult result :
         {encoder.push_bits(samples), encoder.skip_row(Substitute::off)}) {
      CHECK(result.status == status);
      CHECK(result.samples == 0);
    }
  };
  refuses_rows(Status::not_started);
  CHECK(encoder.bytes() == 0);
  CHECK(encoder.resume() == Status::not_started);
  CHECK(encoder.flush() == Status::not_started);
  CHECK(encoder.finish() == Status::not_started);
  CHECK(encoder.abandon() == Status::not_started);
  const StreamHeader header{8, 3};
  Bytes memory(SliceEncoder::minimum_bytes({{8, 3}}));
  CHECK(encoder.start(slice_config(StreamHeader{}), {memory.data(), memory.size()},
                      line.output()) == Status::bad_limits);
  for (const Slab& slab : {Slab{5, true, false}, Slab{0, false, true}}) {
    SliceEncoderConfig of_slab = slice_config(header);
    of_slab.limits.slab = slab;
    CHECK(encoder.start(of_slab, {memory.data(), memory.size()}, line.output()) ==
          Status::bad_limits);
  }
  CHECK(encoder.start(slice_config(header), {memory.data(), memory.size()}, {}) ==
        Status::bad_sink);
  CHECK(encoder.start(slice_config(header), {}, line.output()) == Status::too_little_memory);
  CHECK(encoder.start(slice_config(header), {nullptr, memory.size()}, line.output()) ==
        Status::too_little_memory);
  CHECK(encoder.start(slice_config(header), {memory.data(), memory.size() - 1}, line.output()) ==
        Status::too_little_memory);
  CHECK(line.bytes.empty());
  reference::require_ok(
      encoder.start(slice_config(header), {memory.data(), memory.size()}, line.output()));
  CHECK(encoder.push(samples, 3).status == Status::ok);
  refuses_rows(Status::row_in_progress);
  CHECK(encoder.finish() == Status::slice_in_progress);
}

TEST_CASE("a slice decoder refuses invalid calls with a status") {
  const BitVolume volume = ball(9);
  const Bytes stream = encode_slices(volume);
  SliceDecoder decoder;
  CHECK(decoder.push(stream.data(), stream.size()).status == Status::not_started);
  CHECK(decoder.finish() == Status::not_started);
  CHECK(decoder.start({}, {}) == Status::bad_sink);
  const RowSink rows{nullptr, [](void*, const RowEvent&) { return SinkResult::accepted; }};
  CHECK(decoder.start({}, rows, StreamLabel::max_channel + 1) == Status::bad_label);
  const ReceivedRows small = decode_slices(stream, {9, 8, 9});
  CHECK(small.status == Status::too_little_memory);
  CHECK(small.rows.empty());
  CHECK(decode_slices(with_version(99, stream), {9, 9, 9}).status == Status::wrong_version);
}

TEST_CASE("an encoder of only key slices needs memory for four rows of bits") {
  constexpr size_t rest = 548 + 3 + 2 * red_zone_bytes;
  CHECK(SliceEncoder::minimum_bytes({{256, 256}, {}, 1}) == 5 * 9 * 4 + rest);
  CHECK(SliceEncoder::minimum_bytes({{256, 256}, {}, 2}) == 259 * 9 * 4 + rest);
  CHECK(SliceEncoder::minimum_bytes({{256, 1}}) == 5 * 9 * 4 + rest);
  // A decoder must expect other slices, too, so it delivers a row of bits.
  CHECK(SliceDecoder::minimum_bytes({256, 256}) == 259 * 9 * 4 + rest + 32 + red_zone_bytes);
}

TEST_CASE("streams of slices are as short as the documents state") {
  const auto bytes = [](const BitVolume& volume, uint32_t interval) {
    return encode_slices(volume, {{interval}}).size();
  };
  const BitVolume round = reference::ball({100, 100, 100}, {100, 100, 100}, 1002);
  CHECK(bytes(round, 0) == 1159);
  CHECK(bytes(round, 16) == 1370);
  CHECK(bytes(BitVolume({256, 256, 100}), 0) < 170);
  CHECK(bytes(reference::random({64, 64, 64}, 128, 1), 0) < 35900);
}

// ---- several surfaces ----

namespace {

// Samples of a volume with a gradient: the further inside, the higher.
Bytes onion(const reference::Size& size) {
  Bytes samples;
  test::Chance chance(3);
  for (uint32_t z = 0; z < size.depth; ++z)
    for (uint32_t y = 0; y < size.height; ++y)
      for (uint32_t x = 0; x < size.width; ++x) {
        const auto from = [](uint32_t at, uint32_t extent) {
          const auto way = static_cast<int32_t>(2 * at + 1) - static_cast<int32_t>(extent);
          return way * way;
        };
        const int32_t far = from(x, size.width) + from(y, size.height) + from(z, size.depth);
        samples.push_back(static_cast<uint8_t>(std::max(0, 200 - far / 8) +
                                               static_cast<int32_t>(chance.below(9))));
      }
  return samples;
}

StreamHeader header_of_surfaces(const reference::Size& size,
                                const std::vector<int32_t>& thresholds) {
  StreamHeader header{size.width, size.height, size.depth};
  header.channel = 5;
  header.surface_count = static_cast<uint8_t>(thresholds.size());
  std::copy(thresholds.begin(), thresholds.end(), header.thresholds);
  return header;
}

// Every fifth row is skipped if `skips`.
Bytes encode_surfaces(const StreamHeader& header, const Bytes& samples, uint32_t key_slice_interval,
                      bool skips = false, size_t bytes_at_once = 0) {
  Line line(bytes_at_once);
  StartedSliceEncoder encoder(header, line.output(), key_slice_interval);
  for (uint32_t row = 0; row < header.height * header.depth; ++row) {
    const uint8_t* const first = &samples[size_t{row} * header.width];
    for (uint32_t pushed = 0; pushed < header.width;)
      pushed += skips && row % 5 == 2 ? encoder.skip_row(Substitute::previous_row).samples
                                      : encoder.push(first + pushed, header.width - pushed).samples;
  }
  until_done([&] { return encoder.finish(); });
  CHECK(encoder.block.is_intact());
  return line.bytes;
}

}  // namespace

TEST_CASE("each of several surfaces in one stream is decoded as from a stream of its own") {
  const reference::Size size{41, 17, 6};
  const Bytes samples = onion(size);
  for (const std::vector<int32_t>& thresholds :
       {std::vector<int32_t>{120}, {100, 140}, {140, 100}, {100, 101, 160, 250}, {0, 300, 90}})
    for (const uint32_t interval : {0U, 1U, 2U})
      for (const bool skips : {false, true}) {
        INFO("thresholds.size() ", thresholds.size(), ", interval ", interval);
        const StreamHeader header = header_of_surfaces(size, thresholds);
        const Bytes stream = encode_surfaces(header, samples, {interval}, skips,
                                             interval == 1 ? 3 : 1000 * interval);
        const ReceivedRows received =
            decode_slices(stream, size, skips ? 1 : 0, interval == 2, header.surface_count);
        REQUIRE(received.report.is_complete());
        CHECK(received.report.rows == size.height * size.depth);
        for (size_t surface = 0; surface < thresholds.size(); ++surface) {
          const StreamHeader one = header_of_surfaces(size, {thresholds[surface]});
          const ReceivedRows alone =
              decode_slices(encode_surfaces(one, samples, {interval}, skips), size);
          CHECK(voxels_of(received.rows, static_cast<uint8_t>(5 + surface)) ==
                voxels_of(alone.rows, 5));
        }
      }
}

TEST_CASE("a pushed row of bits contains the rows of all surfaces, each in whole bytes") {
  const auto decoded = [](uint32_t width, const Bytes& bits) {
    const auto surfaces = static_cast<uint32_t>(bits.size() / ((width + 7) / 8));
    Line line;
    StartedSliceEncoder encoder(
        header_of_surfaces({width, 1, 1}, std::vector<int32_t>(surfaces, 1)), line.output());
    CHECK(encoder.push_bits(bits.data()).samples == width);
    reference::require_ok(encoder.finish());
    std::vector<Bytes> rows;
    for (const RecordedRow& row : decode_slices(line.bytes, {width, 1, 1}, 0, false, surfaces).rows)
      if (row.is(Kind::row)) rows.push_back(row.bits);
    return rows;
  };
  CHECK(decoded(10, {0x81, 1, 0xFF, 3, 0, 2}) ==
        std::vector<Bytes>{
            {1, 0, 0, 0, 0, 0, 0, 1, 1, 0}, Bytes(10, 1), {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}});
  CHECK(decoded(8, {0xFF, 0x18}) == std::vector<Bytes>{Bytes(8, 1), {0, 0, 0, 1, 1, 0, 0, 0}});
}

TEST_CASE(
    "surfaces with close thresholds need fewer bytes in one stream than in separate streams") {
  const reference::Size size{64, 64, 20};
  const Bytes samples = onion(size);
  const auto bytes = [&](const std::vector<int32_t>& thresholds) {
    return encode_surfaces(header_of_surfaces(size, thresholds), samples, {}).size();
  };
  CHECK(bytes({120, 123}) * 10 < (bytes({120}) + bytes({123})) * 9);
  CHECK(bytes({60, 160}) * 100 < (bytes({60}) + bytes({160})) * 102);
}

TEST_CASE("a stream accepts one to four surfaces, on channels up to 63") {
  Line line;
  Bytes memory(100000);
  const Memory all{memory.data(), memory.size()};
  SliceEncoder encoder;
  StreamHeader header = header_of_surfaces({9, 9, 0}, {1, 2, 3, 4});
  header.channel = 60;
  CHECK(encoder.start(slice_config(header), all, line.output()) == Status::ok);
  header.channel = 61;
  CHECK(encoder.start(slice_config(header), all, line.output()) == Status::bad_label);
  header.channel = 0;
  header.surface_count = 5;
  CHECK(encoder.start(slice_config(header), all, line.output()) == Status::bad_label);
}

namespace {

// Encodes or decodes rows of bits, all surfaces in sequence.
template <class Coder>
void code_rows(Coder& coder, const StreamHeader& header, std::vector<Bytes>& rows) {
  const Limits limits{header.width, header.height};
  reference::Block block(SliceEncoder::minimum_bytes({limits, {}, 0, header.surface_count}));
  Arena arena(block.memory());
  detail::slices::CodedSurfaces surfaces;
  surfaces.start(arena, header, detail::slices::rows_kept(limits.height, false));
  surfaces.clear();
  surfaces.begin_key_slice();
  for (Bytes& bits : rows) {
    coder.code_bit(surfaces.note(), false);
    uint8_t* place = bits.data();
    for (uint32_t surface = 0; surface < surfaces.count(); ++surface) {
      surfaces[surface].rows.append_bits(place);
      detail::slices::RowCode row;
      surfaces.begin_row(row, surface, header.width);
      while (!row.is_done() && row.step(coder, surfaces[surface].model)) continue;
      row.complete(surfaces.rows().words());
      surfaces[surface].rows.write_bits(place);
      place += (header.width + 7) / 8;
    }
    surfaces.next_row();
  }
}

// Noise, then rows that keep a carry pending: the number of the encoder stays at or just below one
// that ends in zeros.
std::vector<Bytes> rows_on_the_edge(const StreamHeader& header, uint32_t seed) {
  Chance chance(seed);
  const size_t row_bytes = (header.width + 7) / 8 * header.surface_count;
  std::vector<Bytes> rows(header.height, Bytes(row_bytes));
  for (Bytes& row : rows)
    for (uint8_t& byte : row) byte = chance.byte();
  Bytes number(8000);
  detail::slices::RowWriter written{RangeEncoder(number.data(), number.size())};
  code_rows(written, header, rows);
  REQUIRE(written.range.final_bytes() > 600);
  std::fill(number.begin() + 230, number.end(), uint8_t{0});
  for (Bytes& row : rows) std::fill(row.begin(), row.end(), uint8_t{0});
  detail::slices::RowReader read{RangeDecoder(number.data(), number.size())};
  code_rows(read, header, rows);
  return rows;
}

}  // namespace

TEST_CASE("codes are cut at any pending carry, between rows or within a row of any surface") {
  uint32_t within = 0, between = 0;
  for (const reference::Size& size :
       {reference::Size{2, 5000, 1}, {1, 7000, 1}, {40, 200, 1}, {300, 36, 1}})
    for (const std::vector<int32_t>& thresholds : {std::vector<int32_t>{1}, {1, 1, 1}})
      for (uint32_t seed = 1; seed < 5; ++seed) {
        INFO("width ", size.width, ", seed ", seed);
        const StreamHeader header = header_of_surfaces(size, thresholds);
        const std::vector<Bytes> rows = rows_on_the_edge(header, seed);
        if (header.surface_count == 1) {  // also sample by sample, on a slow line
          BitVolume volume(size);
          for (uint32_t i = 0; i < volume.on.size(); ++i)
            volume.on[i] = rows[i / size.width][i % size.width / 8] >> i % size.width % 8 & 1;
          check_round_trip(volume, {{1}, 1, 1});
        }
        Line line;
        StartedSliceEncoder encoder(header, line.output());
        for (const Bytes& row : rows) reference::require_ok(encoder.push_bits(row.data()).status);
        reference::require_ok(encoder.finish());
        const std::vector<Bytes> frames = frames_of(line.bytes);
        for (size_t i = 1; i + 2 < frames.size(); ++i) {
          const uint8_t kind = packet_of(frames[i]).kind;
          if (kind < 16 || (kind & detail::wire::SliceBits::last) == 0) continue;
          ++((kind & detail::wire::SliceBits::cut) != 0 ? within : between);
        }
        const ReceivedRows received =
            decode_slices(line.bytes, size, 0, false, header.surface_count);
        REQUIRE(received.report.is_complete());
        REQUIRE(received.rows.size() == rows.size() * header.surface_count + 1);
        uint32_t wrong = 0;
        const size_t row_bytes = (size.width + 7) / 8;
        for (size_t i = 0; i + 1 < received.rows.size(); ++i)
          for (uint32_t x = 0; x < size.width; ++x) {
            const uint8_t byte =
                rows[i / header.surface_count][i % header.surface_count * row_bytes + x / 8];
            if (received.rows[i].bits[x] != (byte >> x % 8 & 1)) ++wrong;
          }
        CHECK(wrong == 0);
      }
  CHECK(within > 5);
  CHECK(between > 0);
}

TEST_CASE("a surface decoder selects the surface of its channel from several surfaces") {
  const reference::Size size{30, 20, 10};
  const Bytes samples = onion(size);
  const std::vector<int32_t> thresholds{90, 110, 170};
  const Bytes stream = encode_surfaces(header_of_surfaces(size, thresholds), samples, {4});
  for (uint8_t surface = 0; surface < 3; ++surface) {
    reference::BitVolume volume(size);
    for (size_t i = 0; i < samples.size(); ++i)
      volume.on[i] = samples[i] >= thresholds[surface] ? 1 : 0;
    reference::EventLog log;
    Bytes memory(Receiver::minimum_bytes({size.width, size.height}, 3) + 100000);
    SurfaceDecoder decoder;
    reference::require_ok(decoder.start({memory.data(), memory.size()}, make_sink(log),
                                        static_cast<uint8_t>(5 + surface)));
    reference::require_ok(decoder.push(stream.data(), stream.size()).status);
    reference::require_ok(decoder.finish());
    CHECK(decoder.report().is_complete());
    CHECK(log.events == events_of(volume));
    REQUIRE(log.starts.size() == 1);
    CHECK(log.starts[0].surface_count == 1);
    CHECK(log.starts[0].thresholds[1] == 0);
    CHECK(log.starts[0].channel == 5 + surface);
    CHECK(log.starts[0].thresholds[0] == thresholds[surface]);
  }
}

TEST_CASE("a scan that ends on a busy line is completed by resume()") {
  Line line(1);
  const StreamHeader header = header_of_surfaces({9, 2, 1}, {1});
  StartedSliceEncoder encoder(header, line.output());
  const uint8_t row[9] = {1, 0, 1};
  while (encoder.rows() == 0) (void)encoder.push(row, 9);
  CHECK(encoder.finish() == Status::slice_in_progress);
  (void)encoder.push(row, 9);
  (void)encoder.finish();
  until_done([&] { return encoder.resume(); });
  CHECK(decode_slices(line.bytes, {9, 2, 1}).report.is_complete());
}

TEST_CASE("a finished scan refuses records, even while the line is busy") {
  LimitedLine line;
  const StreamHeader header = header_of_surfaces({9, 1, 1}, {1});
  StartedSliceEncoder encoder(header, line.output());
  REQUIRE(encoder.finish() == Status::suspended);
  CHECK(encoder.is_suspended());
  line.room = 1000;
  CHECK(encoder.write_record({}) == Status::finished);
  reference::require_ok(encoder.resume());
  const ReceivedRows received = decode_slices(line.bytes, {9, 1, 0});
  CHECK(received.report.is_complete());
  CHECK(received.rows.size() == 1);
}

TEST_CASE("a scan can end while only its last row waits for the line") {
  const uint8_t row[9] = {1, 0, 1};
  for (const uint32_t height : {1U, 2U})
    for (const bool skips : {false, true}) {
      INFO("height ", height, ", skips ", skips);
      // A packet ends with every key slice, which this line does not accept.
      LimitedLine line;
      const StreamHeader header = header_of_surfaces({9, height, 2}, {1});
      StartedSliceEncoder encoder(header, line.output(), 1);
      line.room = 100;
      reference::require_ok(encoder.resume());
      line.room = 0;
      for (uint32_t i = 0; i < height; ++i) reference::require_ok(encoder.push(row, 9).status);
      const PushResult waiting = skips ? encoder.skip_row(Substitute::off) : encoder.push(row, 9);
      CHECK(waiting.status == Status::suspended);
      CHECK(waiting.samples == 9);
      CHECK(encoder.finish() == (height == 1 ? Status::suspended : Status::slice_in_progress));
      line.room = 1000;
      reference::require_ok(encoder.resume());
      if (height == 2) reference::require_ok(encoder.push(row, 9).status);
      reference::require_ok(encoder.finish());
      const ReceivedRows received = decode_slices(line.bytes, {9, height, 2});
      CHECK(received.report.is_complete());
      CHECK(received.report.rows == 2 * height);
    }
}

TEST_CASE("a restarted scan is independent of the previous scan, stopped at any point") {
  const reference::Size size{41, 17, 6};
  Bytes samples;
  Chance chance(8);
  for (uint32_t i = 0; i < 41 * 17 * 6; ++i) samples.push_back(chance.byte());
  const StreamHeader header = header_of_surfaces(size, {100, 140, 160});
  const uint32_t key_slice_interval = 2;
  const Bytes expected = encode_surfaces(header, samples, key_slice_interval);
  REQUIRE(expected.size() > 1500);
  // The line fails in one packet after another, most of which end within a row.
  for (size_t room = 0; room < 1500; room += 125) {
    CAPTURE(room);
    LimitedLine broken{room};
    StartedSliceEncoder encoder(header, broken.output(), key_slice_interval);
    Status status = Status::ok;
    for (uint32_t row = 0; row < 17 * 6 && status == Status::ok; ++row)
      status = row == 7 ? encoder.skip_row(Substitute::off).status
                        : encoder.push(&samples[row * 41], 41).status;
    CHECK(status == Status::suspended);
    if (room % 2 == 0) (void)encoder.abandon();
    Line line;
    reference::require_ok(encoder.start(slice_config(header, key_slice_interval),
                                        encoder.block.memory(), line.output()));
    CHECK(encoder.bytes() == 0);
    reference::require_ok(encoder.push(samples.data(), 41 * 17 * 6).status);
    reference::require_ok(encoder.finish());
    // Only a zero byte, which ends the cut frame.
    Bytes expected_now(room > 0 ? 1 : 0);
    expected_now.insert(expected_now.end(), expected.begin(), expected.end());
    CHECK(line.bytes == expected_now);
    CHECK(encoder.bytes() == expected_now.size());
  }
}

TEST_CASE("a skipped row is encoded only after the line accepts earlier bytes") {
  constexpr uint32_t height = 8000;
  const BitVolume volume = reference::random({1, height, 1}, 128, 14);
  const StreamHeader header = header_of(volume);
  const Limits limits{1, height};
  // The rows that fill a packet.
  std::vector<uint32_t> full;
  Device device(limits);
  for (uint32_t row = 0; row < height; ++row) {
    const size_t before = device.line.bytes.size();
    reference::require_ok(device.encoder.push(&volume.on[row], 1).status);
    if (row > 0 && device.line.bytes.size() > before) full.push_back(row);
  }
  REQUIRE(full.size() > 1);
  for (const uint32_t skipped : full) {
    CAPTURE(skipped);
    LimitedLine line{100000};
    StartedSliceEncoder encoder(header, line.output());
    reference::require_ok(encoder.push(volume.on.data(), skipped).status);
    line.room = 0;
    CHECK(encoder.skip_row(Substitute::off).status == Status::suspended);
    line.room = 100000;
    reference::require_ok(encoder.push(&volume.on[skipped + 1], height - skipped - 1).status);
    reference::require_ok(encoder.finish());
    const ReceivedRows received = decode_slices(line.bytes, {1, height, 1});
    CHECK(received.report.is_complete());
    CHECK(received.report.totals.skipped_rows == 1);
  }
}
