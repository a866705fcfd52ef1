// The code in the guide: every block is part of a program that is built and run, here or in
// examples/.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <discmc/discmc.hpp>
#include <discmc/front/majority_filter.hpp>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/simulated_flash.hpp"
using namespace discmc;

namespace {

// ---- the code of the guide ----

constexpr uint32_t size = 32;
constexpr int32_t threshold = 128;

/// A ball that fades towards its rim.
struct Ball {
  uint8_t row[size];
  double noise = 0;  // its standard deviation
  std::mt19937 random{1};

  /// The row of a number, counted over all slices.
  const uint8_t* scan(uint32_t number) {
    std::normal_distribution<double> deviation(0, 1);
    const auto middle = static_cast<int32_t>(size) - 1;
    const auto y = static_cast<int32_t>(number % size), z = static_cast<int32_t>(number / size);
    for (int32_t x = 0; x < static_cast<int32_t>(size); ++x) {
      const Vertex v{2 * x - middle, 2 * y - middle, 2 * z - middle};
      const double sample = 255 - dot_product(v, v) / 4 + noise * deviation(random);
      row[x] = static_cast<uint8_t>(std::clamp(sample, 0.0, 255.0));
    }
    return row;
  }
};

using Bytes = std::vector<uint8_t>;

size_t append(void* bytes, const uint8_t* more, size_t count) {
  auto& all = *static_cast<Bytes*>(bytes);
  all.insert(all.end(), more, more + count);
  return count;
}

constexpr Limits limits{size, size};

struct Device {
  Extractor16 extractor;
  Encoder encoder;
  uint8_t memory[Extractor16::minimum_bytes(limits) + 16 * 1024];
};

bool begin(Device& device, const ByteOutput& output) {
  auto& [extractor, encoder, memory] = device;
  return encoder.start({size}, output) == Status::ok &&
         extractor.start(limits, threshold, memory_of(memory), make_sink(encoder)) == Status::ok;
}

Bytes stream_of(Ball ball) {
  Bytes bytes;
  Device device;
  REQUIRE(begin(device, {&bytes, append}));
  for (uint32_t i = 0; i < size * size; ++i)
    REQUIRE(device.extractor.push(ball.scan(i), size).status == Status::ok);
  REQUIRE(device.extractor.finish() == Status::ok);
  return bytes;
}

// From docs/quick-start.md.
constexpr SliceEncoderConfig config{limits, {threshold}, 16};
SliceEncoder slice_encoder;
uint8_t slice_memory[SliceEncoder::minimum_bytes(config)];

bool begin_slices(const ByteOutput& output) {
  return slice_encoder.start(config, memory_of(slice_memory), output) == Status::ok;
}

// From docs/quick-start.md.
constexpr SliceEncoderConfig fraction_config{limits, {threshold}, 16, 1, {}, 4};
FractionSliceEncoder<uint8_t> fraction_encoder;  // by the type of the samples
uint8_t fraction_memory[FractionSliceEncoder<uint8_t>::minimum_bytes(fraction_config)];

bool begin_fractions(const ByteOutput& output) {
  return fraction_encoder.start(fraction_config, memory_of(fraction_memory), output) == Status::ok;
}

// From docs/front-end.md.
MajorityFilter filter;
uint8_t filter_memory[MajorityFilter::bytes_for(limits)];

bool push_filtered(Extractor16& extractor, const uint8_t* bits) {
  const uint8_t* row = filter.push(bits);  // the row that is due, a slice and a row later
  return row == nullptr || extractor.push_bits(row).status == Status::ok;
}

bool finish_filtered(Extractor16& extractor) {
  while (const uint8_t* row = filter.drain())
    if (extractor.push_bits(row).status != Status::ok) return false;
  return extractor.finish() == Status::ok;
}

constexpr uint32_t pixels = 640, rows_held = 4;
alignas(32) uint8_t row_memory[RowRing::bytes_for(pixels * sizeof(uint16_t), rows_held)];
RowRing ring;

// The interrupt of the DMA controller: a row is complete. Returns the memory for the next row.
void* on_row() {
  if (ring.free_row(1) != nullptr)
    ring.commit();
  else
    ring.drop();  // the ring is full: the next row overwrites this one
  return ring.free_row();
}

// The task. Returns false if no row has arrived: sleep until the next interrupt.
bool take_row(Extractor16& extractor, Status& status) {
  switch (ring.peek()) {
    case RowRing::Next::none:
      return false;
    case RowRing::Next::ready: {
      auto* const samples = static_cast<uint16_t*>(ring.row());
      unpack(Packing::raw10, static_cast<const uint8_t*>(ring.row()), pixels, samples);
      status = extractor.push(samples, pixels).status;
      break;
    }
    case RowRing::Next::lost:
      status = extractor.skip_row(Substitute::previous_row).status;
      break;
    case RowRing::Next::end:
      status = extractor.finish();
      return true;
  }
  ring.pop();
  return true;
}

RowCropper cropper;

bool start_part(Extractor16& extractor, const Memory& memory, const Sink& sink) {
  const CropRange x{4, 24}, y{0, CropRange::rest}, z{0, CropRange::rest, 2};
  return cropper.start(limits, x, y, z) == Status::ok &&
         extractor.start(cropper.limits(), threshold, memory, sink) == Status::ok;
}

Status push_part(Extractor16& extractor, const uint8_t* row) {
  if (!cropper.next()) return Status::ok;  // outside the selection
  return extractor.push(row + cropper.first(), cropper.count(), cropper.step()).status;
}

Status push_levelled(Extractor16& extractor, const uint8_t* row, int32_t threshold_of_row) {
  static uint8_t bits[(size + 7) / 8];
  threshold_row(row, size, threshold_of_row, bits);  // or threshold_row_less()
  return extractor.push_bits(bits).status;
}

// From docs/receiving.md.
struct Outlines {
  Incidence incidence = no_incidence;  // of the region or fragment: incidence_normal(incidence)
  Vertex corner{};
  uint64_t lines = 0;

