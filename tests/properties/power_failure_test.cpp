// No polygon is lost if the power fails, whatever the output queues. Follows the recipe of
// docs/power-failure.md in C++ and in C, with both encoders, and with two surfaces.
#include <discmc/discmc.h>

#include <deque>
#include <discmc/checkpoint_store.hpp>
#include <discmc/receiver.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/surface_group.hpp>
#include <functional>

#include "oracle/simulated_flash.hpp"
#include "oracle/slice_config.hpp"
#include "oracle/stream.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::SimulatedFlash;

namespace {

constexpr uint32_t size = 6;
constexpr Limits limits{size, size};
constexpr size_t arena_bytes = Extractor16::minimum_bytes(limits) + 400;  // sends fragments, too
constexpr int32_t thresholds[] = {110, 150};
constexpr FlashGeometry geometry{128, 1024, 24};
constexpr uint32_t max_bytes = 8000;

// ---- the power supply, and the parts that depend on it ----

/// Fails after a number of events.
struct Power {
  uint64_t left = UINT64_MAX;
  uint64_t events = 0;

  bool is_on() const { return left > 0; }
  /// Whether the power lasts for one more event.
  bool survives() {
    ++events;
    if (left != UINT64_MAX && left > 0) --left;
    return is_on();
  }
};

/// A radio that queues bytes, and sends up to 20 of them per event.
class Radio {
 public:
  Radio(Power& power, size_t capacity) : power_(power), capacity_(capacity) {}

  ByteOutput output() {
    return {this,
            [](void* radio, const uint8_t* bytes, size_t count) {
              return static_cast<Radio*>(radio)->write(bytes, count);
            },
            [](void* radio) { return static_cast<Radio*>(radio)->unsent(); }};
  }
  size_t unsent() {
    work();
    return queue_.size();
  }

  Bytes received;

 private:
  size_t write(const uint8_t* bytes, size_t count) {
    work();
    if (capacity_ > 0) count = std::min(count, capacity_ - queue_.size());
    if (power_.is_on()) queue_.insert(queue_.end(), bytes, bytes + count);
    if (capacity_ == 0) send(queue_.size());
    return count;
  }
  void work() {
    if (!power_.survives()) queue_.clear();
    send(20);
  }
  void send(size_t count) {
    const auto end = queue_.begin() + static_cast<std::ptrdiff_t>(std::min(count, queue_.size()));
    received.insert(received.end(), queue_.begin(), end);
    queue_.erase(queue_.begin(), end);
  }

  Power& power_;
  size_t capacity_;
  std::deque<uint8_t> queue_;
};

/// A flash whose last operation is interrupted if the power fails.
class Flash {
 public:
  explicit Flash(Power& power) : power_(power) {}

  FlashDevice device() { return {this, read, program, erase, nullptr, geometry}; }
  void power_on() { flash_.power_on(); }
  bool has_broken_rules() const { return flash_.has_broken_rules; }

  static int read(void* flash, uint32_t block, uint32_t offset, void* to, uint32_t bytes) {
    const FlashDevice device = next(flash);
    return device.read(device.context, block, offset, to, bytes);
  }
  static int program(void* flash, uint32_t block, uint32_t offset, const void* from,
                     uint32_t bytes) {
    const FlashDevice device = next(flash);
    return device.program(device.context, block, offset, from, bytes);
  }
  static int erase(void* flash, uint32_t block) {
    const FlashDevice device = next(flash);
    return device.erase(device.context, block);
  }

 private:
  static FlashDevice next(void* context) {
    auto& flash = *static_cast<Flash*>(context);
    if (!flash.power_.is_on())
      flash.flash_.cut_after(0);
    else if (!flash.power_.survives())
      flash.flash_.cut_after(1 + flash.power_.events % 100);
    return flash.flash_.device();
  }

  Power& power_;
  SimulatedFlash flash_{geometry};
};

// ---- stores ----

class Store {
 public:
  Status start(Flash& flash) { return store_.start(flash.device(), max_bytes, memory_of(buffer_)); }
  bool has_checkpoint() const { return store_.has_checkpoint(); }
  Status restore(const std::vector<Memory>& parts) {
    return store_.restore(parts.data(), static_cast<uint32_t>(parts.size()));
  }
  Status save(const std::vector<Memory>& parts) {
    return store_.save(parts.data(), static_cast<uint32_t>(parts.size()));
  }
  Status discard() { return store_.discard(); }
  Status resume() { return store_.resume(); }

