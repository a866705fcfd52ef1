// The sweep sends the passes at the vertices of a row to the fragments. It may be suspended between
// any two passes.
#ifndef DISCMC_TRACE_SWEEP_HPP
#define DISCMC_TRACE_SWEEP_HPP

#include <discmc/trace/delivery.hpp>
#include <discmc/trace/derived_passes.hpp>

namespace discmc::detail::trace {

/// is_lean: see LeanExtractor16.
template <class Index, class Normal, bool lean = false>
class Sweep {
 public:
  static constexpr bool is_lean = lean;
  static constexpr uint32_t max_slices = Limits::max_slices;

  /// Allocates its part of the arena, and writes nothing there; clear() does. The slots come last,
  /// so that slots that were never used are behind all others.
  void start(Arena& arena, const Capacities& capacities) {
    auto* const queues = arena.allocate<Queue<Index>>(queue_count);
    auto* const holes = arena.allocate<Index>(detail::sizing::hole_lists<Index>);
    auto* const slots = arena.allocate<Slot<Index, Normal>>(capacities.slots);
    fragments_.start(slots, capacities.slots, queues);
    delivery_.start(holes, capacities.holes);
  }
  void clear() {
    fragments_.clear();
    delivery_.clear();
    passes_.clear();
    counts_ = {};
    chains_are_ended_ = false;
  }

  const Fragments<Index, Normal>& fragments() const { return fragments_; }
  const Delivery<Index, Normal, !is_lean>& delivery() const { return delivery_; }

  /// Sweeps a row, or continues it. Returns false if the sink is busy: call again.
  template <class Intake>
  bool sweep(const SweptRow& row, const Intake& intake, const Sink& sink, Statistics& statistics);

  /// Delivers pending events of swept rows. Returns like sweep().
  bool flush(const Sink&, Statistics&) { return true; }

  /// Delivers holes that still wait as loose fragments, after the last vertex. Returns like
  /// sweep().
  bool deliver_remaining_holes(const Sink& sink, Statistics& statistics) {
    return delivery_.deliver_remaining_holes(fragments_, sink, statistics);
  }

 private:
  template <class Intake>
  bool process_passes(const SweptRow& row, const Intake& intake, const Sink& sink,
                      Statistics& statistics);

  bool chains_are_ended_ = false;  // in the current row above a slab
  DerivedPasses passes_;
  SweepCounts counts_;
  Fragments<Index, Normal> fragments_;
  Delivery<Index, Normal, !is_lean> delivery_;
};

// Rows below a slab are not swept: chains from there are lost. Rows above it are swept twice,
// because an end does not hold its vertex. In the first sweep, rising chains end at their vertices.
// In the second sweep, descending chains begin there.
template <class Index, class Normal, bool lean>
template <class Intake>
bool Sweep<Index, Normal, lean>::sweep(const SweptRow& row, const Intake& intake, const Sink& sink,
                                       Statistics& statistics) {
  if constexpr (is_lean) return process_passes(row, intake, sink, statistics);
  if (row.role == SlabRole::below_slab) return true;
  fragments_.set_below_is_lost(row.role == SlabRole::first_of_slab);
  for (;;) {
    if (!process_passes(row, intake, sink, statistics)) return false;
    chains_are_ended_ = row.role == SlabRole::above_slab && !chains_are_ended_;
    if (!chains_are_ended_) return true;
  }
}

template <class Index, class Normal, bool lean>
template <class Intake>
bool Sweep<Index, Normal, lean>::process_passes(const SweptRow& row, const Intake& intake,
                                                const Sink& sink, Statistics& statistics) {
  if (!delivery_.deliver(fragments_, sink, statistics)) return false;
  do {
    while (passes_.has_next()) {
      const Pass& pass = passes_.pass();
      const Vertex& vertex = passes_.vertex();
      passes_.advance();
      if (is_lean || row.is_own())
        fragments_.process(pass, vertex, intake);
      else
        fragments_.cut_at(pass, vertex, !chains_are_ended_);
      if (fragments_.has_outgoing() && !delivery_.deliver(fragments_, sink, statistics))
        return false;
    }
  } while (passes_.find<is_lean>(row, counts_));
  if constexpr (!is_lean) counts_.add_to(statistics);
  return true;
}

}  // namespace discmc::detail::trace

#endif