  SinkResult accept(const Event& event) {
    const bool is_fragment = event.kind == Event::Kind::fragment;
    if (event.kind == Event::Kind::region || is_fragment) incidence = event.incidence;
    if (event.kind == Event::Kind::ring || is_fragment) corner = event.start;
    if (event.kind == Event::Kind::run) {
      corner = after_run(incidence, corner, event.run);  // draw a line to here
      ++lines;
    }
    return SinkResult::accepted;  // or busy: the same event comes again
  }
};

Outlines outlines;
Joiner joiner;
uint8_t join_memory[192 * 1024];  // for 1,000 fragments
Receiver receiver;
uint8_t receiver_memory[256 * 1024];  // for slices of 256x256, and 14,000 slots

bool start_receiver() {
  return joiner.start(memory_of(join_memory), make_sink(outlines), InputOrder::sweep) ==
             Status::ok &&
         receiver.start(memory_of(receiver_memory), make_sink(joiner)) == Status::ok;
}

Status receive(const uint8_t* bytes, size_t count) {
  Decoded decoded{Status::suspended, 0};
  for (size_t pushed = 0; decoded.status == Status::suspended; pushed += decoded.bytes)
    decoded = receiver.push(bytes + pushed, count - pushed);
  return decoded.status;
}

bool finish_and_check() {
  while (receiver.finish() == Status::suspended) continue;
  while (joiner.finish() == Status::suspended) continue;
  return receiver.report().is_complete() && joiner.report().unmatched == 0 &&
         joiner.report().short_of_memory == 0;
}

UnitNormal normal_of(const Event& run, Incidence incidence, const StreamHeader& header) {
  if (!run.normal.is_none()) return unit_normal(run.normal);
  const Vertex n = incidence_normal(incidence);
  return unit_normal(weighted({n.x, n.y, n.z}, axis_weights(header.spacing_nm)));
}

reference::SimulatedFlash* nor = nullptr;

int nor_read(void*, uint32_t block, uint32_t offset, void* buffer, uint32_t bytes) {
  const FlashDevice device = nor->device();
  return device.read(device.context, block, offset, buffer, bytes);
}
int nor_program(void*, uint32_t block, uint32_t offset, const void* buffer, uint32_t bytes) {
  const FlashDevice device = nor->device();
  return device.program(device.context, block, offset, buffer, bytes);
}
int nor_erase(void*, uint32_t block) {
  const FlashDevice device = nor->device();
  return device.erase(device.context, block);
}

// From docs/power-failure.md.
constexpr FlashGeometry flash_geometry{256, 4096, 32};  // bytes per page and sector, sectors
constexpr uint32_t max_bytes = sizeof(Device);
static_assert(store_plan(flash_geometry, max_bytes).is_valid(), "the flash is too small");

// nor_read(), nor_program() and nor_erase() are your driver. The buffer holds one page.
Status start_store(CheckpointStore& store) {
  static uint8_t page[flash_geometry.program_bytes];
  const FlashDevice device{nullptr, nor_read, nor_program, nor_erase, nullptr, flash_geometry};
  return store.start(device, max_bytes, memory_of(page));
}

// Waits until a call of the store is over. Do urgent work between the steps.
Status complete(CheckpointStore& store, Status status) {
  while (status == Status::suspended) status = store.resume();
  return status;
}

// Before the first row of a scan: no older checkpoint may be continued from now on.
Status begin_scan(Device& device, CheckpointStore& store, const ByteOutput& output) {
  auto& [extractor, encoder, memory] = device;
  Status status = complete(store, store.discard());
  if (status == Status::ok) status = encoder.start({size}, output);
  if (status == Status::ok)
    status = extractor.start(limits, threshold, memory_of(memory), make_sink(encoder));
  while (status == Status::suspended) status = extractor.resume();
  return status;
}

// At power-on, after start_store(). Continue with row extractor.rows() of slice extractor.slices().
Status power_on(Device& device, CheckpointStore& store, const ByteOutput& output) {
  auto& [extractor, encoder, memory] = device;
  const Memory parts[] = {memory_of(encoder), memory_of(extractor), memory_of(memory)};
  if (store.has_checkpoint() && store.restore(parts, 3) == Status::ok &&
      encoder.restore(output) == Status::ok &&
      extractor.restore(memory_of(memory), make_sink(encoder)) == Status::ok)
    return Status::ok;
  return begin_scan(device, store, output);
}

// Between two rows. Status::suspended: the output is busy, or has unsent bytes. Call it again,
// before the next row.
Status save(Device& device, CheckpointStore& store) {
  Memory parts[3];
  Status status = device.extractor.resume();
  if (status == Status::ok) status = device.encoder.save(parts);
  if (status == Status::ok) status = device.extractor.save(parts + 1);
  return status == Status::ok ? complete(store, store.save(parts, 3)) : status;
}

// After the last slice.
Status end_scan(Device& device, CheckpointStore& store, const ByteOutput& output) {
  Status status = device.extractor.finish();
  while (status == Status::suspended) status = device.extractor.resume();
  while (status == Status::ok && output.unsent(output.context) > 0) continue;  // or sleep
  return status == Status::ok ? complete(store, store.discard()) : status;
}

}  // namespace

