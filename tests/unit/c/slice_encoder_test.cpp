// A slice encoder writes the same bytes in C and in C++.
#include <discmc/discmc.h>

#include <discmc/fraction_slice_encoder.hpp>

#include "oracle/c_events.hpp"
#include "oracle/slice_config.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::Line;

namespace {

constexpr uint32_t width = 37, height = 9, depth = 12, surfaces = 3;
constexpr int32_t thresholds[DISCMC_MAX_SURFACES] = {100, 130, 60, 0};
constexpr uint32_t lost_row = 33, saved_row = 50;

template <class Sample>
std::vector<Sample> make_samples() {
  std::vector<Sample> samples(size_t{width} * height * depth);
  test::Chance chance(5);
  for (Sample& sample : samples) sample = static_cast<Sample>(chance.below(40) * chance.below(6));
  return samples;
}

struct Scan {
  Scan(const discmc_slice_kind& kind, uint8_t levels, Line& line, uint64_t bytes) : memory(bytes) {
    config.kind = &kind;
    config.levels = levels;
    config.limits = {width, height, DISCMC_OPEN};
    config.surface_count = surfaces;
    std::copy_n(thresholds, DISCMC_MAX_SURFACES, config.thresholds);
    config.key_slice_interval = 4;
    config.label = {depth, {1000, -2000, 3000}, 300, 5};
    config.memory = {memory.memory().data, bytes};
    config.output = in_c(line.output());
  }
  Scan(const discmc_slice_kind& kind, uint8_t levels, Line& line)
      : Scan(kind, levels, line, min_bytes(kind, levels)) {}
  static uint64_t min_bytes(const discmc_slice_kind& kind, uint8_t levels) {
    discmc_slice_encoder_config config{};
    config.kind = &kind;
    config.levels = levels;
    config.limits = {width, height, DISCMC_OPEN};
    config.surface_count = surfaces;
    config.key_slice_interval = 4;
    return discmc_slice_encoder_bytes(&config);
  }

  void start() { REQUIRE(discmc_slice_encoder_start(&encoder, &config) == DISCMC_OK); }
  discmc_status done(discmc_status status) {
    return completed(status, [this] { return discmc_slice_encoder_resume(encoder); });
  }
  template <class Row>
  void push_rows(discmc_sample_type type, const std::vector<Row>& rows, uint32_t first,
                 uint32_t end) {
    const size_t row_samples = rows.size() / (height * depth);
    for (uint32_t row = first; row < end; ++row) {
      const discmc_push_result result =
          row == lost_row
              ? discmc_slice_encoder_skip_row(encoder, DISCMC_SUBSTITUTE_OFF)
              : discmc_slice_encoder_push(encoder, type, &rows[row * row_samples], width, 1);
      REQUIRE(result.accepted == width);
      REQUIRE(done(result.status) == DISCMC_OK);
    }
  }

