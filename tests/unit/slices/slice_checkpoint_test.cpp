// Checkpoints of a slice encoder: a scan resumed after a power failure makes the stream of an
// uninterrupted scan.
#include "oracle/checkpointed_device.hpp"
#include "oracle/slice_config.hpp"
#include "oracle/slice_stream.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using reference::Block;
using reference::require_ok;

namespace {

struct DevicePlan {
  const char* name;
  uint32_t key_slice_interval;
  uint8_t surface_count;
  size_t max_bytes;  // bytes that the output accepts at a time
};

constexpr DevicePlan plans[] = {{"one key slice", {}, 1, SIZE_MAX},
                                {"every third is one", {3}, 1, SIZE_MAX},
                                {"all are", {1}, 1, SIZE_MAX},
                                {"several surfaces", {2}, 3, SIZE_MAX},
                                {"an output that lags behind", {3}, 2, 5}};

// A slice of this volume fills more than a packet.
BitVolume noise() {
  return reference::random({67, 40, 5}, 128, 1);
}
BitVolume smooth() {
  return centred_ball(21);
}

// A device that sends slices, with memory of its own, and its checkpoints.
class SliceDevice {
 public:
  SliceDevice(const BitVolume& volume, const DevicePlan& plan)
      : volume_(volume), key_slice_interval_(plan.key_slice_interval), header_(header_of(volume)) {
    header_.surface_count = plan.surface_count;
    for (int32_t& threshold : header_.thresholds) threshold = header_.thresholds[0];
    store.max_bytes = plan.max_bytes;
    const Limits limits{volume.width, volume.height};
    block_ = Block(
        SliceEncoder::minimum_bytes({limits, {}, key_slice_interval_, header_.surface_count}));
  }

  void start() {
    require_ok(encoder.start(test::slice_config(header_, key_slice_interval_), block_.memory(),
                             store.output()));
  }
  // Pushes rows up to a row number, counted through all slices.
  void scan_to(uint32_t end) {
    uint32_t row = encoder.slices() * volume_.height + encoder.rows();
    for (; row < end; ++row) {
      Status status = encoder.push(&volume_.on[size_t{row} * volume_.width], volume_.width).status;
      while (status == Status::suspended) status = encoder.resume();
      require_ok(status);
    }
  }
  void finish() {
    scan_to(rows());
    until_done([this] { return encoder.finish(); });
    CHECK(block_.is_intact());
  }
  uint32_t rows() const { return volume_.height * volume_.depth; }

  std::vector<Memory> parts() { return {memory_of(encoder), block_.memory()}; }
  Image save() {
    std::vector<Memory> parts(2);
    require_ok(encoder.save(parts.data()));
    return image_of(parts);
  }
  Status restore(const Image& image) {
    read_back(image, parts());
    return encoder.restore(block_.memory(), store.output());
  }

  Store store;
  SliceEncoder encoder;

 private:
  BitVolume volume_;
  uint32_t key_slice_interval_;
  StreamHeader header_;
  Block block_{0};
};

Bytes uninterrupted(const BitVolume& volume, const DevicePlan& plan) {
  SliceDevice device(volume, plan);
  device.start();
  device.finish();
  return device.store.bytes;
}

void append(Bytes& stream, const Bytes& more) {
  stream.insert(stream.end(), more.begin(), more.end());
}

}  // namespace

TEST_CASE("a checkpoint at any row continues a stream of slices with the same bytes") {
  for (const BitVolume& volume : {noise(), smooth()})
    for (const DevicePlan& plan : plans) {
      CAPTURE(plan.name);
      const Bytes whole = uninterrupted(volume, plan);
      SliceDevice first(volume, plan);
      first.start();
      for (uint32_t row = 0; row <= first.rows(); row += step(5)) {
        CAPTURE(row);
        first.scan_to(row);
        const Image image = first.save();
        SliceDevice second(volume, plan);
        REQUIRE(second.restore(image) == Status::ok);
        REQUIRE(second.encoder.slices() == row / volume.height);
        REQUIRE(second.encoder.rows() == row % volume.height);
        Bytes stream(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(second.encoder.bytes()));
        second.finish();
        append(stream, second.store.bytes);
        REQUIRE(stream == whole);
      }
    }
}

