// Streams of slices as read by a reader that uses WIRE.md alone, and those that must decode for
// ever.
#include "oracle/slice_reader.hpp"
#include "oracle/slice_config.hpp"

#include <doctest/doctest.h>

#include "oracle/golden.hpp"
#include "oracle/slice_stream.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using reference::SlicesRead;

namespace {

SlicesRead read(const Bytes& stream) {
  return reference::read_slices(stream, DISCMC_SOURCE_DIR);
}

// That the decoder hands out the rows that the reader reads.
void check_decoded(const Bytes& stream, const SlicesRead& told) {
  const reference::Size size{told.width, told.height, told.depth};
  const ReceivedRows received = decode_slices(stream, size, 0, false, told.surfaces);
  CHECK(received.report.is_complete());
  CHECK(received.report.totals.skipped_rows == told.skipped_rows);
  REQUIRE(received.rows.size() == told.notes.size() * told.surfaces + 1);
  uint32_t wrong = 0;
  for (size_t i = 0; i + 1 < received.rows.size(); ++i) {
    const RecordedRow& row = received.rows[i];
    const size_t at = i / told.surfaces, surface = i % told.surfaces;
    const uint8_t* const first = &told.on[surface][at * told.width];
    const uint32_t note = row.is(RowEvent::Kind::row) ? 0 : row.event.repeated ? 2 : 1;
    if (row.event.slice != at / told.height || row.event.row != at % told.height ||
        row.event.channel != told.channel + surface || note != told.notes[at] ||
        row.bits != Bytes(first, first + told.width))
      ++wrong;
  }
  CHECK(wrong == 0);
}

SlicesRead check_read(const Bytes& stream) {
  const SlicesRead told = read(stream);
  check_decoded(stream, told);
  return told;
}

void check_volume(const BitVolume& volume, const SlicePlan& plan) {
  CAPTURE(volume.width);
  CAPTURE(volume.height);
  CAPTURE(plan.key_slice_interval);
  CHECK(check_read(encode_slices(volume, plan)).on[0] == volume.on);
}

// ---- several surfaces, and rows that never came ----

struct Scan {
  reference::Size size;
  std::vector<int32_t> thresholds;
  uint32_t key_slice_interval;
  uint32_t skip_every = 0;  // one row in this many, off or repeated in turn; 0 none
};

StreamHeader header_of(const Scan& scan) {
  StreamHeader header;
  header.width = scan.size.width;
  header.height = scan.size.height;
  header.depth = scan.size.depth;
  header.channel = 7;
  header.scan = 1994;
  header.surface_count = static_cast<uint8_t>(scan.thresholds.size());
  header.thresholds[0] = scan.thresholds[0];
  std::copy(scan.thresholds.begin(), scan.thresholds.end(), header.thresholds);
  return header;
}

// Highest in the middle, and noisy.
Bytes samples_of(const reference::Size& size) {
  Bytes samples;
  Chance chance(1994);
  const auto from_middle = [](uint32_t at, uint32_t extent) {
    return at * 2 < extent ? extent - at * 2 : at * 2 - extent;
  };
  for (uint32_t z = 0; z < size.depth; ++z)
    for (uint32_t y = 0; y < size.height; ++y)
      for (uint32_t x = 0; x < size.width; ++x)
        samples.push_back(static_cast<uint8_t>(200 - from_middle(x, size.width) -
                                               from_middle(y, size.height) -
                                               from_middle(z, size.depth) + chance.below(9)));
  return samples;
}

Bytes encode(const Scan& scan) {
  const StreamHeader header = header_of(scan);
  const Bytes samples = samples_of(scan.size);
  Bytes memory(SliceEncoder::minimum_bytes(
      {{header.width, header.height}, {}, scan.key_slice_interval, header.surface_count}));
  Line line;
  SliceEncoder encoder;
  reference::require_ok(encoder.start(test::slice_config(header, scan.key_slice_interval),
                                      {memory.data(), memory.size()}, line.output()));
  for (uint32_t row = 0; row < header.height * header.depth; ++row) {
    const bool is_skipped = scan.skip_every > 0 && row % scan.skip_every == scan.skip_every - 1;
    const Substitute substitute = row % 2 == 0 ? Substitute::off : Substitute::previous_row;
    const uint8_t* const first = &samples[size_t{row} * header.width];
    const PushResult result =
        is_skipped ? encoder.skip_row(substitute) : encoder.push(first, header.width);
    reference::require_ok(result.status);
  }
  reference::require_ok(encoder.finish());
  return line.bytes;
}

// That each surface is what its threshold makes of the samples, but for rows that never came.
void check_surfaces(const SlicesRead& told, const Scan& scan) {
  const Bytes samples = samples_of(scan.size);
  REQUIRE(told.surfaces == scan.thresholds.size());
  uint32_t wrong = 0;
  for (size_t surface = 0; surface < told.surfaces; ++surface)
    for (size_t i = 0; i < samples.size(); ++i) {
      const uint32_t note = told.notes[i / told.width];
      const std::vector<uint8_t>& on = told.on[surface];
      const bool expected = note == 0 ? samples[i] >= scan.thresholds[surface]
                                      : note == 2 && on.at(i - told.width) != 0;
      if (on.at(i) != (expected ? 1 : 0)) ++wrong;
    }
  CHECK(wrong == 0);
}

// ---- streams that must decode for ever ----

SlicesRead check_golden(const char* name, const Bytes& made) {
  const Bytes bytes = golden(name);
  CHECK_MESSAGE(made == bytes, "the encoder now makes", hex(made));
  return check_read(bytes);
}

void check_golden(const char* name, const Scan& scan) {
  const SlicesRead told = check_golden(name, encode(scan));
  check_surfaces(told, scan);
  CHECK(told.channel == 7);
  CHECK((told.skipped_rows > 0) == (scan.skip_every > 0));
}

}  // namespace

