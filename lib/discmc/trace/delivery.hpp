// Sends rings and loose fragments to the sink as events, between two passes.
//
//   outgoing     events
//   outer ring   region, ring, its runs; for each hole inside: ring, its runs; region_end
//   fragment     fragment, its runs, fragment_end; marked holes before it, as fragments
//   hole         none yet: it waits in Holes for the ring around it
//
// A ring is a hole if it turns right at its last vertex in the order z, y, x, where its events
// begin. A hole that cannot wait is sent as a fragment: too many holes wait, too few slots are
// spare, or the extractor is lean.
//
// deliver() offers events until the sink is busy. When the sink has accepted an event,
// select_next() selects the next one. So a busy sink may suspend the delivery before any event.
#ifndef DISCMC_TRACE_DELIVERY_HPP
#define DISCMC_TRACE_DELIVERY_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/sink.hpp>
#include <discmc/trace/hole_tree.hpp>

namespace discmc::detail::trace {

inline bool turns_right(Incidence incidence, Direction before, Direction after) {
  return turn(incidence, before, after) < 0;
}

/// holes_wait: false in a lean extractor, whose holes are sent as loose fragments.
template <class Index, class Normal, bool holes_wait>
class Delivery {
 public:
  using Slots = Pool<Slot<Index, Normal>, Index>;
  using Chains = Fragments<Index, Normal>;

  /// heads: as for Holes. max_holes: if this many wait, further holes leave as loose fragments.
  void start(Index* heads, uint32_t max_holes) {
    holes_.start(heads);
    max_holes_ = max_holes;
  }
  void clear() {
    holes_.clear();
    is_delivering_ = false;
  }

  /// Delivers what is outgoing, if anything. Returns false if the sink is busy: call again.
  bool deliver(Chains& chains, const Sink& sink, Statistics& statistics);

  /// Delivers holes that still wait as loose fragments, after the last vertex. Returns like
  /// deliver().
  bool deliver_remaining_holes(Chains& chains, const Sink& sink, Statistics& statistics);

  /// The steps of deliver(): begin() selects the first event of what is outgoing, select_next() the
  /// event after the one that the sink has accepted. Public for the extractor for PCs, which
  /// continues here after a sink was busy.
  void begin(Chains& chains);
  void select_next(Chains& chains, Statistics& statistics);

  const Holes<Index, Normal>& holes() const { return holes_; }

 private:
  using Out = Outgoing<Index>;
  using Lists = RunLists<Index, Normal>;
  using Cursor = RunCursor<Index, Normal>;
  using Entry = typename RunSlot<Index, Normal>::Entry;

  void begin_ring(const Slots& slots);
  bool begin_hole(Chains& chains);
  void begin_next_loose(Chains& chains);
  void next_run(const Slots& slots);

