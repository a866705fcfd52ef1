#include "proofs/doubling/pipelines.hpp"
#include "oracle/scan.hpp"
#include "oracle/slice_config.hpp"

#include <algorithm>
#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/joiner.hpp>
#include <discmc/slice_decoder.hpp>
#include <discmc/slice_encoder.hpp>
#include <memory>
#include <stdexcept>
#include <vector>
#include "host/host_extractor.hpp"

namespace discmc::doubling {

using reference::BitVolume;
using reference::require_ok;

// A volume, and the number of vertices of its surface.
struct Scanned {
  explicit Scanned(const BitVolume& bits) : volume(bits) {
    const size_t row = bits.width, slice = row * bits.height;
    for (size_t i = 0; i < bits.on.size(); ++i)
      for (const size_t step : {size_t{1}, row, slice})
        vertices += bits.on[i] != (i < step ? 0 : bits.on[i - step]) ? 1U : 0U;
    vertices += 2 * slice;
  }
  const BitVolume& volume;
  uint64_t vertices = 0;
};

namespace {

// ---- counting ----

Efforts* efforts = nullptr;
Part running = tests;

// Counts the blocks of a part during its lifetime.
class Running {
 public:
  explicit Running(Part part) : before_(running) { running = part; }
  ~Running() { running = before_; }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  Part before_;
};

// A sink in front of a part. Counts its events as work of the part before and of the part behind.
// Only extractors follow each link.
template <class Next>
class Metered {
 public:
  Metered(Next& next, Part part, Part before) : next_(next), part_(part), before_(before) {}

  SinkResult accept(const Event& event) {
    ++efforts->by_part[part_].work;
    ++efforts->by_part[before_].work;
    if (before_ == extractor && event.kind == Event::Kind::run)
      efforts->by_part[extractor].work += event.run.length();
    const Running running_part(part_);
    return next_.accept(event);
  }
  SinkResult accept_region(const OneRingRegion& region) {
    efforts->by_part[part_].work += 3 + region.corner_count();
    efforts->by_part[before_].work += 3 + region.corner_count();
    for (uint32_t i = 0; i < region.corner_count(); ++i)
      efforts->by_part[before_].work += region.run(i).length();
    const Running running_part(part_);
    return next_.accept_region(region);
  }

 private:
  Next& next_;
  Part part_, before_;
};

struct Nowhere {
  SinkResult accept(const Event&) { return SinkResult::accepted; }
  SinkResult accept_region(const OneRingRegion&) { return SinkResult::accepted; }
};

// ---- behind an extractor ----

// Joins events, with memory for all vertices. Clearing the joiner's table is little work.
class Joined {
 public:
  Joined(const Scanned& scanned, InputOrder order, Part before)
      : end_(nowhere_, tests, joiner), begin_(joiner_, joiner, before) {
    memory_.resize(1000 + 256 * scanned.vertices);
    require_ok(joiner_.start(memory_of(memory_), make_sink(end_), order));
    efforts->by_part[joiner].work += joiner_.capacities().fragments / 3;
  }
  Sink sink() { return make_sink(begin_); }
  void finish() {
    const Running part(joiner);
    require_ok(joiner_.finish());
  }

 private:
  Nowhere nowhere_;
  Metered<Nowhere> end_;
  std::vector<uint8_t> memory_;
  Joiner joiner_;
  Metered<Joiner> begin_;
};

// Encodes events, decodes the packets, and joins the decoded events.
class Streamed {
 public:
  explicit Streamed(const Scanned& scanned)
      : joined_(scanned, InputOrder::sweep, decoder), begin_(encoder_, encoder, extractor) {
    require_ok(decoder_.start(joined_.sink()));
    require_ok(encoder_.start({}, {this, [](void* context, const uint8_t* bytes, size_t count) {
                                     return static_cast<Streamed*>(context)->decode(bytes, count);
                                   }}));
  }
  Sink sink() { return make_sink(begin_); }
  void finish() {
    {
      const Running part(decoder);
      require_ok(decoder_.finish());
    }
    joined_.finish();
  }

 private:
  size_t decode(const uint8_t* bytes, size_t count) {
    efforts->by_part[encoder].work += count;
    efforts->by_part[decoder].work += count;
    const Running part(decoder);
    const Decoded decoded = decoder_.push(bytes, count);
    require_ok(decoded.status);
    return decoded.bytes;
  }

  Joined joined_;
  Decoder decoder_;
  Encoder encoder_;
  Metered<Encoder> begin_;
};

// ---- extractors ----

// As many slots and holes as any of the volumes needs.
Capacities ample_for(const Scanned& scanned) {
  const auto slots = static_cast<uint32_t>(8 * scanned.vertices);
  return {slots, slots};
}

template <class Scanner>
struct Scan {
  Scan(const Limits& limits, const Capacities& capacities, const Sink& sink)
      : bytes(Extractor<Index>::bytes_for(limits, capacities)), memory(new uint8_t[bytes]) {
    require_ok(scanner.start(limits, capacities, 1, {memory.get(), bytes}, sink));
  }
  // Pushes row by row, as a device does.
  void push(const BitVolume& volume, uint32_t first, uint32_t end) {
    const Running part(extractor);
    for (uint32_t z = first; z < end; ++z)
      for (uint32_t y = 0; y < volume.height; ++y)
        require_ok(scanner.push(&volume.on[volume.index(0, y, z)], volume.width).status);
    require_ok(scanner.finish());
    efforts->by_part[extractor].work += size_t{end - first} * volume.height * volume.width;
  }

