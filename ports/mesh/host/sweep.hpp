// The sweep of a host: faster, and with the same events, while there is memory to spare.
//
// It keeps chains as nodes (chains.hpp). When too many slots would be in use, it hands them over to
// the firmware's sweep, which continues.
#ifndef DISCMC_MESH_HOST_SWEEP_HPP
#define DISCMC_MESH_HOST_SWEEP_HPP

#include "whole_region.hpp"

#include <discmc/trace/sweep.hpp>
#include "chains.hpp"

namespace discmc::host {

/// Replaces detail::trace::Sweep in an extractor.
class Sweep : private detail::trace::Sweep<uint32_t, NoNormal> {
 public:
  static constexpr bool is_lean = false;
  using Plain = detail::trace::Sweep<uint32_t, NoNormal>;

  using Plain::delivery;
  using Plain::fragments;

  void start(Arena& arena, const Capacities& capacities) {
    Plain::start(arena, capacities);
    receiver_ = {};
  }
  void set_room(const ChainRoom& room) { chains_.set_room(room); }
  void set_receiver(const RegionReceiver& receiver) { receiver_ = receiver; }
  void clear();
  /// May leave the last edges for later.
  bool sweep(const detail::trace::SweptRow& row, const BitIntake& intake, const Sink& sink,
             Statistics& statistics);
  bool flush(const Sink& sink, Statistics& statistics);
  bool settle_holes(const Sink& sink, Statistics& statistics);

  /// What the statistics leave out of the triangles of classic Marching Cubes: the share of a slab
  /// in cells at its seams. Units: CountParts::triangle to a triangle. Limit: after the last row.
  uint32_t left_triangle_parts() const;

 private:
  using Slots = Chains::Slots;

  bool sweep_plain(const detail::trace::SweptRow& row, const BitIntake& intake, const Sink& sink,
                   Statistics& statistics);
  bool make_room(const detail::trace::SweptRow& row);
  void hand_over(const detail::trace::SweptRow& row);
  void take_edges(Statistics& statistics);
  bool deliver(const Sink& sink, Statistics& statistics);
  bool may_have_holes(const WholeRegion& region);
  bool deliver_ring(const Sink& sink, Statistics& statistics);
  WholeRegion region_found(uint64_t& links);
  bool send_events(const WholeRegion& region, const Sink& sink, Statistics& statistics);

  Slots& slots() { return fragments_.slots(); }

  bool keeps_nodes_ = false;
  bool is_due_ = false;       // something may have to be delivered
  bool below_waits_ = false;  // ends from below a slab wait in the queues, or were counted as lost
  uint32_t handed_word_ = 0;  // where in a row chains were handed over
  RegionReceiver receiver_;
  Edges edges_;
  FoundPasses found_;
  Chains chains_;
};

}  // namespace discmc::host

#endif
