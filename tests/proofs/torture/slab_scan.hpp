// Scans one slab by one kind of extractor, with refusals and, on devices, checkpoints. After a
// checkpoint another extractor continues in other memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>
#include "host/host_extractor.hpp"

#include "oracle/checkpointed_device.hpp"
#include "oracle/scan.hpp"
#include "pieces.hpp"
#include "placed_volume.hpp"

namespace discmc::torture {

enum class Scanner : uint8_t { narrow, wide, host };

struct SlabPlan {
  uint32_t first, end;
  Scanner scanner;
  Capacities capacities;
  uint32_t refusals;     ///< refused offers per 256
  uint32_t checkpoints;  ///< at most, spread over the slab
  uint32_t chunk;        ///< samples per push; 0: rows of bits
  uint32_t seed;
};

/// Scans one slab from start to finish. Extractors are reused for later scans.
template <class Index, class Extractor>
class SlabScan {
 public:
  SlabScan(const PlacedVolume& volume, const SlabPlan& plan, Pieces& pieces)
      : volume_(volume), plan_(plan), sink_(pieces, {plan.refusals, plan.seed}) {
    block_ = std::make_unique<reference::Block>(bytes());
    reference::require_ok(
        active().start(limits(), plan.capacities, 1, block_->memory(), make_sink(sink_)));
  }

  void run() {
    const uint32_t first = plan_.first > 0 ? plan_.first - 1 : 0;
    const uint32_t end = std::min(plan_.end + 1, volume_.size.depth);
    const uint32_t rows = (end - first) * volume_.size.height;
    for (uint32_t row = 0; row < rows; ++row) {
      volume_.read_row(row % volume_.size.height, first + row / volume_.size.height, row_);
      push_row();
      // Not a divisor of slices, so pushes do not align with them.
      if (plan_.checkpoints > 0 && row % (rows / plan_.checkpoints + 1) == plan_.seed % 5)
        move_to_other();
    }
    reference::finish_all(active());
    if (!block_->is_intact()) throw std::runtime_error("a write outside the arena");
    const Peaks peaks = active().peaks();
    if (!has_own_memory &&
        (peaks.slots > plan_.capacities.slots || peaks.holes > plan_.capacities.holes))
      throw std::runtime_error("more in use than there is room for");
  }

 private:
  // A HostExtractor keeps chains and holes outside the arena, and has no checkpoints.
  static constexpr bool has_own_memory = std::is_same_v<Extractor, HostExtractor>;

  Limits limits() const { return volume_.limits_of_slab(plan_.first, plan_.end); }
  uint64_t bytes() const { return Extractor::bytes_for(limits(), plan_.capacities); }

  static Extractor& extractor(uint32_t number) {
    static Extractor extractors[2];
    return extractors[number];
  }
  Extractor& active() { return extractor(active_); }

  void push_row() {
    if (plan_.chunk > 0) return reference::push_all(active(), row_, plan_.chunk);
    bits_.assign((row_.size() + 7) / 8, 0xFF);  // bits beyond the row, which must be ignored
    for (size_t x = 0; x < row_.size(); ++x)
      if (row_[x] == 0) bits_[x / 8] = static_cast<uint8_t>(bits_[x / 8] & ~(1U << x % 8));
    for (;;) {
      const PushResult pushed = active().push_bits(bits_.data());
      if (pushed.samples == row_.size()) return;
      if (pushed.status != Status::suspended) throw std::runtime_error(to_string(pushed.status));
    }
  }

  void move_to_other() {
    if constexpr (!has_own_memory) move_arena();
  }
  void move_arena() {
    while (active().is_suspended())
      if (active().resume() != Status::suspended) break;
    auto other = std::make_unique<reference::Block>(bytes());
    Extractor& before = active();
    active_ = 1 - active_;
    reference::require_ok(test::move_scan(before, active(), other->memory(), make_sink(sink_)));
    if (!block_->is_intact()) throw std::runtime_error("a write outside the arena");
    block_ = std::move(other);
  }

  const PlacedVolume& volume_;
  const SlabPlan& plan_;
  RefusingSink<Pieces> sink_;
  std::unique_ptr<reference::Block> block_;
  uint32_t active_ = 0;
  std::vector<uint8_t> row_, bits_;
};

/// Returns the events of a slab. Errors: throws if the extractor reports an error or breaks a
/// promise.
inline Pieces scanned(const PlacedVolume& volume, const SlabPlan& plan) {
  Pieces pieces;
  const bool is_deep = plan.end - plan.first + 2 > host::CornerCode::max_slices;
  switch (plan.scanner == Scanner::host && is_deep ? Scanner::wide : plan.scanner) {
    case Scanner::narrow:
      SlabScan<uint16_t, Extractor16>(volume, plan, pieces).run();
      break;
    case Scanner::wide:
      SlabScan<uint32_t, Extractor32>(volume, plan, pieces).run();
      break;
    case Scanner::host:
      SlabScan<uint32_t, HostExtractor>(volume, plan, pieces).run();
      break;
  }
  return pieces;
}

}  // namespace discmc::torture
