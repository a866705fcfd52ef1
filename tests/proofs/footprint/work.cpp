// The work whose instructions are counted. Its printed results must be equal on every target and on
// the host.
#include <board.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/sample_window.hpp>
#include <discmc/slice_encoder.hpp>

#include "scans.hpp"

using namespace discmc;
using namespace discmc::test;

// All objects fit the 16 KiB of a small microcontroller.
constexpr Limits wide{256, 32};
constexpr uint32_t wide_slices = 16;
static uint8_t memory[11 * 1024];
static_assert(sizeof memory >= Extractor16::minimum_bytes(wide), "or the scan does not start");
static Extractor16 extractor;
static Encoder encoder;
static SliceEncoder slice_encoder;

static SinkResult discard_event(void*, const Event&) {
  return SinkResult::accepted;
}
constexpr Sink no_sink{nullptr, discard_event};

static void report(const char* name, uint64_t value) {
  board::report(name, static_cast<uint32_t>(value));
}

template <class Sample, class Scanner>
static bool push_and_report(Scanner& scanner, const Limits& limits, uint32_t slices,
                            uint8_t (*sample)(int32_t, int32_t, int32_t)) {
  if (!push_rows<Sample>(scanner, limits, slices, RowsOf{sample, limits})) return false;
  count_report();
  return scanner.finish() == Status::ok;
}

template <class Sample>
static bool scan(const Limits& limits, uint32_t slices,
                 uint8_t (*sample)(int32_t, int32_t, int32_t), const Sink& sink) {
  return extractor.start(limits, threshold, memory_of(memory), sink) == Status::ok &&
         push_and_report<Sample>(extractor, limits, slices, sample);
}

static bool print_slices(const Limits& limits, uint32_t slices,
                         uint8_t (*sample)(int32_t, int32_t, int32_t)) {
  return slice_encoder.start({limits, {threshold}, 0, 1, {slices}}, memory_of(memory),
                             {nullptr, discard_bytes}) == Status::ok &&
         push_and_report<uint8_t>(slice_encoder, limits, slices, sample);
}

// ---- normals ----

constexpr int32_t size = 6;  // of the cube of samples
constexpr int32_t normals = (size - 1) * (size - 1);

static UnitNormal unit(const LongVector& v) {
  return unit_normal(v);
}
static OctahedralNormal octahedral(const LongVector& v) {
  return octahedral_normal(v);
}

// Counts the instructions of all normals between two slices of the ball. z: 0 for midpoints on
// edges along x, 1 for centroids.
template <class Normal>
static bool count_normals(Normal (*make)(const LongVector&), int32_t z) {
  SampleWindow<uint8_t> window;
  if (window.start({size, size}, memory_of(memory)) != Status::ok) return false;
  for (int32_t i = 0; i < 4 * size * size; ++i) {
    const uint8_t sample = inside_ball(i % size, i / size % size, i / size / size);
    if (window.push(&sample, 1) != Status::ok) return false;
  }
  const AxisWeights weights = axis_weights({957000, -957000, 1500000});
  bool good = true;
  for (int32_t y = 0; y + 1 < size; ++y)
    for (int32_t x = 0; x + 1 < size; ++x) {
      const Vertex vertex{2 * x + 1, 2 * y + z, 2 + z};
      good = good && window.covers(vertex);
      count_on();
      const Normal normal = make(weighted(window.negative_gradient(vertex), weights));
      count_off();
      good = good && normal != Normal{};
    }
  count_report();
  return good;
}

int main() {
  // instructions.awk reads the counts in this order.
  bool good = scan<uint8_t>(wide, wide_slices, outside, no_sink) &&
              scan<uint16_t>(wide, wide_slices, outside, no_sink) &&
              scan<uint8_t>(ball, ball.width, outside, no_sink) &&
              scan<uint8_t>(ball, ball.width, inside_ball, no_sink);
  good = good && encoder.start({ball.width}, {nullptr, discard_bytes}) == Status::ok &&
         scan<uint8_t>(ball, ball.width, inside_ball, make_sink(encoder));
  good = good && print_slices(wide, wide_slices, outside) &&
         print_slices(ball, ball.width, inside_ball);
  good = good && count_normals(octahedral, 0) && count_normals(octahedral, 1) &&
         count_normals(unit, 0) && count_normals(unit, 1);
  const Statistics statistics = extractor.statistics();
  report("wide_voxels", wide.width * wide.height * wide_slices);
  report("normals", normals);
  report("cells", statistics.cells);
  report("facets", statistics.facets);
  report("regions", statistics.regions);
  report("links", statistics.links);
  report("fragments", statistics.fragments);
  report("stream_bytes", encoder.bytes());
  report("slice_bytes", slice_encoder.bytes());
  board::stop(good);
}