 private:
  CheckpointStore store_;
  uint8_t buffer_[geometry.program_bytes] = {};
};

class StoreInC {
 public:
  Status start(Flash& flash) {
    discmc_store_config config{};
    config.context = &flash;
    config.read = Flash::read;
    config.program = Flash::program;
    config.erase = Flash::erase;
    config.program_bytes = geometry.program_bytes;
    config.block_bytes = geometry.block_bytes;
    config.blocks = geometry.blocks;
    config.max_bytes = max_bytes;
    config.memory = {memory_, sizeof memory_};
    return static_cast<Status>(discmc_store_start(&store_, &config));
  }
  bool has_checkpoint() const { return discmc_store_get_info(store_).has_checkpoint != 0; }
  Status restore(const std::vector<Memory>& parts) { return call(discmc_store_restore, parts); }
  Status save(const std::vector<Memory>& parts) { return call(discmc_store_save, parts); }
  Status discard() { return static_cast<Status>(discmc_store_discard(store_)); }
  Status resume() { return static_cast<Status>(discmc_store_resume(store_)); }

 private:
  template <class Function>
  Status call(Function function, const std::vector<Memory>& parts) {
    std::vector<discmc_memory> in_c;
    for (const Memory& part : parts) in_c.push_back({part.data, part.bytes});
    return static_cast<Status>(function(store_, in_c.data(), static_cast<uint32_t>(in_c.size())));
  }

  discmc_store* store_ = nullptr;
  uint8_t memory_[DISCMC_STORE_BYTES(geometry.program_bytes)] = {};
};

// ---- devices ----

/// The objects of a device, in RAM that a power failure clears.
class Device {
 public:
  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  virtual ~Device() = default;

  virtual Status start(const ByteOutput& output) = 0;
  virtual std::vector<Memory> memories() = 0;
  virtual Status restore(const ByteOutput& output) = 0;
  virtual Status save(std::vector<Memory>& parts) = 0;
  virtual uint32_t row() const = 0;
  virtual Status push(const uint8_t* samples) = 0;
  virtual Status resume() = 0;
  virtual Status finish() = 0;
};

class PolygonDevice : public Device {
 public:
  Status start(const ByteOutput& output) override {
    const Status status = encoder_.start({size}, output);
    if (status != Status::ok) return status;
    return extractor_.start(limits, thresholds[0], memory_of(memory_), make_sink(encoder_));
  }
  std::vector<Memory> memories() override {
    return {memory_of(encoder_), memory_of(extractor_), memory_of(memory_)};
  }
  Status restore(const ByteOutput& output) override {
    const Status status = encoder_.restore(output);
    if (status != Status::ok) return status;
    return extractor_.restore(memory_of(memory_), make_sink(encoder_));
  }
  Status save(std::vector<Memory>& parts) override {
    parts.resize(3);
    const Status status = encoder_.save(&parts[0]);
    return status == Status::ok ? extractor_.save(&parts[1]) : status;
  }
  uint32_t row() const override { return extractor_.slices() * size + extractor_.rows(); }
  Status push(const uint8_t* samples) override { return extractor_.push(samples, size).status; }
  Status resume() override { return extractor_.resume(); }
  Status finish() override { return extractor_.finish(); }