TEST_CASE(
    "rows, records and skipped rows sent before a checkpoint are not sent again after restore()") {
  SliceDevice first(smooth(), plans[1]), second(smooth(), plans[1]);
  first.start();
  first.scan_to(50);
  CHECK(first.encoder.skip_row(Substitute::previous_row).samples == 21);
  require_ok(first.encoder.flush());
  require_ok(first.encoder.write_record({7, 0, 0, nullptr, 0}));
  const Bytes before = first.store.bytes;
  REQUIRE(second.restore(first.save()) == Status::ok);
  REQUIRE(second.encoder.bytes() == before.size());
  first.finish();
  second.finish();
  Bytes stream = before;
  append(stream, second.store.bytes);
  CHECK(stream == first.store.bytes);
}

TEST_CASE("a flipped bit anywhere in a checkpoint of slices is detected") {
  SliceDevice device(centred_ball(5), plans[3]), other(centred_ball(5), plans[3]);
  device.start();
  device.scan_to(12);
  const Image image = device.save();
  CHECK(first_unnoticed_flip(image, other) == 8 * image.size());
  CHECK(other.restore(image) == Status::ok);
}

TEST_CASE("a finished scan of slices is restored as finished and sends its remaining bytes") {
  for (const bool goes_out : {true, false}) {
    CAPTURE(goes_out);
    SliceDevice device(smooth(), plans[0]), other(smooth(), plans[0]);
    device.start();
    device.scan_to(device.rows());
    require_ok(device.encoder.flush());
    const size_t before = device.store.bytes.size();
    if (!goes_out) device.store.max_bytes = 0;
    CHECK(device.encoder.finish() == (goes_out ? Status::ok : Status::suspended));
    REQUIRE(other.restore(device.save()) == Status::ok);
    device.store.max_bytes = SIZE_MAX;
    require_ok(device.encoder.finish());
    other.finish();
    const size_t missing = goes_out ? 0 : device.store.bytes.size() - before;
    CHECK(other.store.bytes.size() == missing);
  }
}

TEST_CASE("save() and restore() of a slice encoder refuse invalid calls with a status") {
  Store store;
  Memory parts[2];
  SliceEncoder encoder;
  CHECK(encoder.save(parts) == Status::not_started);
  CHECK(encoder.bytes_used() == 0);

  const StreamHeader header{999, 9, 0, {}, {1}};
  constexpr Limits limits{999, 9};
  alignas(4) static uint8_t memory[SliceEncoder::minimum_bytes({limits}) + 1] = {};
  const Memory whole{memory, sizeof memory - 1};
  require_ok(encoder.start(test::slice_config(header), whole, store.output()));
  CHECK(encoder.bytes_used() == whole.bytes);

  // The output accepts the header, and nothing of a row that fills a packet.
  require_ok(encoder.flush());
  store.max_bytes = 0;
  uint8_t samples[999];
  Chance chance(1);
  for (uint8_t& sample : samples) sample = chance.below(2) > 0 ? 1 : 0;
  Status status = Status::ok;
  while (status == Status::ok) status = encoder.push(samples, 999).status;
  REQUIRE(status == Status::suspended);
  CHECK(encoder.save(parts) == Status::suspended);
  store.max_bytes = SIZE_MAX;
  require_ok(encoder.resume());
  require_ok(encoder.save(parts));
  const Image image = image_of({parts, parts + 2});

  CHECK(encoder.restore({nullptr, whole.bytes}, store.output()) == Status::too_little_memory);
  CHECK(encoder.restore(whole, {}) == Status::bad_sink);
  CHECK(encoder.restore(whole, store.output()) == Status::ok);
  read_back(image, {parts, parts + 2});
  CHECK(encoder.restore({memory, whole.bytes - 1}, store.output()) == Status::bad_checkpoint);
  CHECK(encoder.resume() == Status::not_started);
  read_back(image, {parts, parts + 2});
  unpoison(memory, sizeof memory);  // red zones
  std::memmove(memory + 1, memory, whole.bytes);
  CHECK(encoder.restore({memory + 1, whole.bytes}, store.output()) == Status::bad_checkpoint);
}