TEST_CASE("the guide's example sends a stream with fractions") {
  Bytes bytes;
  REQUIRE(begin_fractions({&bytes, append}));
  Ball ball;
  for (uint32_t i = 0; i < size * size; ++i)
    REQUIRE(fraction_encoder.push(ball.scan(i), size).status == Status::ok);
  REQUIRE(fraction_encoder.finish() == Status::ok);
  CHECK(bytes.size() > 700);
}

TEST_CASE("the guide's stream of slices yields the regions of the device") {
  Bytes bytes;
  REQUIRE(begin_slices({&bytes, append}));
  Ball ball;
  for (uint32_t i = 0; i < size * size; ++i)
    REQUIRE(slice_encoder.push(ball.scan(i), size).status == Status::ok);
  REQUIRE(slice_encoder.finish() == Status::ok);

  struct Count {
    uint64_t regions = 0;
    SinkResult accept(const Event& event) {
      if (event.kind == Event::Kind::region_end) ++regions;
      return SinkResult::accepted;
    }
  };
  const auto regions_of = [](const Bytes& stream) {
    static uint8_t memory[512 * 1024];
    Count count;
    SurfaceDecoder counting;
    REQUIRE(counting.start(memory_of(memory), make_sink(count)) == Status::ok);
    REQUIRE(counting.push(stream.data(), stream.size()).status == Status::ok);
    REQUIRE(counting.finish() == Status::ok);
    CHECK(counting.report().is_complete());
    return count.regions;
  };
  const Bytes regions = stream_of(ball);
  CHECK(regions_of(bytes) == regions_of(regions));
  CHECK(bytes.size() < regions.size() / 2);
}