 private:
  Encoder encoder_;
  Extractor16 extractor_;
  uint8_t memory_[arena_bytes] = {};
};

class TwoSurfaceDevice : public Device {
 public:
  Status start(const ByteOutput& output) override {
    link_.start(output);
    for (uint8_t i = 0; i < 2; ++i) {
      StreamLabel label{size};
      label.channel = i;
      Status status = encoders_[i].start(label, link_.output());
      if (status == Status::ok)
        status = extractors_[i].start(limits, thresholds[i], memory_of(memories_[i]),
                                      make_sink(encoders_[i]));
      if (status != Status::ok && status != Status::suspended) return status;
    }
    return group_.resume();
  }
  std::vector<Memory> memories() override {
    return {memory_of(encoders_[0]), memory_of(encoders_[1]),   memory_of(extractors_[0]),
            memory_of(memories_[0]), memory_of(extractors_[1]), memory_of(memories_[1])};
  }
  Status restore(const ByteOutput& output) override {
    link_.start(output);
    for (uint8_t i = 0; i < 2; ++i) {
      Status status = encoders_[i].restore(link_.output());
      if (status == Status::ok)
        status = extractors_[i].restore(memory_of(memories_[i]), make_sink(encoders_[i]));
      if (status != Status::ok) return status;
    }
    return Status::ok;
  }
  Status save(std::vector<Memory>& parts) override {
    parts.resize(6);
    Status status = encoders_[0].save(&parts[0]);
    if (status == Status::ok) status = encoders_[1].save(&parts[1]);
    if (status == Status::ok) status = extractors_[0].save(&parts[2]);
    if (status == Status::ok) status = extractors_[1].save(&parts[4]);
    return status;
  }
  uint32_t row() const override { return extractors_[0].slices() * size + extractors_[0].rows(); }
  Status push(const uint8_t* samples) override { return group_.push(samples, size).status; }
  Status resume() override { return group_.resume(); }
  // The link may still deliver a last frame.
  Status finish() override {
    const Status status = group_.finish();
    return status == Status::ok ? link_.flush() : status;
  }

 private:
  SharedOutput link_;
  Encoder encoders_[2];
  Extractor16 extractors_[2];
  uint8_t memories_[2][arena_bytes] = {};
  SurfaceGroup<Extractor16> group_{extractors_, 2, size};
};

class SliceDevice : public Device {
 public:
  Status start(const ByteOutput& output) override {
    StreamHeader header;
    header.width = size;
    header.height = size;
    header.depth = size;
    header.surface_count = 2;
    std::copy_n(thresholds, 2, header.thresholds);
    return encoder_.start(test::slice_config(header, 4), memory_of(memory_), output);
  }
  std::vector<Memory> memories() override { return {memory_of(encoder_), memory_of(memory_)}; }
  Status restore(const ByteOutput& output) override {
    return encoder_.restore(memory_of(memory_), output);
  }
  Status save(std::vector<Memory>& parts) override {
    parts.resize(2);
    return encoder_.save(parts.data());
  }
  uint32_t row() const override { return encoder_.slices() * size + encoder_.rows(); }
  Status push(const uint8_t* samples) override { return encoder_.push(samples, size).status; }
  Status resume() override { return encoder_.resume(); }
  Status finish() override { return encoder_.finish(); }

 private:
  SliceEncoder encoder_;
  uint8_t memory_[SliceEncoder::minimum_bytes({limits, {}, 4, 2})] = {};
};

// The output for objects in C.
discmc_byte_output in_c(const ByteOutput& output) {
  return {output.context, output.write, output.unsent, output.max_frame};
}

class PolygonDeviceInC : public Device {
 public:
  Status start(const ByteOutput& output) override { return begin(output, false); }
  std::vector<Memory> memories() override {
    return {memory_of(encoder_memory_), memory_of(extractor_memory_)};
  }
  Status restore(const ByteOutput& output) override { return begin(output, true); }
  Status save(std::vector<Memory>& parts) override {
    discmc_memory part[2];
    discmc_status status = discmc_encoder_save(encoder_, &part[0]);
    if (status == DISCMC_OK) status = discmc_extractor_save(extractor_, &part[1]);
    parts = {{part[0].data, part[0].bytes}, {part[1].data, part[1].bytes}};
    return static_cast<Status>(status);
  }
  uint32_t row() const override {
    const discmc_extractor_info info = discmc_extractor_get_info(extractor_);
    return info.slices * size + info.rows;
  }
  Status push(const uint8_t* samples) override {
    return static_cast<Status>(
        discmc_extractor_push(extractor_, DISCMC_U8, samples, size, 1).status);
  }
  Status resume() override { return static_cast<Status>(discmc_extractor_resume(extractor_)); }
  Status finish() override { return static_cast<Status>(discmc_extractor_finish(extractor_)); }

