#include <discmc/discmc.hpp>
#include "host/host_extractor.hpp"

#include <memory>
#include <stdexcept>

#include "contenders.hpp"

namespace discmc::bench {

namespace {

void require_ok(Status status) {
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

// With so much nothing goes out loose. What is never used is never touched.
constexpr size_t arena_bytes = size_t{64} << 20;

struct Counter {
  uint64_t regions = 0;
  uint64_t fragments = 0;

  SinkResult take(const Event& event) {
    if (event.kind == Event::Kind::region) ++regions;
    if (event.kind == Event::Kind::fragment) ++fragments;
    return SinkResult::accepted;
  }
  SinkResult take_region(const WholeRegion&) {
    ++regions;
    return SinkResult::accepted;
  }
};

// A volume, and the memory for its extraction.
class Scan {
 public:
  explicit Scan(const Volume& volume) : volume_(volume), memory_(new uint8_t[arena_bytes]) {}

  // The receiver is the sink, and is offered regions before their events.
  template <class Receiver>
  void extract(Receiver& receiver) {
    require_ok(extractor_.start(limits(), volume_.threshold, {memory_.get(), arena_bytes},
                                make_sink(receiver)));
    extractor_.set_region_receiver(make_region_receiver(receiver));
    const uint32_t slice = volume_.width * volume_.height;
    std::visit(
        [&](const auto& samples) {
          for (uint32_t z = 0; z < volume_.depth; ++z)
            require_ok(extractor_.push(samples.data() + size_t{z} * slice, slice).status);
        },
        volume_.samples);
    require_ok(extractor_.finish());
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
  Limits limits() const { return {volume_.width, volume_.height, Border::open}; }

  const Volume& volume_;
  std::unique_ptr<uint8_t[]> memory_;
  HostExtractor extractor_;
};

// Polygons in arrays, as meshes are kept: a region has rings, a ring has corners. The vertex where
// a ring starts is kept even within a side.
class Polygons {
 public:
  SinkResult take(const Event& event) {
    switch (event.kind) {
      case Event::Kind::region:
        regions_.push_back({event.incidence, rings_.size()});
        break;
      case Event::Kind::ring:
        rings_.push_back({event.hole, corners_.size()});
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
  SinkResult take_region(const WholeRegion& region) {
    regions_.push_back({region.incidence, rings_.size()});
    rings_.push_back({false, corners_.size()});
    at_ = region.start;
    direction_ = none;
    for (uint32_t i = 0; i < region.count; ++i) add(region.runs[i]);
    return SinkResult::accepted;
  }

  uint64_t corners() const { return corners_.size(); }

 private:
  struct Region {
    Incidence incidence;
    size_t first_ring;
  };
  struct Ring {
    bool hole;
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

  std::vector<Region> regions_;
  std::vector<Ring> rings_;
  std::vector<Vertex> corners_;
  Vertex at_{};
  Direction direction_ = none;
};

size_t take_bytes(void*, const uint8_t*, size_t count) {
  return count;
}

}  // namespace

std::vector<Contender> discmc_contenders(const Volume& volume) {
  const auto scan = std::make_shared<Scan>(volume);
  const auto count = [scan] {
    Counter counter;
    scan->extract(counter);
    if (counter.fragments != 0) throw std::runtime_error("the memory is too little");
    return counter.regions;
  };
  const auto keep = [scan] {
    Polygons polygons;
    scan->extract(polygons);
    return polygons.corners();
  };
  const auto stream = [scan] {
    Encoder encoder;
    require_ok(encoder.start(scan->header().label(), {nullptr, take_bytes}));
    scan->extract(encoder);
    return encoder.bytes();
  };
  return {
      {"counting", "regions", count}, {"polygons", "corners", keep}, {"stream", "bytes", stream}};
}

}  // namespace discmc::bench
