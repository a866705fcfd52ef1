// The sweep of the extractor for PCs: faster, with the same events, as long as memory suffices.
//
// Chains are nodes (chains.hpp). If they need too many slots, the firmware's sweep takes over.
#ifndef DISCMC_MESH_HOST_SWEEP_HPP
#define DISCMC_MESH_HOST_SWEEP_HPP

#include "one_ring_region.hpp"

#include <discmc/trace/sweep.hpp>
#include "chains.hpp"

namespace discmc::host {

/// Replaces detail::trace::Sweep in an extractor.
class Sweep : private detail::trace::Sweep<uint32_t, NoNormal> {
 public:
  static constexpr bool is_lean = false;
  using FirmwareSweep = detail::trace::Sweep<uint32_t, NoNormal>;

  using FirmwareSweep::delivery;
  using FirmwareSweep::fragments;

  void start(Arena& arena, const Capacities& capacities) {
    FirmwareSweep::start(arena, capacities);
    receiver_ = {};
  }
  void set_capacities(const ChainCapacities& capacities) { chains_.set_capacities(capacities); }
  void set_receiver(const RegionReceiver& receiver) { receiver_ = receiver; }
  void clear();
  /// May keep the last edges for the next call.
  bool sweep(const detail::trace::SweptRow& row, const BitIntake& intake, const Sink& sink,
             Statistics& statistics);
  bool flush(const Sink& sink, Statistics& statistics);
  bool deliver_remaining_holes(const Sink& sink, Statistics& statistics);

  /// Returns the fraction of a triangle of classic Marching Cubes that the statistics round down:
  /// cells at a seam belong to two slabs. Units: CountParts::triangle per triangle. Limit: after
  /// the last row.
  uint32_t left_triangle_parts() const;

 private:
  using Slots = Chains::Slots;

  bool sweep_as_firmware(const detail::trace::SweptRow& row, const BitIntake& intake,
                         const Sink& sink, Statistics& statistics);
  bool ensure_room(const detail::trace::SweptRow& row);
  void hand_over(const detail::trace::SweptRow& row);
  void process_edges(Statistics& statistics);
  bool deliver(const Sink& sink, Statistics& statistics);
  bool may_have_holes(const OneRingRegion& region);
  bool deliver_ring(const Sink& sink, Statistics& statistics);
  OneRingRegion found_region(uint64_t& links);
  bool send_events(const OneRingRegion& region, const Sink& sink, Statistics& statistics);

  Slots& slots() { return fragments_.slots(); }

  bool keeps_nodes_ = false;
  bool is_due_ = false;               // rings or complete fragments may wait for delivery
  bool has_ends_from_below_ = false;  // whether queues count ends from below a slab
  uint32_t handed_word_ = 0;          // the word of a row at which chains were handed over
  RegionReceiver receiver_;
  Edges edges_;
  FoundPasses found_;
  Chains chains_;
};

}  // namespace discmc::host

#endif