 private:
  Status begin(const ByteOutput& output, bool restores) {
    discmc_encoder_config stream{};
    stream.kind = &discmc_regions;
    stream.label.depth = size;
    stream.memory = {encoder_memory_, sizeof encoder_memory_};
    stream.output = in_c(output);
    discmc_status status = restores ? discmc_encoder_restore(&encoder_, &stream)
                                    : discmc_encoder_start(&encoder_, &stream);
    discmc_extractor_config scan{};
    scan.kind = &discmc_plain_u8;
    scan.limits = {size, size, DISCMC_CLOSED};
    scan.threshold = thresholds[0];
    scan.memory = {extractor_memory_, sizeof extractor_memory_};
    scan.sink = {encoder_, discmc_encoder_accept};
    if (status == DISCMC_OK)
      status = restores ? discmc_extractor_restore(&extractor_, &scan)
                        : discmc_extractor_start(&extractor_, &scan);
    return static_cast<Status>(status);
  }

  uint8_t encoder_memory_[DISCMC_ENCODER_BYTES] = {};
  uint8_t extractor_memory_[DISCMC_EXTRACTOR_BYTES(size, size, 60)] = {};
  discmc_encoder* encoder_ = nullptr;
  discmc_extractor* extractor_ = nullptr;
};

// levels: of fractions, or 0.
template <const discmc_slice_kind& kind, uint8_t surfaces, uint8_t levels>
class SliceDeviceInC : public Device {
 public:
  Status start(const ByteOutput& output) override {
    const discmc_slice_encoder_config config = config_for(output);
    return static_cast<Status>(discmc_slice_encoder_start(&encoder_, &config));
  }
  std::vector<Memory> memories() override { return {memory_of(memory_)}; }
  Status restore(const ByteOutput& output) override {
    const discmc_slice_encoder_config config = config_for(output);
    return static_cast<Status>(discmc_slice_encoder_restore(&encoder_, &config));
  }
  Status save(std::vector<Memory>& parts) override {
    discmc_memory part{};
    const discmc_status status = discmc_slice_encoder_save(encoder_, &part);
    parts = {{part.data, part.bytes}};
    return static_cast<Status>(status);
  }
  uint32_t row() const override {
    const discmc_slice_encoder_info info = discmc_slice_encoder_get_info(encoder_);
    return info.slices * size + info.rows;
  }
  Status push(const uint8_t* samples) override {
    return static_cast<Status>(
        discmc_slice_encoder_push(encoder_, DISCMC_U8, samples, size, 1).status);
  }
  Status resume() override { return static_cast<Status>(discmc_slice_encoder_resume(encoder_)); }
  Status finish() override { return static_cast<Status>(discmc_slice_encoder_finish(encoder_)); }

 private:
  discmc_slice_encoder_config config_for(const ByteOutput& output) {
    discmc_slice_encoder_config config{};
    config.kind = &kind;
    config.limits = {size, size, DISCMC_CLOSED};
    config.surface_count = surfaces;
    std::copy_n(thresholds, surfaces, config.thresholds);
    config.key_slice_interval = 4;
    config.levels = levels;
    config.label.depth = size;
    config.memory = {memory_, sizeof memory_};
    config.output = in_c(output);
    return config;
  }

