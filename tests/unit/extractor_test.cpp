// The extractor as firmware uses it: all ways to push samples give the same events, and every
// misuse returns a status without other effects.
#include "oracle/agreement.hpp"
#include "oracle/bench.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr uint32_t boundary_widths[] = {1, 2, 3, 31, 32, 33, 63, 64, 65, 127, 128, 129};

EventLog plain_scan(const BitVolume& volume, Border border = Border::closed) {
  Bench<uint32_t> bench(limits_of(volume, border));
  push_all(bench.extractor, volume.on);
  finish_all(bench.extractor);
  return bench.log;
}

// Converts the samples of a volume to another type. On means at least the threshold.
template <class Sample>
std::vector<Sample> samples_of(const BitVolume& volume, int64_t on, int64_t off,
                               uint32_t stride = 1, int64_t between = 0) {
  std::vector<Sample> samples((volume.voxels() - 1) * stride + 1, static_cast<Sample>(between));
  for (size_t i = 0; i < volume.voxels(); ++i)
    samples[i * stride] = static_cast<Sample>(volume.on[i] != 0 ? on : off);
  return samples;
}

template <class Sample>
void check_samples(int32_t threshold, int64_t on, int64_t off) {
  const BitVolume volume = random({35, 4, 3}, 120, 8);
  const EventLog expected = plain_scan(volume);
  for (const uint32_t stride : {1U, 2U, 3U, 7U, 64U}) {
    // The values between the samples would change every voxel if they were read.
    for (const int64_t between : {on, off}) {
      const std::vector<Sample> samples = samples_of<Sample>(volume, on, off, stride, between);
      Bench<uint16_t> bench(limits_of(volume, Border::closed), threshold);
      const auto count = static_cast<uint32_t>(volume.voxels());
      CHECK(bench.extractor.push(samples.data(), count, stride).samples == count);
      finish_all(bench.extractor);
      CAPTURE(stride);
      CHECK(bench.log.events == expected.events);
    }
  }
}

template <class Sample>
size_t regions_at(int32_t threshold, const std::vector<Sample>& samples, const Limits& limits) {
  Bench<uint16_t> bench(limits, threshold);
  push_all(bench.extractor, samples);
  finish_all(bench.extractor);
  return collected(bench.log.events).regions().size();
}

std::vector<uint8_t> bits_of(const BitVolume& volume, size_t row) {
  std::vector<uint8_t> bits((volume.width + 7) / 8, 0);
  for (size_t x = 0; x < volume.width; ++x)
    if (volume.on[row * volume.width + x] != 0)
      bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | 1U << x % 8);
  // Samples beyond the row do not belong to the volume.
  if (volume.width % 8 != 0)
    bits.back() = static_cast<uint8_t>(bits.back() | 0xFFU << volume.width % 8);
  return bits;
}

}  // namespace

TEST_CASE("portions of any size, down to one sample, yield the same events") {
  const BitVolume volume = random({33, 5, 4}, 120, 3);
  for (const Border border : {Border::closed, Border::open}) {
    const EventLog expected = plain_scan(volume, border);
    for (const uint32_t chunk : {1U, 2U, 5U, 31U, 32U, 33U, 34U, 66U, 164U, 165U, 166U, 659U}) {
      Bench<uint16_t> bench(limits_of(volume, border));
      push_all(bench.extractor, volume.on, chunk);
      finish_all(bench.extractor);
      CAPTURE(chunk);
      CHECK(bench.log.events == expected.events);
    }
  }
}

TEST_CASE("every sample type and stride yields the same events") {
  check_samples<uint8_t>(1, 1, 0);
  check_samples<uint8_t>(255, 255, 254);
  check_samples<uint16_t>(256, 256, 255);
  check_samples<uint16_t>(65535, 65535, 0);
  check_samples<uint16_t>(32768, 32768, 32767);
  check_samples<int16_t>(-5, -5, -6);
  check_samples<int16_t>(-32767, 32767, -32768);
  check_samples<int16_t>(0, 0, -1);
}

TEST_CASE("push() reads nothing beyond the last sample for any stride") {
  // Address sanitizers check the end of a vector of exactly this size.
  const BitVolume volume = random({5, 3, 2}, 128, 1);
  for (uint32_t stride = 1; stride < 9; ++stride) {
    const std::vector<uint16_t> samples = samples_of<uint16_t>(volume, 7, 0, stride);
    Bench<uint16_t> bench(limits_of(volume, Border::closed), 7);
    for (uint32_t at = 0; at < 30;) {
      const PushResult pushed = bench.extractor.push(samples.data() + at * stride, 1, stride);
      at += pushed.samples;
    }
    finish_all(bench.extractor);
    CHECK(bench.log.events == plain_scan(volume).events);
  }
}