TEST_CASE("the guide's receiver joins fragments to whole regions and detects a lost packet") {
  // So little memory that the device sends fragments.
  static uint8_t memory[Extractor16::minimum_bytes(limits) + 256];
  Bytes bytes;
  Encoder encoder;
  Extractor16 extractor;
  REQUIRE(encoder.start({size}, {&bytes, append}) == Status::ok);
  REQUIRE(extractor.start(limits, threshold, memory_of(memory), make_sink(encoder)) == Status::ok);
  Ball ball;
  for (uint32_t i = 0; i < size * size; ++i)
    REQUIRE(extractor.push(ball.scan(i), size).status == Status::ok);
  REQUIRE(extractor.finish() == Status::ok);
  REQUIRE(extractor.statistics().fragments > 0);

  REQUIRE(start_receiver());
  for (const uint8_t& byte : bytes)
    REQUIRE(receive(&byte, 1) == (&byte == &bytes.back() ? Status::finished : Status::ok));
  CHECK(finish_and_check());
  CHECK(joiner.report().received == extractor.statistics().fragments);
  CHECK(outlines.lines > 0);

  const auto middle =
      std::find(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), bytes.end(), 0);
  const auto next = std::find(middle + 1, bytes.end(), 0);
  bytes.erase(middle + 1, next + 1);
  REQUIRE(start_receiver());
  REQUIRE(receive(bytes.data(), bytes.size()) == Status::finished);
  CHECK_FALSE(finish_and_check());
}

TEST_CASE("the guide's filter removes most of the noise from the stream") {
  Ball noisy;
  noisy.noise = 20;
  Bytes bytes;
  Device device;
  REQUIRE(begin(device, {&bytes, append}));
  REQUIRE(filter.start(limits, memory_of(filter_memory)) == Status::ok);
  for (uint32_t i = 0; i < size * size; ++i) {
    const uint8_t* row = noisy.scan(i);
    uint8_t bits[size / 8] = {};
    for (uint32_t x = 0; x < size; ++x)
      if (row[x] >= threshold) bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | 1U << x % 8);
    REQUIRE(push_filtered(device.extractor, bits));
  }
  REQUIRE(finish_filtered(device.extractor));

  const size_t clean = stream_of({}).size();
  noisy.random.seed(1);
  CHECK(bytes.size() - clean < (stream_of(noisy).size() - clean) / 2);
}

TEST_CASE("the guide's normal is that of the run, or of the polygon if voxels are anisotropic") {
  StreamHeader header;
  header.spacing_nm[0] = header.spacing_nm[1] = 500000;
  header.spacing_nm[2] = 1000000;
  Event run{};
  const Incidence incidence = incidence_of({0, 1, 1});
  CHECK(normal_of(run, incidence, header) == unit_normal(LongVector{0, 2, 1}));
  run.normal = octahedral_normal({1, 0, 0});
  CHECK(normal_of(run, incidence, header) == unit_normal(run.normal));
}

TEST_CASE("the guide's task pushes the rows of the guide's interrupt and skips lost rows") {
  REQUIRE(ring.start(pixels * sizeof(uint16_t), rows_held, memory_of(row_memory)) == Status::ok);
  constexpr Limits row_limits{pixels, 1};
  static uint8_t memory[Extractor16::minimum_bytes(row_limits) + 16 * 1024];
  Bytes bytes;
  Encoder encoder;
  Extractor16 extractor;
  REQUIRE(encoder.start({}, {&bytes, append}) == Status::ok);
  REQUIRE(extractor.start(row_limits, 512, memory_of(memory), make_sink(encoder)) == Status::ok);
  Status status = Status::ok;
  CHECK_FALSE(take_row(extractor, status));
  void* place = ring.free_row();
  for (int row = 0; row < 6; ++row) {
    memset(place, row < 3 ? 0xFF : 0, packed_bytes(Packing::raw10, pixels));
    place = on_row();
  }
  // One place is always that of the row that comes.
  while (take_row(extractor, status)) REQUIRE(status == Status::ok);
  CHECK(extractor.slices() == 6);
  CHECK(ring.lost() == 3);
  ring.end();
  CHECK(take_row(extractor, status));
  CHECK(status == Status::ok);
  CHECK(extractor.statistics().skipped_rows == 3);
}

TEST_CASE("the guide's examples extract part of a volume and apply a threshold per row") {
  static uint8_t memory[Extractor16::minimum_bytes(limits) + 16 * 1024];
  Bytes bytes;
  Encoder encoder;
  Extractor16 extractor;
  REQUIRE(encoder.start({}, {&bytes, append}) == Status::ok);
  REQUIRE(start_part(extractor, memory_of(memory), make_sink(encoder)));
  CHECK(extractor.limits().width == 24);
  Ball ball;
  for (uint32_t i = 0; i < size * size; ++i)
    REQUIRE(push_part(extractor, ball.scan(i)) == Status::ok);
  CHECK(extractor.slices() == size / 2);
  REQUIRE(extractor.finish() == Status::ok);

  // A lamp that grows brighter, and a threshold that follows it.
  bytes.clear();
  Device device;
  REQUIRE(begin(device, {&bytes, append}));
  for (uint32_t i = 0; i < size * size; ++i) {
    const uint8_t* const row = ball.scan(i);
    uint8_t brighter[size];
    const uint32_t drift = i / 64;
    for (uint32_t x = 0; x < size; ++x)
      brighter[x] = static_cast<uint8_t>(std::min<uint32_t>(row[x] + drift, 255));
    REQUIRE(push_levelled(device.extractor, brighter, threshold + static_cast<int32_t>(drift)) ==
            Status::ok);
  }
  REQUIRE(device.extractor.finish() == Status::ok);
  CHECK(bytes == stream_of(ball));
}

