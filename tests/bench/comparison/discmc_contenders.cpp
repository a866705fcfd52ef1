#include <discmc/discmc.hpp>

#include <vector>

#include "array.hpp"
#include "contenders.hpp"
#include "discmc/mesh.hpp"
#include "extraction/selection.hpp"
#include "host/host_scan.hpp"

namespace discmc::bench {

namespace {

struct Counter {
  uint64_t regions = 0;
  uint64_t fragments = 0;

  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::region) ++regions;
    if (event.kind == Event::Kind::fragment) ++fragments;
    return SinkResult::accepted;
  }
  SinkResult accept_region(const OneRingRegion&) {
    ++regions;
    return SinkResult::accepted;
  }
};

// A volume, and the memory for its extraction.
class Scan {
 public:
  explicit Scan(const Volume& volume) : volume_(volume) {}

  // regions: receives whole regions before the sink receives their events.
  void extract(const Sink& sink, const RegionReceiver& regions = {}) {
    scan_.start({volume_.width, volume_.height, Border::open}, sink, regions);
    std::visit([this](const auto& samples) { push(samples.data()); }, volume_.samples);
    scan_.finish();
  }

  StreamHeader header() const {
    StreamHeader header;
    header.width = volume_.width;
    header.height = volume_.height;
    header.depth = volume_.depth;
    header.thresholds[0] = volume_.threshold;
    header.border = Border::open;
    return header;
  }

 private:
  template <class Sample>
  void push(const Sample* samples) {
    meshing::SampleGrid grid;
    grid.dims = {volume_.width, volume_.height, volume_.depth};
    grid.type = meshing::type_of<Sample>();
    const meshing::SliceSelector selector(grid, {static_cast<double>(volume_.threshold)});
    const size_t row_bytes = meshing::bit_row_bytes(volume_.width);
    std::vector<uint8_t> bits(row_bytes * volume_.height);
    for (uint32_t z = 0; z < volume_.depth; ++z, samples += volume_.width * volume_.height) {
      selector.select(samples, bits.data(), row_bytes);
      for (size_t at = 0; at < bits.size(); at += row_bytes) scan_.push(bits.data() + at);
    }
  }

  const Volume& volume_;
  meshing::HostScan scan_;
};

// Polygons in arrays, like those of a mesh: a region has rings, a ring has corners. The start of a
// ring is kept even if it lies within a side.
class Polygons {
 public:
  SinkResult accept(const Event& event) {
    switch (event.kind) {
      case Event::Kind::region:
        regions_.push_back({event.incidence, rings_.size()});
        break;
      case Event::Kind::ring:
        rings_.push_back({event.is_hole, corners_.size()});
        at_ = event.start;
        direction_ = none;
        break;
      case Event::Kind::run:
        add(event.run);
        break;
      default:
        break;
    }
    return SinkResult::accepted;
  }
  SinkResult accept_region(const OneRingRegion& region) {
    regions_.push_back({region.incidence(), rings_.size()});
    rings_.push_back({false, corners_.size()});
    const size_t first = corners_.size();
    corners_.resize(first + region.corner_count());
    for (uint32_t i = 0; i < region.corner_count(); ++i) corners_[first + i] = region.corner(i);
    return SinkResult::accepted;
  }

  uint64_t corners() const { return corners_.size(); }

 private:
  struct Region {
    Incidence incidence;
    size_t first_ring;
  };
  struct Ring {
    bool is_hole;
    size_t first_corner;
  };
  static constexpr Direction none = 8;

  void add(Run run) {
    if (run.direction() != direction_) corners_.push_back(at_);
    direction_ = run.direction();
    const Vertex step = direction_vector(regions_.back().incidence, direction_);
    const auto length = static_cast<int32_t>(run.length());
    at_ = at_ + Vertex{step.x * length, step.y * length, step.z * length};
  }

  meshing::Array<Region> regions_;
  meshing::Array<Ring> rings_;
  meshing::Array<Vertex> corners_;
  Vertex at_{};
  Direction direction_ = none;
};

size_t discard_bytes(void*, const uint8_t*, size_t count) {
  return count;
}

}  // namespace

std::vector<Contender> discmc_contenders(const Volume& volume) {
  const auto scan = std::make_shared<Scan>(volume);
  const auto count = [scan] {
    Counter counter;
    scan->extract(make_sink(counter), make_region_receiver(counter));
    if (counter.fragments != 0) throw std::runtime_error("the memory is too little");
    return counter.regions;
  };
  const auto keep = [scan] {
    Polygons polygons;
    scan->extract(make_sink(polygons), make_region_receiver(polygons));
    return polygons.corners();
  };
  const auto stream = [scan] {
    Encoder encoder;
    meshing::require(encoder.start(scan->header().label(), {nullptr, discard_bytes}));
    scan->extract(make_sink(encoder));
    return encoder.bytes();
  };
  return {
      {"counting", "regions", count}, {"polygons", "corners", keep}, {"stream", "bytes", stream}};
}

}  // namespace discmc::bench