TEST_CASE("a threshold below all samples switches all voxels on, and one above all samples none") {
  const Limits limits{3, 3, Border::closed};
  const std::vector<uint8_t> bytes(27, 0);
  const std::vector<uint8_t> full(27, 255);
  const std::vector<int16_t> low(27, INT16_MIN);
  const std::vector<uint16_t> high(27, UINT16_MAX);
  CHECK(regions_at(0, bytes, limits) == 26);
  CHECK(regions_at(-1, bytes, limits) == 26);
  CHECK(regions_at(INT32_MIN, bytes, limits) == 26);
  CHECK(regions_at(1, bytes, limits) == 0);
  CHECK(regions_at(256, full, limits) == 0);
  CHECK(regions_at(INT32_MAX, full, limits) == 0);
  CHECK(regions_at(-32768, low, limits) == 26);
  CHECK(regions_at(-32769, low, limits) == 26);
  CHECK(regions_at(-32767, low, limits) == 0);
  CHECK(regions_at(65535, high, limits) == 26);
  CHECK(regions_at(65536, high, limits) == 0);
}

TEST_CASE("rows whose width is near a multiple of a word are swept as in the paper") {
  for (const uint32_t width : boundary_widths)
    for (const Border border : {Border::closed, Border::open})
      for (const uint32_t density : {60U, 128U, 256U}) {
        const BitVolume volume = random({width, 4, 3}, density, width);
        const EventLog log = plain_scan(volume, border);
        INFO("width ", width, ", density ", density);
        CHECK(unlike_merge(collected(log.events).regions(), volume, border == Border::closed) ==
              "");
      }
}

TEST_CASE("rows of bits yield the same events as samples, and bits beyond the row are ignored") {
  for (const uint32_t width : boundary_widths)
    for (const Border border : {Border::closed, Border::open}) {
      const BitVolume volume = random({width, 4, 3}, 140, width);
      Bench<uint16_t> bench(limits_of(volume, border));
      for (size_t row = 0; row < 12; ++row) {
        const std::vector<uint8_t> bits = bits_of(volume, row);
        const PushResult pushed = bench.extractor.push_bits(bits.data());
        CHECK(pushed.status == Status::ok);
        CHECK(pushed.samples == width);
      }
      finish_all(bench.extractor);
      CAPTURE(width);
      CHECK(bench.log.events == plain_scan(volume, border).events);
    }
}

TEST_CASE("a skipped row is off or repeats the row before, even across slices, and is reported") {
  for (const uint32_t width : boundary_widths)
    for (uint32_t pattern = 0; pattern < 27; ++pattern) {
      BitVolume volume = random({width, 3, 3}, 130, pattern);
      Bench<uint16_t> bench(limits_of(volume, Border::closed));
      std::vector<SkippedRow> skipped;
      for (uint32_t row = 0; row < 9; ++row) {
        uint8_t* samples = volume.on.data() + size_t{row} * width;
        const uint32_t kind = (pattern * 7 + row * row) % 3;
        if (kind == 0) {
          CHECK(bench.extractor.push(samples, width).samples == width);
          continue;
        }
        const bool repeats = kind == 2;
        std::fill_n(samples, width, uint8_t{0});
        if (repeats && row > 0) std::copy_n(samples - width, width, samples);
        const PushResult pushed =
            bench.extractor.skip_row(repeats ? Substitute::previous_row : Substitute::off);
        CHECK(pushed.samples == width);
        skipped.push_back({row / 3, row % 3, repeats});
      }
      finish_all(bench.extractor);
      const Collector collector = collected(bench.log.events);
      REQUIRE(collector.skipped().size() == skipped.size());
      for (size_t i = 0; i < skipped.size(); ++i) {
        CHECK(collector.skipped()[i].slice == skipped[i].slice);
        CHECK(collector.skipped()[i].row == skipped[i].row);
        CHECK(collector.skipped()[i].is_repeated == skipped[i].is_repeated);
      }
      CHECK(unlike_merge(collector.regions(), volume, true) == "");
    }
}

