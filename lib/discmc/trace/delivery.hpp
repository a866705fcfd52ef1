// The tracer's side towards the sink: rings and loose fragments go out between two passes.
//
// Every event is made in one place, and what comes next is decided when the sink has taken it: so a
// delivery may be suspended before any event.
#ifndef DISCMC_TRACE_DELIVERY_HPP
#define DISCMC_TRACE_DELIVERY_HPP

#include <discmc/sink.hpp>
#include <discmc/trace/holes.hpp>

namespace discmc::trace {

/// The directions in which vertices come later in the order z, y, x: a bit each, by incidence.
struct AscendingDirections {
  uint8_t of[incidence_codes];
};
namespace derive {
constexpr AscendingDirections ascending_directions() {
  AscendingDirections ascending{};
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    for (Direction i = 0; i < direction_count(incidence); ++i)
      if (precedes({0, 0, 0}, direction_vector(incidence, i)))
        ascending.of[incidence] = static_cast<uint8_t>(ascending.of[incidence] | 1 << i);
  return ascending;
}
}  // namespace derive
inline constexpr AscendingDirections ascending_directions = derive::ascending_directions();

inline bool turns_right(Incidence incidence, Direction before, Direction after) {
  return turn(incidence, before, after) < 0;
}

template <class Index, class Normal>
class Delivery {
 public:
  using Records = Pool<Record<Index, Normal>, Index>;
  using Chains = Fragments<Index, Normal>;

  /// heads: see Holes. most_holes: with as many waiting, further ones go out loose.
  void start(Index* heads, uint32_t heads_count, uint32_t most_holes, bool sends) {
    holes_.start(heads, heads_count);
    most_holes_ = most_holes;
    sends_ = sends;
  }
  void clear() {
    holes_.clear();
    is_delivering_ = false;
  }

  /// Delivers what goes out, if anything. False when the sink said "not now": call again.
  bool settle(Chains& chains, const Sink& sink, Statistics& statistics) {
    if (!is_delivering_) {
      if (!chains.has_outgoing()) return true;
      begin(chains);
      if (!is_delivering_) return true;
    }
    return deliver(chains.records(), sink, statistics);
  }

  /// After the last vertex: delivers holes that still wait, loose. As settle().
  bool settle_holes(Chains& chains, const Sink& sink, Statistics& statistics);

  const Holes<Index, Normal>& holes() const { return holes_; }

 private:
  using Out = Outgoing<Index>;
  using Lists = RunLists<Index, Normal>;
  using Cursor = RunCursor<Index, Normal>;
  using Slot = typename RunRecord<Index, Normal>::Slot;

  void begin(Chains& chains);
  void begin_ring(const Records& records);
  template <class IsTop>
  void begin_at_last_top(const Records& records, IsTop is_top);
  void begin_fragments(Records& records);
  void next_fragment(Records& records);
  bool deliver(Records& records, const Sink& sink, Statistics& statistics);
  bool deliver_runs(Event& event, const Records& records, const Sink& sink, Statistics& statistics);
  void go_on(Records& records, Statistics& statistics);
  void end_runs(Records& records, Statistics& statistics);