  Block memory;
  discmc_slice_encoder_config config{};
  discmc_slice_encoder* encoder = nullptr;
};

constexpr uint8_t record_bytes[] = {1, 2, 3};

template <class Encoder, class Sample>
test::Bytes stream_of_cpp(uint8_t levels) {
  StreamHeader header{width,
                      height,
                      depth,
                      {1000, -2000, 3000},
                      {thresholds[0], thresholds[1], thresholds[2], thresholds[3]},
                      Border::open,
                      5,
                      300,
                      surfaces};
  const auto samples = make_samples<Sample>();
  SliceEncoderConfig config = test::slice_config(header, 4);
  config.levels = levels;
  std::vector<uint8_t> memory(Encoder::minimum_bytes(config));
  Line line;
  Encoder encoder;
  require_ok(encoder.start(config, {memory.data(), memory.size()}, line.output()));
  for (uint32_t row = 0; row < height * depth; ++row) {
    if (row == saved_row) {
      require_ok(encoder.write_record({9, 0, 0, record_bytes, sizeof record_bytes}));
      require_ok(encoder.flush());
    }
    require_ok(row == lost_row ? encoder.skip_row(Substitute::off).status
                               : encoder.push(&samples[size_t{row} * width], width).status);
  }
  require_ok(encoder.finish());
  return line.bytes;
}

template <class Sample, class Encoder = SliceEncoder, class Row = Sample>
void compare(const discmc_slice_kind& kind, discmc_sample_type type, const std::vector<Row>& rows,
             uint8_t levels = 0) {
  Line line(7), other_line(7);
  Scan scan(kind, levels, line);
  scan.start();
  scan.push_rows(type, rows, 0, saved_row);
  const discmc_application_record record = {9, 0, 0, record_bytes, sizeof record_bytes};
  REQUIRE(completed(DISCMC_SUSPENDED, [&] {
            return discmc_slice_encoder_write_record(scan.encoder, &record);
          }) == DISCMC_OK);

  // The power fails after a part of a frame was written; the frame is sent again.
  for (int i = 0; i < 2; ++i) CHECK(discmc_slice_encoder_flush(scan.encoder) == DISCMC_SUSPENDED);
  discmc_memory part;
  REQUIRE(discmc_slice_encoder_save(scan.encoder, &part) == DISCMC_OK);
  CHECK(part.data == scan.config.memory.data);
  Scan later(kind, levels, other_line);
  CHECK(discmc_slice_encoder_restore(&later.encoder, &later.config) == DISCMC_BAD_CHECKPOINT);
  std::copy_n(static_cast<uint8_t*>(part.data), part.bytes,
              static_cast<uint8_t*>(later.config.memory.data));
  if (&kind == &discmc_slices_u8) {
    later.config.kind = &discmc_slices_i16;
    CHECK(discmc_slice_encoder_restore(&later.encoder, &later.config) == DISCMC_BAD_CHECKPOINT);
    later.config.kind = &kind;
  }
  REQUIRE(discmc_slice_encoder_restore(&later.encoder, &later.config) == DISCMC_OK);
  discmc_slice_encoder_info info = discmc_slice_encoder_get_info(later.encoder);
  CHECK(info.slices == saved_row / height);
  CHECK(info.rows == saved_row % height);
  CHECK(info.stream_bytes < line.bytes.size());
  line.bytes.resize(info.stream_bytes);
  REQUIRE(completed(DISCMC_SUSPENDED, [&] { return discmc_slice_encoder_flush(later.encoder); }) ==
          DISCMC_OK);
  later.push_rows(type, rows, saved_row, height * depth);
  REQUIRE(later.done(discmc_slice_encoder_finish(later.encoder)) == DISCMC_OK);
  CHECK((scan.memory.is_intact() && later.memory.is_intact()));
  line.bytes.insert(line.bytes.end(), other_line.bytes.begin(), other_line.bytes.end());
  info = discmc_slice_encoder_get_info(later.encoder);
  CHECK(info.stream_bytes == line.bytes.size());
  CHECK(info.slices == depth);
  CHECK(line.bytes == stream_of_cpp<Encoder, Sample>(levels));
}

}  // namespace

TEST_CASE("slice encoders of every kind write the same bytes in C as in C++") {
  compare<uint8_t>(discmc_slices_u8, DISCMC_U8, make_samples<uint8_t>());
  compare<uint16_t>(discmc_slices_u16, DISCMC_U16, make_samples<uint16_t>());
  compare<int16_t>(discmc_slices_i16, DISCMC_I16, make_samples<int16_t>());
  compare<uint8_t>(discmc_slices_bits, DISCMC_BITS,
                   bits_of(make_samples<uint8_t>(), width, {100, 130, 60}));
}

TEST_CASE("slice encoders with fractions write the same bytes in C as in C++") {
  for (const uint8_t levels : std::initializer_list<uint8_t>{2, 4}) {
    compare<uint8_t, FractionSliceEncoder<uint8_t>>(discmc_fraction_slices_u8, DISCMC_U8,
                                                    make_samples<uint8_t>(), levels);
    compare<uint16_t, FractionSliceEncoder<uint16_t>>(discmc_fraction_slices_u16, DISCMC_U16,
                                                      make_samples<uint16_t>(), levels);
    compare<int16_t, FractionSliceEncoder<int16_t>>(discmc_fraction_slices_i16, DISCMC_I16,
                                                    make_samples<int16_t>(), levels);
  }
}

TEST_CASE("a slice encoder in C accepts only 2 or 4 levels of fractions") {
  CHECK(Scan::min_bytes(discmc_fraction_slices_u8, 3) == 0);
  Line line;
  Scan scan(discmc_fraction_slices_u8, 3, line, 10000);
  CHECK(discmc_slice_encoder_start(&scan.encoder, &scan.config) == DISCMC_BAD_LABEL);
}