TEST_CASE("an abandoned scan has the surface of its samples, with the rest of the slice off") {
  for (const Border border : {Border::closed, Border::open})
    for (const Size size : {Size{4, 3, 3}, Size{1, 1, 4}, Size{3, 1, 3}, Size{1, 4, 2}}) {
      const BitVolume whole = random(size, 170, size.width);
      for (uint32_t samples = 0; samples <= whole.voxels(); ++samples) {
        Bench<uint16_t> bench(limits_of(whole, border));
        CHECK(bench.extractor.push(whole.on.data(), samples).samples == samples);
        require_ok(bench.extractor.abandon());
        BitVolume seen = whole;
        const uint32_t slice = size.width * size.height;
        seen.depth = (samples + slice - 1) / slice;
        seen.on.resize(samples);
        seen.on.resize(seen.voxels());
        CAPTURE(samples);
        const Collector collector = collected(bench.log.events);
        CHECK(collector.was_abandoned());
        CHECK(collector.layers().size() == seen.depth);
        CHECK(unlike_merge(collector.regions(), seen, border == Border::closed) == "");
      }
    }
}

TEST_CASE("reset() at any point of a scan begins an independent new scan") {
  const BitVolume first = random({6, 5, 4}, 190, 1);
  const BitVolume second = random({6, 5, 4}, 90, 2);
  for (const Border border : {Border::closed, Border::open}) {
    const EventLog expected = plain_scan(second, border);
    for (uint32_t samples = 0; samples <= first.voxels(); samples += 7) {
      EventLog log;
      EventLog* current = nullptr;
      EventLog discarded;
      const auto take = [](void* context, const Event& event) {
        return (*static_cast<EventLog**>(context))->accept(event);
      };
      const Limits limits = limits_of(first, border);
      Block block(Extractor16::minimum_bytes(limits) + 20000);
      Extractor16 extractor;
      current = &discarded;
      require_ok(extractor.start(limits, 1, block.memory(), {&current, take}));
      CHECK(extractor.push(first.on.data(), samples).status == Status::ok);
      if (samples % 2 == 0) require_ok(extractor.abandon());
      current = &log;
      CHECK(extractor.reset() == Status::ok);
      CHECK(extractor.slices() == 0);
      CHECK(extractor.statistics().facets == 0);
      push_all(extractor, second.on);
      finish_all(extractor);
      CAPTURE(samples);
      CHECK(log.events == expected.events);
    }
  }
}

TEST_CASE("the start event contains the extractor's limits and threshold") {
  Bench<uint16_t> bench({7, 3, Border::open}, -42, 0);
  require_ok(bench.extractor.reset());
  REQUIRE(bench.log.starts.size() == 2);
  for (const StreamHeader& header : bench.log.starts) {
    CHECK(header.width == 7);
    CHECK(header.height == 3);
    CHECK(header.border == Border::open);
    CHECK(header.thresholds[0] == -42);
    CHECK_FALSE(header.has_spacing());
  }
}

TEST_CASE(
    "start() and reset() are suspended while the sink is busy, and the start event follows later") {
  struct Busy {
    SinkResult accept(const Event& event) {
      if (is_busy) return SinkResult::busy;
      kinds.push_back(event.kind);
      return SinkResult::accepted;
    }
    bool is_busy = true;
    std::vector<Event::Kind> kinds{};
  } sink;
  const Limits limits{7, 1};
  std::vector<uint8_t> memory(Extractor16::minimum_bytes(limits));
  const uint8_t row[7] = {};
  Extractor16 extractor;
  CHECK(extractor.start(limits, 1, {memory.data(), memory.size()}, make_sink(sink)) ==
        Status::suspended);
  CHECK(extractor.is_suspended());
  CHECK(extractor.resume() == Status::suspended);
  CHECK(extractor.push(row, 7).samples == 0);
  sink.is_busy = false;
  require_ok(extractor.resume());
  CHECK_FALSE(extractor.is_suspended());
  require_ok(extractor.push(row, 7).status);
  using Kind = Event::Kind;
  CHECK(sink.kinds == std::vector<Kind>{Kind::start, Kind::layer});
  sink.is_busy = true;
  CHECK(extractor.reset() == Status::suspended);
  CHECK(extractor.slices() == 0);
  sink.is_busy = false;
  require_ok(extractor.push(row, 7).status);
  CHECK(sink.kinds == std::vector<Kind>{Kind::start, Kind::layer, Kind::start, Kind::layer});
}