  using Index = std::conditional_t<std::is_same_v<Scanner, Extractor16>, uint16_t, uint32_t>;
  uint64_t bytes;
  std::unique_ptr<uint8_t[]> memory;  // uninitialised memory
  Scanner scanner;
};

void scan(const Scanned& scanned, const Capacities& capacities) {
  const BitVolume& volume = scanned.volume;
  Streamed streamed(scanned);
  Scan<Extractor32> scan({volume.width, volume.height}, capacities, streamed.sink());
  scan.push(volume, 0, volume.depth);
  streamed.finish();
}

// Extracts slabs of one slice, or of sixteen, and joins everything that crosses their seams.
template <class Scanner>
void scan_slabs(const Scanned& scanned) {
  const BitVolume& volume = scanned.volume;
  Joined joined(scanned, InputOrder::any, extractor);
  const uint32_t thickness = volume.depth < 16 ? 1 : volume.depth / 16;
  for (uint32_t first = 0; first < volume.depth; first += thickness) {
    const uint32_t end = std::min(first + thickness, volume.depth);
    Limits limits{volume.width, volume.height};
    limits.slab = {first, first > 0, end < volume.depth};
    Scan<Scanner> scan(limits, ample_for(scanned), joined.sink());
    scan.push(volume, first - (first > 0 ? 1 : 0), end + (end < volume.depth ? 1 : 0));
  }
  joined.finish();
}

// Encodes slices, and decodes them.
class Sliced {
 public:
  explicit Sliced(const BitVolume& volume) {
    const Limits limits{volume.width, volume.height};
    memory_.resize(SliceDecoder::minimum_bytes(limits));
    require_ok(decoder_.start(memory_of(memory_), make_row_sink(nowhere_)));
    slices_.resize(SliceEncoder::minimum_bytes({limits}));
    const StreamHeader header{volume.width, volume.height, volume.depth, {}, {1}};
    require_ok(encoder_.start(test::slice_config(header), memory_of(slices_), output()));
  }
  void run(const BitVolume& volume) {
    const Running part(encoder);
    for (size_t voxel = 0; voxel < volume.voxels(); voxel += volume.width)
      require_ok(encoder_.push(&volume.on[voxel], volume.width).status);
    require_ok(encoder_.finish());
    efforts->by_part[encoder].work += volume.voxels();
    efforts->by_part[decoder].work += volume.voxels();
  }

 private:
  struct Rows {
    SinkResult accept(const RowEvent&) { return SinkResult::accepted; }
  };
  ByteOutput output() {
    return {this, [](void* context, const uint8_t* bytes, size_t count) {
              efforts->by_part[encoder].work += count;
              efforts->by_part[decoder].work += count;
              const Running part(decoder);
              const Decoded decoded = static_cast<Sliced*>(context)->decoder_.push(bytes, count);
              require_ok(decoded.status);
              return decoded.bytes;
            }};
  }

  Rows nowhere_;
  std::vector<uint8_t> memory_, slices_;
  SliceDecoder decoder_;
  SliceEncoder encoder_;
};

// ---- the table ----

void firmware(const Scanned& scanned) {
  scan(scanned, ample_for(scanned));
}
// Slots for a few rows only, so most fragments are sent loose.
void firmware_short(const Scanned& scanned) {
  scan(scanned, {100 + 2 * scanned.volume.width, scanned.volume.width});
}
void firmware_least(const Scanned& scanned) {
  scan(scanned, minimum_capacities());
}
// Encodes whole regions by one call.
void host(const Scanned& scanned) {
  const BitVolume& volume = scanned.volume;
  Nowhere nowhere;
  Metered<Nowhere> metered(nowhere, tests, extractor);
  Scan<HostExtractor> scan({volume.width, volume.height}, ample_for(scanned), make_sink(metered));
  scan.scanner.set_region_receiver(make_region_receiver(metered));
  scan.push(volume, 0, volume.depth);
}
void slices(const Scanned& scanned) {
  Sliced(scanned.volume).run(scanned.volume);
}

}  // namespace

const Pipeline pipelines[] = {{"firmware", firmware},
                              {"firmware, short", firmware_short},
                              {"firmware, least", firmware_least},
                              {"host", host},
                              {"slabs", scan_slabs<Extractor32>},
                              {"slabs, host", scan_slabs<HostExtractor>},
                              {"slices", slices}};
const size_t pipeline_count = sizeof pipelines / sizeof pipelines[0];

Efforts run(const Pipeline& pipeline, const BitVolume& volume) {
  const Scanned scanned(volume);
  Efforts counts;
  efforts = &counts;
  pipeline.run(scanned);
  efforts = nullptr;
  return counts;
}

}  // namespace discmc::doubling

// The compiler's instrumentation requires this name.
extern "C" void __sanitizer_cov_trace_pc();  // NOLINT(bugprone-reserved-identifier)
void __sanitizer_cov_trace_pc() {            // NOLINT(bugprone-reserved-identifier)
  using namespace discmc::doubling;
  if (efforts != nullptr) ++efforts->by_part[running].blocks;
}