TEST_CASE("volumes of any width and height are read as WIRE.md specifies") {
  for (uint32_t width = 1; width < 100; width += width < 35 ? 1 : 7)
    for (const uint32_t height : {1U, 2U, 3U, 4U, 9U})
      for (const uint32_t density : {2U, 40U, 128U, 250U})
        for (const uint32_t interval : {0U, 1U, 2U})
          check_volume(reference::random({width, height, 3}, density, width), {{interval}});
}

TEST_CASE("surfaces, skipped rows and flushed rows are read as WIRE.md specifies") {
  for (const std::vector<int32_t>& thresholds :
       {std::vector<int32_t>{170}, {170, 173}, {190, 150, 0}, {180, 181, 300, 160}})
    for (const uint32_t interval : {0U, 1U, 3U})
      for (const uint32_t skip_every : {0U, 1U, 5U}) {
        CAPTURE(thresholds.size());
        CAPTURE(interval);
        CAPTURE(skip_every);
        const Scan scan{{37, 11, 7}, thresholds, {interval}, skip_every};
        check_surfaces(check_read(encode(scan)), scan);
      }
  SlicePlan plan{{3}};
  plan.flush_every = 4;
  check_volume(reference::random({40, 7, 9}, 60, 5), plan);
}

TEST_CASE("a code with a header in it is read as WIRE.md specifies") {
  const BitVolume volume = reference::random({400, 400, 1}, 128, 8);
  const Bytes stream = encode_slices(volume);
  REQUIRE(frames_of(stream).size() > 70);
  CHECK(packet_of(frames_of(stream)[65]).is(detail::wire::PacketKind::header));
  const SlicesRead told = check_read(stream);
  CHECK(told.on[0] == volume.on);
  CHECK(told.key_codes == 1);
  CHECK(told.long_codes == 1);
}

TEST_CASE("noise with key slices matches its golden stream") {
  const BitVolume volume = reference::random({24, 20, 12}, 100, 1994);
  const SlicesRead told = check_golden("slices_noise.dmc", encode_slices(volume, {{4}}));
  CHECK(told.on[0] == volume.on);
  CHECK(told.key_codes == 3);
}

TEST_CASE("three surfaces of one scan match their golden stream") {
  check_golden("slices_surfaces.dmc", Scan{{40, 30, 12}, {150, 170, 155}, {6}, 0});
}

TEST_CASE("skipped rows match their golden stream") {
  check_golden("slices_skipped.dmc", Scan{{33, 9, 12}, {170, 160}, {3}, 4});
}

TEST_CASE("a code of several packets matches its golden stream") {
  const BitVolume volume = reference::random({100, 60, 2}, 128, 1994);
  const SlicesRead told = check_golden("slices_long.dmc", encode_slices(volume));
  CHECK(told.on[0] == volume.on);
  CHECK(told.long_codes == 1);
}

TEST_CASE("codes cut within a row match their golden stream") {
  const Bytes bytes = golden("slices_cut.dmc");
  const SlicesRead told = check_read(bytes);
  CHECK(told.cut_codes > 0);
  BitVolume volume({told.width, told.height, told.depth});
  volume.on = told.on[0];
  CHECK(encode_slices(volume) == bytes);
}