TEST_CASE("a slice encoder in C drops its stream and abandons its scan as in C++") {
  Line line, cpp_line;
  Scan scan(discmc_slices_u8, 0, line);
  scan.config.surface_count = 1;
  scan.start();
  SliceEncoder encoder;
  std::vector<uint8_t> memory(10000);
  const StreamHeader header{width,           height,       depth, {1000, -2000, 3000},
                            {thresholds[0]}, Border::open, 5,     300};
  require_ok(encoder.start(test::slice_config(header, 4), {memory.data(), memory.size()},
                           cpp_line.output()));
  const auto samples = make_samples<uint8_t>();
  for (uint32_t row = 0; row < lost_row; ++row) {
    if (row == 10) {
      discmc_slice_encoder_set_output(scan.encoder, {});
      encoder.set_output({});
    }
    if (row == 20) {
      discmc_slice_encoder_set_output(scan.encoder, scan.config.output);
      encoder.set_output(cpp_line.output());
    }
    scan.push_rows(DISCMC_U8, samples, row, row + 1);
    require_ok(encoder.push(&samples[size_t{row} * width], width).status);
  }
  CHECK(discmc_slice_encoder_finish(scan.encoder) == DISCMC_SLICE_IN_PROGRESS);
  CHECK(discmc_slice_encoder_abandon(scan.encoder) == DISCMC_OK);
  require_ok(encoder.abandon());
  CHECK(line.bytes == cpp_line.bytes);
}

TEST_CASE("saving a suspended slice encoder in C is refused") {
  Line line;
  Scan scan(discmc_slices_u8, 0, line);
  scan.config.output.write = [](void*, const uint8_t*, size_t) { return size_t{0}; };
  scan.start();
  const auto samples = make_samples<uint8_t>();
  const discmc_push_result result = discmc_slice_encoder_push(
      scan.encoder, DISCMC_U8, samples.data(), static_cast<uint32_t>(samples.size()), 1);
  CHECK(result.status == DISCMC_SUSPENDED);
  CHECK(result.accepted == width);
  discmc_memory part{};
  CHECK(discmc_slice_encoder_save(scan.encoder, &part) == DISCMC_SUSPENDED);
  CHECK(part.data == nullptr);
}

TEST_CASE("invalid calls of slice encoders in C return their status") {
  Line line;
  Scan scan(discmc_slices_u8, 0, line);
  const discmc_slice_encoder_config good = scan.config;
  const auto status_of = [&](auto change) {
    scan.config = good;
    change(scan.config);
    return discmc_slice_encoder_start(&scan.encoder, &scan.config);
  };
  using Config = discmc_slice_encoder_config;
  CHECK(status_of([](Config& c) { c.limits.height = 0; }) == DISCMC_BAD_LIMITS);
  CHECK(status_of([](Config& c) { c.kind = nullptr; }) == DISCMC_NO_KIND);
  CHECK(status_of([](Config& c) { c.surface_count = 5; }) == DISCMC_BAD_LABEL);
  CHECK(status_of([](Config& c) { c.label.channel = 62; }) == DISCMC_BAD_LABEL);
  CHECK(status_of([](Config& c) { c.output.write = nullptr; }) == DISCMC_BAD_SINK);
  CHECK(status_of([](Config& c) { --c.memory.bytes; }) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(scan.encoder == nullptr);
  CHECK(status_of([](Config& c) { c.surface_count = 0; }) == DISCMC_OK);  // one
  CHECK(status_of([](Config&) {}) == DISCMC_OK);

  const uint8_t samples[width] = {};
  CHECK(discmc_slice_encoder_push(scan.encoder, DISCMC_I16, samples, 1, 1).status ==
        DISCMC_BAD_SAMPLES);
  CHECK(discmc_slice_encoder_push(scan.encoder, DISCMC_U8, samples, 1, 1).status == DISCMC_OK);
  CHECK(discmc_slice_encoder_skip_row(scan.encoder, DISCMC_SUBSTITUTE_OFF).status ==
        DISCMC_ROW_IN_PROGRESS);
  const discmc_application_record too_long = {4, 0, 0, samples, DISCMC_MAX_RECORD_BYTES + 1};
  CHECK(discmc_slice_encoder_write_record(scan.encoder, &too_long) == DISCMC_BAD_RECORD);
  CHECK(discmc_slice_encoder_abandon(scan.encoder) == DISCMC_OK);
  CHECK(discmc_slice_encoder_push(scan.encoder, DISCMC_U8, samples, 1, 1).status ==
        DISCMC_FINISHED);

  Scan bits(discmc_slices_bits, 0, line);
  bits.start();
  CHECK(discmc_slice_encoder_push(bits.encoder, DISCMC_BITS, samples, 1, 1).status ==
        DISCMC_BAD_SAMPLES);
  discmc_memory part;
  REQUIRE(discmc_slice_encoder_save(bits.encoder, &part) == DISCMC_OK);
  bits.config.output.write = nullptr;
  CHECK(discmc_slice_encoder_restore(&bits.encoder, &bits.config) == DISCMC_BAD_SINK);
}
