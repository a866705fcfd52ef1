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
  bool settle(Chains& chains, const Sink& sink, Statistics& statistics);

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
  bool begin_hole(Records& records);
  void begin_next_loose(Records& records);
  bool deliver_runs(Event& event, const Records& records, const Sink& sink, Statistics& statistics);
  void go_on(Records& records, Statistics& statistics);

  bool sends_ = false;
  bool is_delivering_ = false;
  bool is_fragment_ = false;
  bool is_hole_ = false;
  Event::Kind next_event_ = Event::Kind::region;
  uint32_t most_holes_ = 0;
  uint32_t holes_due_ = 0;  // marked ones: of the region, or to go before a loose fragment
  Out out_;                 // what is delivered; of kind none once no more than holes are due
  Index last_ = no_record;  // of the runs: those of out_, or of a hole
  Direction came_ = 0;      // by which their chain comes to their start
  Vertex start_{0, 0, 0};   // where the first run starts
  Cursor first_;
  Cursor cursor_;
  Holes<Index, Normal> holes_;
};

// ---- implementation ----

template <class Index, class Normal>
bool Delivery<Index, Normal>::settle(Chains& chains, const Sink& sink, Statistics& statistics) {
  Records& records = chains.records();
  if (!is_delivering_ && chains.has_outgoing()) begin(chains);
  Event event{};
  while (is_delivering_) {
    event.kind = next_event_;
    event.incidence = out_.incidence;
    event.came = came_;
    event.hole = is_hole_;
    event.start = start_;
    if (next_event_ == Event::Kind::run) {
      if (!deliver_runs(event, records, sink, statistics)) return false;
    } else if (sink.take(sink.context, event) != Answer::taken) {
      return false;
    }
    go_on(records, statistics);
  }
  return true;
}

template <class Index, class Normal>
bool Delivery<Index, Normal>::settle_holes(Chains& chains, const Sink& sink,
                                           Statistics& statistics) {
  Records& records = chains.records();
  while (is_delivering_ || holes_.count() > 0) {
    if (!is_delivering_) {
      out_.kind = Out::Kind::none;
      holes_.any_plane(records, out_.incidence, out_.start);
      holes_due_ = holes_.mark(records, out_);
      begin_next_loose(records);
    }
    if (!settle(chains, sink, statistics)) return false;
  }
  return true;
}

template <class Index, class Normal>
void Delivery<Index, Normal>::begin(Chains& chains) {
  Records& records = chains.records();
  out_ = chains.take_outgoing();
  last_ = out_.last;
  start_ = out_.start;
  is_hole_ = false;
  if (out_.kind == Out::Kind::ring) {
    begin_ring(records);
    if (is_hole_ && (!sends_ || (holes_.count() < most_holes_ &&
                                 chains.spare() >= 4 + Holes<Index, Normal>::records_each)))
      return holes_.keep(records, out_);
  }
  holes_due_ = is_hole_ ? 0 : holes_.mark(records, out_);
  if (out_.kind == Out::Kind::fragment) return begin_next_loose(records);
  is_delivering_ = true;
  is_fragment_ = is_hole_;
  next_event_ = is_hole_ ? Event::Kind::fragment : Event::Kind::region;
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
  Direction before = direction_of(Lists::last_run(records, last_));
  Direction after = before;  // the top
  uint32_t tops = 0;
  Lists::for_each(records, last_, [&](ShortRun run, Index record, uint8_t slot) {
    const Direction direction = direction_of(run);
    if (is_top(before, direction)) {
      ++tops;
      first_ = Cursor(record, slot);
      came_ = before;
      after = direction;
    }
    before = direction;
  });
  if (tops > 1) return begin_at_last_top(records, is_top);
  is_hole_ = turns_right(out_.incidence, came_, after);
  const Cursor end(records, last_);
  for (Cursor cursor = first_; cursor != end; cursor.advance(records)) {
    const ShortRun run = cursor.run(records);
    start_ = moved_back(start_, link_of(out_.incidence, direction_of(run)), length_of(run));
  }
}

// A hole that touches itself at its last vertex turns right there once, and an outer ring never.
template <class Index, class Normal>
template <class IsTop>
void Delivery<Index, Normal>::begin_at_last_top(const Records& records, IsTop is_top) {
  Direction before = direction_of(Lists::last_run(records, last_));
  Vertex at = start_;
  bool has_begun = false;
  Lists::for_each(records, last_, [&](ShortRun run, Index record, uint8_t slot) {
    const Direction direction = direction_of(run);
    if (is_top(before, direction) && !(has_begun && precedes(at, start_))) {
      const bool is_same = has_begun && at == start_;
      is_hole_ = (is_same && is_hole_) || turns_right(out_.incidence, before, direction);
      has_begun = true;
      start_ = at;
      first_ = Cursor(record, slot);
      came_ = before;
    }
    at = moved(at, link_of(out_.incidence, direction), length_of(run));
    before = direction;
  });
}

// Begins with the next of the marked holes. False when there is none.
template <class Index, class Normal>
bool Delivery<Index, Normal>::begin_hole(Records& records) {
  if (holes_due_ == 0) return false;
  --holes_due_;
  holes_.take(records, out_, last_, start_);
  begin_ring(records);
  return true;
}

// A loose fragment may be the last of the ring around holes of its plane: they go before it.
template <class Index, class Normal>
void Delivery<Index, Normal>::begin_next_loose(Records& records) {
  is_fragment_ = true;
  next_event_ = Event::Kind::fragment;
  is_delivering_ = true;
  if (begin_hole(records)) return;
  is_delivering_ = out_.kind == Out::Kind::fragment;
  if (!is_delivering_) return;
  out_.kind = Out::Kind::none;
  last_ = out_.last;
  came_ = out_.came;
  start_ = out_.start;
  first_ = Cursor(records, last_);
}

// Runs of one direction go out as one.
template <class Index, class Normal>
bool Delivery<Index, Normal>::deliver_runs(Event& event, const Records& records, const Sink& sink,
                                           Statistics& statistics) {
  const Cursor first = first_;
  Cursor cursor = cursor_;
  do {
    cursor_ = cursor;
    const Slot& slot = cursor.slot(records);
    event.run = long_run(slot.run);
    if constexpr (sizeof(Slot) > sizeof(ShortRun)) event.normal = slot.normal();
    do cursor.advance(records);
    while (cursor != first && event.run.absorb(long_run(cursor.run(records))));
    if (sink.take(sink.context, event) != Answer::taken) return false;
    statistics.links += event.run.length();
  } while (cursor != first);
  return true;
}

// The sink has taken an event, or all runs of a chain: what comes next?
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
    case Event::Kind::run:
      RunLists<Index, Normal>::give(records, last_);
      if (is_fragment_) {
        next_event_ = Event::Kind::fragment_end;
        break;
      }
      ++statistics.rings;
      next_event_ = begin_hole(records) ? Event::Kind::ring : Event::Kind::region_end;
      break;
    case Event::Kind::region_end:
      ++statistics.regions;
      is_delivering_ = false;
      break;
    default:  // fragment_end
      ++statistics.fragments;
      begin_next_loose(records);
  }
}

}  // namespace discmc::trace

#endif
