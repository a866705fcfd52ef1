// Runs a whole volume through an extractor, with chosen portions and memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <discmc/extractor.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "collector.hpp"
#include "event_log.hpp"
#include "volume.hpp"

namespace discmc::reference {

/// A heap block of exactly the requested size, so that address sanitizers detect accesses beyond
/// it. Otherwise it has guard bytes on both sides, which is_intact() checks.
class Block {
 public:
  enum class Kind : uint8_t { exact, guarded };

  explicit Block(size_t bytes, Kind kind = Kind::guarded)
      : bytes_(bytes),
        guard_(kind == Kind::guarded ? 64 : 0),
        all_(new uint8_t[bytes_ + 2 * guard_]) {
    std::fill_n(all_.get(), bytes_ + 2 * guard_, filling);
  }

  Memory memory() { return {all_.get() + guard_, bytes_}; }

  bool is_intact() const {
    const auto is_filling = [](uint8_t byte) { return byte == filling; };
    const uint8_t* end = all_.get() + guard_ + bytes_;
    return std::all_of(all_.get(), all_.get() + guard_, is_filling) &&
           std::all_of(end, end + guard_, is_filling);
  }

 private:
  static constexpr uint8_t filling = 0xA5;
  size_t bytes_;
  size_t guard_;
  std::unique_ptr<uint8_t[]> all_;
};

/// The options of a test for scanning a volume.
struct Plan {
  Border border = Border::closed;
  uint32_t chunk = 0;  ///< samples per push; 0: the whole volume
};

/// Room for the volumes of the tests with any index, without loose fragments.
constexpr Capacities ample{32759, 32759};

inline Limits limits_of(const BitVolume& volume, Border border) {
  return {volume.width, volume.height, border};
}

/// Pushes all samples, and resumes as often as needed. Errors: throws if a status is an error.
template <class AnyExtractor, class Sample>
void push_all(AnyExtractor& extractor, const std::vector<Sample>& samples, uint32_t chunk = 0) {
  const auto total = static_cast<uint32_t>(samples.size());
  for (uint32_t at = 0; at < total;) {
    const uint32_t left = total - at;
    const uint32_t count = chunk == 0 || chunk > left ? left : chunk;
    const PushResult pushed = extractor.push(samples.data() + at, count);
    at += pushed.samples;
    if (pushed.status != Status::ok && pushed.status != Status::suspended)
      throw std::runtime_error(to_string(pushed.status));
  }
}

/// Ends a scan, and resumes as often as needed.
template <class AnyExtractor>
void finish_all(AnyExtractor& extractor) {
  Status status = extractor.finish();
  while (status == Status::suspended) status = extractor.finish();
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

inline void require_ok(Status status) {
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

/// Scans a volume of bits with explicit capacities. Errors: throws if the extractor reports an
/// error, writes outside its memory, or breaks the grammar.
template <class Index, class Receiver>
void scan_into(Receiver& receiver, const BitVolume& volume, const Plan& plan,
               const Capacities& capacities, Block::Kind kind = Block::Kind::guarded) {
  const Limits limits = limits_of(volume, plan.border);
  Block block(Extractor<Index>::bytes_for(limits, capacities), kind);
  Extractor<Index> extractor;
  require_ok(extractor.start(limits, capacities, 1, block.memory(), make_sink(receiver)));
  push_all(extractor, volume.on, plan.chunk);
  finish_all(extractor);
  if (!block.is_intact()) throw std::runtime_error("a write outside the arena");
}

/// Likewise scans with the default capacities for a number of bytes.
template <class Index, class Receiver>
void scan_into(Receiver& receiver, const BitVolume& volume, const Plan& plan, uint64_t bytes,
               Block::Kind kind = Block::Kind::guarded) {
  const Limits limits = limits_of(volume, plan.border);
  Block block(bytes, kind);
  Extractor<Index> extractor;
  require_ok(extractor.start(limits, 1, block.memory(), make_sink(receiver)));
  push_all(extractor, volume.on, plan.chunk);
  finish_all(extractor);
  if (!block.is_intact()) throw std::runtime_error("a write outside the arena");
}

/// Returns the regions of a volume, in sweep rings, with ample memory.
template <class Index>
Collector scan(const BitVolume& volume, const Plan& plan = {}) {
  Collector collector;
  scan_into<Index>(collector, volume, plan, ample);
  return collector;
}

/// Returns the limits of a slab of a volume, from `first` to before `end`.
inline Limits limits_of_slab(const BitVolume& volume, Border border, uint32_t first, uint32_t end) {
  Limits limits = limits_of(volume, border);
  limits.slab = {first, first > 0, end < volume.depth};
  return limits;
}
/// Returns the voxels of its slices, including context slices.
inline std::vector<uint8_t> voxels_of_slab(const BitVolume& volume, uint32_t first, uint32_t end) {
  const size_t slice = size_t{volume.width} * volume.height;
  const uint32_t from = first > 0 ? first - 1 : 0;
  const uint32_t to = end < volume.depth ? end + 1 : end;
  return {volume.on.data() + from * slice, volume.on.data() + to * slice};
}

/// Scans a volume in slabs of some slices; the last one may be thinner. Each slab has some bytes of
/// memory beyond the minimum. Errors: as scan_into().
template <class Index>
std::vector<Collector> scan_slabs(const BitVolume& volume, Border border, uint32_t slices,
                                  uint64_t spare, const EventLog::Refuses& refuses = {}) {
  std::vector<Collector> scans;
  for (uint32_t first = 0; first < volume.depth; first += slices) {
    const uint32_t end = std::min(first + slices, volume.depth);
    const Limits limits = limits_of_slab(volume, border, first, end);
    Block block(Extractor<Index>::minimum_bytes(limits) + spare);
    EventLog log(refuses);
    Extractor<Index> extractor;
    require_ok(extractor.start(limits, 1, block.memory(), make_sink(log)));
    push_all(extractor, voxels_of_slab(volume, first, end));
    finish_all(extractor);
    if (!block.is_intact()) throw std::runtime_error("a write outside the arena");
    scans.push_back(collected(log.events, limits.slab));
  }
  return scans;
}

}  // namespace discmc::reference
