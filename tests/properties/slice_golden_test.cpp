// Streams of slices that every later version must decode.
#include "oracle/golden.hpp"
#include "oracle/slice_stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;

namespace {

void check_golden(const char* name, const BitVolume& volume, const SlicePlan& plan = {}) {
  const Bytes bytes = golden_of(name, encode_slices(volume, plan));
  const ReceivedRows received = decode_slices(bytes, {volume.width, volume.height, volume.depth});
  CHECK(received.report.is_complete());
  CHECK(voxels_of(received.rows, 0) == volume.on);
}

struct Scan {
  reference::Size size;
  std::vector<int32_t> thresholds;
  uint32_t key_slice_interval;
  uint32_t skip_every = 0;  // one row in this many is off or repeated, alternately; 0: none

  bool skips(uint32_t row) const { return skip_every > 0 && row % skip_every == skip_every - 1; }
};

StreamHeader header_of(const Scan& scan) {
  StreamHeader header;
  header.width = scan.size.width;
  header.height = scan.size.height;
  header.depth = scan.size.depth;
  header.channel = 7;
  header.scan = 1994;
  header.surface_count = static_cast<uint8_t>(scan.thresholds.size());
  std::copy(scan.thresholds.begin(), scan.thresholds.end(), header.thresholds);
  return header;
}

// Highest in the middle, with noise.
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

Bytes encode(const Scan& scan, const Bytes& samples) {
  Line line;
  StartedSliceEncoder encoder(header_of(scan), line.output(), scan.key_slice_interval);
  const uint32_t width = scan.size.width;
  for (uint32_t row = 0; row < scan.size.height * scan.size.depth; ++row) {
    const Substitute substitute = row % 2 == 0 ? Substitute::off : Substitute::previous_row;
    const PushResult result = scan.skips(row) ? encoder.skip_row(substitute)
                                              : encoder.push(&samples[size_t{row} * width], width);
    reference::require_ok(result.status);
  }
  reference::require_ok(encoder.finish());
  return line.bytes;
}

void check_golden(const char* name, const Scan& scan) {
  const Bytes samples = samples_of(scan.size);
  const Bytes bytes = golden_of(name, encode(scan, samples));
  const auto surfaces = static_cast<uint32_t>(scan.thresholds.size());
  const ReceivedRows received = decode_slices(bytes, scan.size, 0, false, surfaces);
  CHECK(received.report.is_complete());
  for (uint32_t surface = 0; surface < surfaces; ++surface) {
    Bytes expected;
    for (size_t i = 0; i < samples.size(); ++i) {
      const auto row = static_cast<uint32_t>(i / scan.size.width);
      const bool is_on = samples[i] >= scan.thresholds[surface];
      // A key slice is coded without a row above it.
      const bool is_off = row % 2 == 0 || row % (scan.key_slice_interval * scan.size.height) == 0;
      const uint8_t above = is_off ? 0 : expected[i - scan.size.width];
      expected.push_back(scan.skips(row) ? above : is_on ? 1 : 0);
    }
    CHECK(voxels_of(received.rows, static_cast<uint8_t>(7 + surface)) == expected);
  }
}

}  // namespace

TEST_CASE("a noise volume with key slices matches its golden stream") {
  check_golden("slices_noise.dmc", reference::random({24, 20, 12}, 100, 1994), {4});
}

TEST_CASE("a scan of three surfaces matches its golden stream") {
  check_golden("slices_surfaces.dmc", Scan{{40, 30, 12}, {150, 170, 155}, 6, 0});
}

TEST_CASE("a scan with skipped rows matches its golden stream") {
  check_golden("slices_skipped.dmc", Scan{{33, 9, 12}, {170, 160}, 3, 4});
}

TEST_CASE("a code of several packets matches its golden stream") {
  check_golden("slices_long.dmc", reference::random({100, 60, 2}, 128, 1994));
}

TEST_CASE("codes cut within a row match their golden stream") {
  BitVolume volume({300, 36, 1});
  volume.on = voxels_of(decode_slices(golden("slices_cut.dmc"), {300, 36, 1}).rows, 0);
  check_golden("slices_cut.dmc", volume);
}