  bool is_delivering_ = false;
  bool is_fragment_ = false;
  uint32_t max_holes_ = 0;
  uint32_t holes_due_ = 0;  // marked holes to deliver: of the region, or before a loose fragment
  Event event_{};           // next event; its start is the chain's
  Index runs_ = no_slot;    // the list of the chain
  Cursor first_;
  Cursor cursor_;  // behind the run of event_
  Holes<Index, Normal> holes_;
};

// ---- implementation ----

template <class Index, class Normal, bool holes_wait>
bool Delivery<Index, Normal, holes_wait>::deliver(Chains& chains, const Sink& sink,
                                                  Statistics& statistics) {
  if (!is_delivering_ && chains.has_outgoing()) begin(chains);
  while (is_delivering_) {
    if (sink.accept(sink.context, event_) != SinkResult::accepted) return false;
    select_next(chains, statistics);
  }
  return true;
}

template <class Index, class Normal, bool holes_wait>
bool Delivery<Index, Normal, holes_wait>::deliver_remaining_holes(Chains& chains, const Sink& sink,
                                                                  Statistics& statistics) {
  while (is_delivering_ || (holes_wait && holes_.count() > 0)) {
    if (holes_wait && !is_delivering_) {
      Out& out = chains.outgoing();
      holes_.any_plane(chains.slots(), out.incidence, out.start);
      event_.incidence = out.incidence;
      // `out` is of kind none, so mark() marks all holes of the plane, as for a fragment.
      holes_due_ = holes_.mark(chains.slots(), out);
      begin_next_loose(chains);
    }
    if (!deliver(chains, sink, statistics)) return false;
  }
  return true;
}

template <class Index, class Normal, bool holes_wait>
void Delivery<Index, Normal, holes_wait>::begin(Chains& chains) {
  Slots& slots = chains.slots();
  Out& out = chains.outgoing();
  runs_ = out.runs;
  event_.incidence = out.incidence;
  event_.start = out.start;
  if (out.kind == Out::Kind::fragment) {
    if constexpr (holes_wait) holes_due_ = holes_.mark(slots, out);
    return begin_next_loose(chains);
  }
  begin_ring(slots);
  constexpr uint32_t min_spare = minimum_capacities().slots + Holes<Index, Normal>::slots_each;
  if (holes_wait && event_.is_hole && holes_.count() < max_holes_ &&
      // With fewer spare slots the hole leaves as a fragment. No known scan reaches this, because
      // fragments leave early before so few slots remain.
      chains.spare() >= min_spare) {
    holes_.keep(slots, out);
    out.kind = Out::Kind::none;
    return;
  }
  holes_due_ = !holes_wait || event_.is_hole ? 0 : holes_.mark(slots, out);
  is_delivering_ = true;
  is_fragment_ = event_.is_hole;
  event_.kind = is_fragment_ ? Event::Kind::fragment : Event::Kind::region;
}

// Finds the start of the ring, whether the ring is a hole, and the direction before its first run.
//
// A ring begins at its last vertex in the order z, y, x. This vertex is always a corner. It lies
// near the front of the sweep, and only some directions are possible there, so record_model.hpp
// codes the first one in few bits. The vertex is a top: the ring ascends to it and descends from
// it. A plane has at most one top per vertex, so a ring passes its last vertex once. Holes turn
// right there; all other rings turn left.
template <class Index, class Normal, bool holes_wait>
void Delivery<Index, Normal, holes_wait>::begin_ring(const Slots& slots) {
  const Incidence incidence = event_.incidence;
  constexpr Vertex here{0, 0, 0};
  Vertex offset = here;  // from the last vertex so far
  Direction before = direction_of(Lists::last_run(slots, runs_));
  const Cursor end(slots, runs_);
  Cursor cursor = end;
  do {
    const ShortRun run = cursor.run(slots);
    const Direction direction = direction_of(run);
    if (!precedes(offset, here)) {
      offset = here;
      first_ = cursor;
      event_.incoming_direction = before;
    }
    translate(offset, incidence, direction, length_of(run));
    before = direction;
    cursor.advance(slots);
  } while (cursor != end);
  event_.start = event_.start - offset;
  event_.is_hole =
      turns_right(incidence, event_.incoming_direction, direction_of(first_.run(slots)));
}

// Begins with the next of the marked holes. Returns false if there is none.
template <class Index, class Normal, bool holes_wait>
bool Delivery<Index, Normal, holes_wait>::begin_hole(Chains& chains) {
  if (!holes_wait || holes_due_ == 0) return false;
  --holes_due_;
  holes_.remove(chains.slots(), runs_, event_.start);
  begin_ring(chains.slots());
  return true;
}

// Delivers holes of the fragment's plane before it, because the fragment may complete the ring
// around them.
template <class Index, class Normal, bool holes_wait>
void Delivery<Index, Normal, holes_wait>::begin_next_loose(Chains& chains) {
  is_fragment_ = true;
  event_.kind = Event::Kind::fragment;
  is_delivering_ = true;
  if (begin_hole(chains)) return;
  Out& out = chains.outgoing();
  is_delivering_ = out.kind == Out::Kind::fragment;
  out.kind = Out::Kind::none;
  if (!is_delivering_) return;
  runs_ = out.runs;
  event_.incoming_direction = out.incoming;
  event_.start = out.start;
  first_ = Cursor(chains.slots(), runs_);
}

// Merges successive runs of one direction.
template <class Index, class Normal, bool holes_wait>
void Delivery<Index, Normal, holes_wait>::next_run(const Slots& slots) {
  event_.kind = Event::Kind::run;
  const Entry& entry = cursor_.entry(slots);
  event_.run = long_run(entry.run);
  if constexpr (sizeof(Entry) > sizeof(ShortRun)) event_.normal = entry.normal();
  do cursor_.advance(slots);
  while (cursor_ != first_ && event_.run.absorb(long_run(cursor_.run(slots))));
}

// Selects the next event after the sink has accepted one.
template <class Index, class Normal, bool holes_wait>
DISCMC_NOINLINE void Delivery<Index, Normal, holes_wait>::select_next(Chains& chains,
                                                                      Statistics& statistics) {
  Slots& slots = chains.slots();
  switch (event_.kind) {
    case Event::Kind::region:
      event_.kind = Event::Kind::ring;
      break;
    case Event::Kind::ring:
    case Event::Kind::fragment:
      cursor_ = first_;
      next_run(slots);
      break;
    case Event::Kind::run:
      statistics.links += event_.run.length();
      if (cursor_ != first_) return next_run(slots);
      RunLists<Index, Normal>::release(slots, runs_);
      if (is_fragment_) {
        event_.kind = Event::Kind::fragment_end;
        break;
      }
      ++statistics.rings;
      event_.kind = begin_hole(chains) ? Event::Kind::ring : Event::Kind::region_end;
      break;
    case Event::Kind::region_end:
      ++statistics.regions;
      chains.outgoing().kind = Out::Kind::none;
      is_delivering_ = false;
      break;
    default:  // fragment_end
      ++statistics.fragments;
      begin_next_loose(chains);
  }
}

}  // namespace discmc::detail::trace

#endif