TEST_CASE("the guide's example of power failures yields the stream of an uninterrupted scan") {
  Ball ball;
  const Bytes whole = stream_of(ball);

  Bytes bytes;
  const ByteOutput output{&bytes, append, [](void*) { return size_t{0}; }};
  reference::SimulatedFlash flash(flash_geometry);
  nor = &flash;
  static Device device;
  CheckpointStore store;
  REQUIRE(start_store(store) == Status::ok);
  REQUIRE(power_on(device, store, output) == Status::ok);
  const auto scan_to = [&ball](Device& scanner, uint32_t end) {
    uint32_t i = scanner.extractor.slices() * size + scanner.extractor.rows();
    for (; i < end; ++i) REQUIRE(scanner.extractor.push(ball.scan(i), size).status == Status::ok);
  };
  scan_to(device, 100);
  REQUIRE(save(device, store) == Status::ok);
  scan_to(device, 300);
  while (store.erase_ahead(max_bytes) == Status::suspended) scan_to(device, 301);
  REQUIRE(save(device, store) == Status::ok);
  scan_to(device, 700);
  flash.cut_after(3000);
  REQUIRE(save(device, store) == Status::device_error);

  flash.power_on();
  static Device rebooted;
  CheckpointStore found;
  REQUIRE(start_store(found) == Status::ok);
  REQUIRE(power_on(rebooted, found, output) == Status::ok);
  CHECK(rebooted.extractor.slices() * size + rebooted.extractor.rows() == 301);
  bytes.resize(rebooted.encoder.bytes());
  scan_to(rebooted, size * size);
  REQUIRE(end_scan(rebooted, found, output) == Status::ok);
  CHECK(bytes == whole);
  CHECK_FALSE(found.has_checkpoint());

  REQUIRE(begin_scan(rebooted, found, output) == Status::ok);
  CHECK(rebooted.extractor.rows() == 0);
}

// ---- the guide ----

namespace {

using Path = std::filesystem::path;
const Path root = DISCMC_SOURCE_DIR;

/// The lines of a file between two ends of lines, without their indent.
std::string lines_of(std::istream& text) {
  std::string lines = "\n";
  for (std::string line; std::getline(text, line);)
    lines += line.substr(std::min(line.find_first_not_of(' '), line.size())) + "\n";
  return lines;
}

std::string lines_of(const Path& path) {
  std::ifstream file(path);
  REQUIRE_MESSAGE(file.is_open(), path.string());
  return lines_of(file);
}

/// The blocks of code in C and C++ of a page.
std::vector<std::string> blocks_of(const std::string& page) {
  std::vector<std::string> blocks;
  for (const std::string fence : {"\n```cpp\n", "\n```c\n"})
    for (size_t begin = page.find(fence); begin != std::string::npos;
         begin = page.find(fence, begin + 1)) {
      const size_t first = begin + fence.size() - 1;
      blocks.push_back(page.substr(first, page.find("\n```", first) + 1 - first));
    }
  return blocks;
}

}  // namespace

TEST_CASE("every C and C++ code block of the guide is part of a built program") {
  std::vector<std::string> programs{lines_of(root / "tests/packaging/guide_test.cpp"),
                                    lines_of(root / "tests/packaging/mesh_guide_test.cpp")};
  for (const auto& file : std::filesystem::directory_iterator(root / "examples"))
    if (file.path().extension() == ".cpp" || file.path().extension() == ".c")
      programs.push_back(lines_of(file.path()));

  size_t count = 0;
  for (const auto& file : std::filesystem::directory_iterator(root / "docs")) {
    if (file.path().extension() != ".md") continue;
    for (const std::string& block : blocks_of(lines_of(file.path()))) {
      ++count;
      INFO(file.path().string(), block);
      CHECK(std::any_of(programs.begin(), programs.end(), [&block](const std::string& program) {
        return program.find(block) != std::string::npos;
      }));
    }
  }
  CHECK(count >= 5);
}