  bool sends_ = false;
  bool is_delivering_ = false;
  bool is_fragment_ = false;
  bool is_hole_ = false;
  Event::Kind next_event_ = Event::Kind::region;
  uint32_t most_holes_ = 0;
  uint32_t holes_due_ = 0;  // marked ones: of the region, or to go before a loose fragment
  Out out_;                 // what is delivered
  Out last_;                // the fragment after the holes, or none
  Vertex start_{0, 0, 0};   // where the first run starts
  Cursor first_;
  Cursor cursor_;
  Holes<Index, Normal> holes_;
};

// ---- implementation ----

template <class Index, class Normal>
bool Delivery<Index, Normal>::settle_holes(Chains& chains, const Sink& sink,
                                           Statistics& statistics) {
  while (is_delivering_ || holes_.count() > 0) {
    if (!is_delivering_) {
      out_.kind = Out::Kind::none;
      holes_.any_plane(chains.records(), out_.incidence, out_.start);
      begin_fragments(chains.records());
    }
    if (!deliver(chains.records(), sink, statistics)) return false;
  }
  return true;
}

template <class Index, class Normal>
void Delivery<Index, Normal>::begin(Chains& chains) {
  Records& records = chains.records();
  out_ = chains.take_outgoing();
  if (out_.kind == Out::Kind::fragment) return begin_fragments(records);
  begin_ring(records);
  if (is_hole_ && (!sends_ || (holes_.count() < most_holes_ &&
                               chains.spare() >= 4 + Holes<Index, Normal>::records_each)))
    return holes_.keep(records, out_);
  is_delivering_ = true;
  is_fragment_ = is_hole_;
  holes_due_ = is_hole_ ? 0 : holes_.mark_within(records, out_);
  next_event_ = is_hole_ ? Event::Kind::fragment : Event::Kind::region;
  last_.kind = Out::Kind::none;
}

// Finds where to begin, whether the ring is a hole, and the direction before its first run.
//
// A ring begins at its last vertex in the order z, y, x. That is always a corner, it lies near the
// front of the sweep, and there only some directions are left: so it takes few bits to tell. It is
// a top: the ring ascends to it and descends from it. Most rings have one.
template <class Index, class Normal>
void Delivery<Index, Normal>::begin_ring(const Records& records) {
  const uint32_t ascending = ascending_directions.of[out_.incidence];
  const auto is_top = [ascending](Direction before, Direction after) {
    return (ascending >> before & ~(ascending >> after) & 1) != 0;
  };
  Direction before = direction_of(Lists::last_run(records, out_.last));
  Direction after = before;  // the top
  uint32_t tops = 0;
  Lists::for_each(records, out_.last, [&](ShortRun run, Index record, uint8_t slot) {
    const Direction direction = direction_of(run);
    if (is_top(before, direction)) {
      ++tops;
      first_ = Cursor(record, slot);
      out_.came = before;
      after = direction;
    }
    before = direction;
  });
  start_ = out_.start;
  if (tops > 1) return begin_at_last_top(records, is_top);
  is_hole_ = turns_right(out_.incidence, out_.came, after);
  const Cursor end(records, out_.last);
  for (Cursor cursor = first_; cursor != end; cursor.advance(records)) {
    const ShortRun run = cursor.run(records);
    start_ = moved_back(start_, link_of(out_.incidence, direction_of(run)), length_of(run));
  }
}

// A hole that touches itself at its last vertex turns right there once, and an outer ring never.
template <class Index, class Normal>
template <class IsTop>
void Delivery<Index, Normal>::begin_at_last_top(const Records& records, IsTop is_top) {
  Direction before = direction_of(Lists::last_run(records, out_.last));
  Vertex at = out_.start;
  bool has_begun = false;
  Lists::for_each(records, out_.last, [&](ShortRun run, Index record, uint8_t slot) {
    const Direction direction = direction_of(run);
    if (is_top(before, direction) && !(has_begun && precedes(at, start_))) {
      const bool is_same = has_begun && at == start_;
      is_hole_ = (is_same && is_hole_) || turns_right(out_.incidence, before, direction);
      has_begun = true;
      start_ = at;
      first_ = Cursor(record, slot);
      out_.came = before;
    }
    at = moved(at, link_of(out_.incidence, direction), length_of(run));
    before = direction;
  });
}

// A loose fragment may be the last of the ring around holes of its plane: they go before it.
template <class Index, class Normal>
void Delivery<Index, Normal>::begin_fragments(Records& records) {
  holes_due_ = holes_.mark_plane(records, out_.incidence, out_.start);
  last_ = out_;
  next_fragment(records);
}

template <class Index, class Normal>
void Delivery<Index, Normal>::next_fragment(Records& records) {
  is_fragment_ = true;
  is_delivering_ = true;
  next_event_ = Event::Kind::fragment;
  if (holes_due_ > 0) {
    --holes_due_;
    holes_.take(records, out_);
    return begin_ring(records);
  }
  is_delivering_ = last_.kind == Out::Kind::fragment;
  if (!is_delivering_) return;
  out_ = last_;
  last_.kind = Out::Kind::none;
  start_ = out_.start;
  first_ = Cursor(records, out_.last);
}

template <class Index, class Normal>
bool Delivery<Index, Normal>::deliver(Records& records, const Sink& sink, Statistics& statistics) {
  Event event{};
  while (is_delivering_) {
    event.kind = next_event_;
    event.incidence = out_.incidence;
    event.start = start_;
    event.hole = is_hole_;
    event.came = out_.came;
    if (next_event_ == Event::Kind::run) {
      if (!deliver_runs(event, records, sink, statistics)) return false;
      end_runs(records, statistics);
    } else {
      if (sink.take(sink.context, event) != Answer::taken) return false;
      go_on(records, statistics);
    }
  }
  return true;
}

template <class Index, class Normal>
bool Delivery<Index, Normal>::deliver_runs(Event& event, const Records& records, const Sink& sink,
                                           Statistics& statistics) {
  do {
    Cursor after = cursor_;
    const Slot& slot = after.slot(records);
    event.run = long_run(slot.run);
    if constexpr (sizeof(Slot) > sizeof(ShortRun)) event.normal = slot.normal();
    do after.advance(records);
    while (after != first_ && event.run.absorb(long_run(after.run(records))));
    if (sink.take(sink.context, event) != Answer::taken) return false;
    statistics.links += event.run.length();
    cursor_ = after;
  } while (cursor_ != first_);
  return true;
}

// The sink has taken an event: what comes next?
template <class Index, class Normal>
void Delivery<Index, Normal>::go_on(Records& records, Statistics& statistics) {
  switch (next_event_) {
    case Event::Kind::region:
      next_event_ = Event::Kind::ring;
      break;
    case Event::Kind::ring:
    case Event::Kind::fragment:
      cursor_ = first_;
      next_event_ = Event::Kind::run;
      break;
    case Event::Kind::region_end:
      ++statistics.regions;
      is_delivering_ = false;
      break;
    default:  // fragment_end
      ++statistics.fragments;
      next_fragment(records);
  }
}

template <class Index, class Normal>
void Delivery<Index, Normal>::end_runs(Records& records, Statistics& statistics) {
  RunLists<Index, Normal>::give(records, out_.last);
  if (is_fragment_) {
    next_event_ = Event::Kind::fragment_end;
    return;
  }
  ++statistics.rings;
  next_event_ = Event::Kind::region_end;
  if (holes_due_ == 0) return;
  --holes_due_;
  next_event_ = Event::Kind::ring;
  holes_.take(records, out_);
  begin_ring(records);
}

}  // namespace discmc::trace

#endif