  uint8_t memory_[4000] = {};
  discmc_slice_encoder* encoder_ = nullptr;
};

// ---- the recipe ----

Bytes samples() {
  Bytes all(size * size * size);
  Chance chance(5);
  for (uint8_t& sample : all) sample = chance.byte();
  return all;
}

/// Runs from power-on to the end of the scan, or until the power fails. Returns whether it
/// continued a scan.
template <class AnyStore>
bool run(Device& device, Power& power, Radio& radio, Flash& flash) {
  AnyStore store;
  const auto finish = [&](Status status, const std::function<Status()>& resume) {
    while (power.is_on() && status == Status::suspended) status = resume();
    return status == Status::ok && power.is_on();
  };
  const auto complete = [&](Status status) {
    return finish(status, [&] { return store.resume(); });
  };
  const auto over = [&](Status status) { return finish(status, [&] { return device.resume(); }); };
  const ByteOutput output = radio.output();

  if (store.start(flash) != Status::ok) return false;
  const bool continues = store.has_checkpoint() && store.restore(device.memories()) == Status::ok &&
                         device.restore(output) == Status::ok;
  if (!continues && (!complete(store.discard()) || !over(device.start(output)))) return false;

  const Bytes all = samples();
  for (uint32_t row = device.row(); row < size * size; ++row) {
    if (row % 7 == 5) {
      std::vector<Memory> parts;
      const Status saved = finish(device.save(parts), [&] { return device.save(parts); })
                               ? store.save(parts)
                               : Status::device_error;
      if (!complete(saved)) return continues;
    }
    if (!over(device.push(&all[size_t{row} * size]))) return continues;
  }
  const auto ended = [&] { return device.finish(); };
  if (!finish(device.finish(), ended)) return continues;
  while (power.is_on() && radio.unsent() > 0) continue;
  if (power.is_on()) (void)complete(store.discard());
  return continues;
}

/// Returns the events of each scan that a receiver of a channel reports.
std::vector<Events> scans_on(uint8_t channel, const Bytes& received) {
  std::vector<Events> scans;
  EventLog log;
  Bytes memory(Receiver::minimum_bytes(limits, 2) + 20000);
  Receiver receiver;
  reference::require_ok(receiver.start(memory_of(memory), make_sink(log), channel));
  for (size_t at = 0;;) {
    const Decoded decoded = receiver.push(received.data() + at, received.size() - at);
    at += decoded.bytes;
    if (decoded.status != Status::finished) break;
    REQUIRE(receiver.report().has_trailer);
    REQUIRE(receiver.report().lost_packets == 0);
    scans.push_back(std::move(log.events));
    log.events.clear();
  }
  REQUIRE_FALSE(receiver.report().has_header);
  return scans;
}

template <class AnyDevice, class AnyStore = Store>
void check_every_failure(uint8_t surfaces, uint32_t stride) {
  const auto run_device = [](Power& power, Radio& radio, Flash& flash) {
    return run<AnyStore>(*std::make_unique<AnyDevice>(), power, radio, flash);
  };
  for (const size_t capacity : {size_t{0}, size_t{20}, size_t{300}, size_t{1024}}) {
    CAPTURE(capacity);
    Power whole_power;
    Radio whole(whole_power, capacity);
    Flash whole_flash(whole_power);
    run_device(whole_power, whole, whole_flash);
    std::vector<Events> expected;
    for (uint8_t channel = 0; channel < surfaces; ++channel)
      expected.push_back(scans_on(channel, whole.received).at(0));
    uint32_t continued = 0;
    for (uint64_t cut = 1; cut <= whole_power.events; cut += stride) {
      CAPTURE(cut);
      Power power{cut};
      Radio radio(power, capacity);
      Flash flash(power);
      run_device(power, radio, flash);
      REQUIRE_FALSE(power.is_on());
      power.left = UINT64_MAX;
      flash.power_on();
      radio.received.push_back(0);
      if (run_device(power, radio, flash)) ++continued;
      // A failure after the end begins another scan, which is equal.
      for (uint8_t channel = 0; channel < surfaces; ++channel) {
        const std::vector<Events> scans = scans_on(channel, radio.received);
        REQUIRE((scans.size() == 1 || scans.size() == 2));
        for (const Events& scan : scans) REQUIRE(scan == expected[channel]);
      }
      REQUIRE_FALSE(flash.has_broken_rules());
      // The scan is finished, so the next power-on begins another.
      REQUIRE_FALSE(run_device(power, radio, flash));
    }
    CHECK(continued > 0);
  }
}

}  // namespace

TEST_CASE("no polygon is lost if the power fails: regions, in C++") {
  check_every_failure<PolygonDevice>(1, reference::step(37));
}

TEST_CASE("no polygon is lost if the power fails: regions, in C") {
  check_every_failure<PolygonDeviceInC, StoreInC>(1, reference::step(37));
}

TEST_CASE("no polygon is lost if the power fails: two surfaces on one link, in C++") {
  check_every_failure<TwoSurfaceDevice>(2, reference::step(37));
}

TEST_CASE("no polygon is lost if the power fails: slices of two surfaces, in C++") {
  check_every_failure<SliceDevice>(2, reference::step(37));
}

TEST_CASE("no polygon is lost if the power fails: slices of two surfaces, in C") {
  check_every_failure<SliceDeviceInC<discmc_slices_u8, 2, 0>, StoreInC>(2, reference::step(37));
}

TEST_CASE("no polygon is lost if the power fails: slices with fractions, in C") {
  check_every_failure<SliceDeviceInC<discmc_fraction_slices_u8, 1, 2>, StoreInC>(
      1, reference::step(37));
}
