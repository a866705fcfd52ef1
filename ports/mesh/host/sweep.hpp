// The sweep of the extractor for PCs: faster, with the same events.
//
// Chains are nodes (chains.hpp). Only holes, the rings around them, loose fragments, and rings that
// a busy sink interrupts become runs in slots, as in firmware. The memory of nodes and slots grows.
#ifndef DISCMC_MESH_HOST_SWEEP_HPP
#define DISCMC_MESH_HOST_SWEEP_HPP

#include "one_ring_region.hpp"

#include <memory>

#include <discmc/trace/delivery.hpp>
#include "chains.hpp"

namespace discmc::host {

/// Replaces detail::trace::Sweep in an extractor.
class Sweep {
 public:
  static constexpr bool is_lean = false;
  static constexpr std::uint32_t max_slices = CornerCode::max_slices;
  using Fragments = detail::trace::Fragments<std::uint32_t, detail::trace::NoNormal>;
  using Delivery = detail::trace::Delivery<std::uint32_t, detail::trace::NoNormal, true>;

  /// The capacities are ignored.
  void start(Arena& arena, const Capacities& capacities);
  /// Sets the initial sizes, and the initial number of slots. Limit: before the first start().
  void set_sizes(const ChainSizes& sizes, std::uint32_t slots) {
    chains_.set_sizes(sizes);
    max_slots_ = slots;
  }
  void set_receiver(const RegionReceiver& receiver) { receiver_ = receiver; }
  void clear();

  const Fragments& fragments() const { return fragments_; }
  const Delivery& delivery() const { return delivery_; }

  /// May keep the last edges for the next call. Returns false if the sink is busy: call again.
  bool sweep(const detail::trace::SweptRow& row, const detail::trace::BitIntake& intake,
             const Sink& sink, Statistics& statistics);
  bool flush(const Sink& sink, Statistics& statistics);
  bool deliver_remaining_holes(const Sink& sink, Statistics& statistics);

  /// Returns the fraction of a triangle of classic Marching Cubes that the statistics round down:
  /// cells at a seam belong to two slabs. Units: CountParts::triangle per triangle. Limit: after
  /// the last row.
  std::uint32_t left_triangle_parts() const { return counts_.triangle_parts(); }

 private:
  using Slot = detail::trace::Slot<std::uint32_t, detail::trace::NoNormal>;
  using Outgoing = detail::trace::Outgoing<std::uint32_t>;

  void process_edges(Statistics& statistics);
  bool deliver(const Sink& sink, Statistics& statistics);
  bool deliver_ring(const Sink& sink, Statistics& statistics);
  std::uint8_t& hole_mark(const OneRingRegion& region);
  bool may_have_holes(const OneRingRegion& region);
  bool send_events(const OneRingRegion& region, const Sink& sink, Statistics& statistics);
  void set_outgoing(Outgoing::Kind kind, const std::uint64_t* corners, std::uint32_t count);
  void ensure_slots(std::uint64_t count);

  bool is_due_ = false;  // rings or complete fragments may wait for delivery
  bool has_base_ = false;
  std::int32_t base_ = 0;  // the first slice with edges; codes count from it
  RegionReceiver receiver_;
  Edges edges_;
  FoundPasses found_;
  Chains chains_;
  detail::trace::SweepCounts counts_;
  std::uint8_t hole_marks_[1U << 12] = {};
  std::unique_ptr<Slot[]> slots_;
  std::uint32_t max_slots_ = 1U << 12;
  Fragments fragments_;
  Delivery delivery_;
};

}  // namespace discmc::host

#endif
