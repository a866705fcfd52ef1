// The tracer's side towards the sink: rings and loose fragments go out between two passes.
//
// Every event is made in one place, settle(), and what comes next is decided when the sink has
// taken it: so a delivery may be suspended before any event.
//
// An outer ring closes after the holes in it, for no hole reaches as far along the sweep as what
// surrounds it. So holes wait; an outer ring that closes is the completion of its region, and takes
// the holes of its plane that lie in it. Those further in were taken by the rings between.
#ifndef DISCMC_TRACE_DELIVERY_HPP
#define DISCMC_TRACE_DELIVERY_HPP

#include <discmc/sink.hpp>
#include <discmc/trace/fragments.hpp>

namespace discmc::trace {

/// The plane of a vertex among those of an incidence. Wraps.
inline uint32_t offset_of(Incidence incidence, const Vertex& v) {
  const Vertex n = normal(incidence);
  return static_cast<uint32_t>(n.x) * static_cast<uint32_t>(v.x) +
         static_cast<uint32_t>(n.y) * static_cast<uint32_t>(v.y) +
         static_cast<uint32_t>(n.z) * static_cast<uint32_t>(v.z);
}

template <class Index, class Normal>
class Delivery {
 public:
  using Records = Pool<Record<Index, Normal>, Index>;
  using Lists = RunLists<Index, Normal>;
  using Cursor = RunCursor<Index, Normal>;

  static constexpr uint32_t hole_records = 2;

  /// heads: of the lists of holes; a power of two of them.
  void start(Index* heads, uint32_t count, uint32_t most_holes, bool sends) {
    heads_ = heads;
    heads_mask_ = count - 1;
    most_holes_ = most_holes;
    sends_ = sends;
  }
  void clear() {
    for (uint32_t i = 0; i <= heads_mask_; ++i) heads_[i] = no_record;
    holes_ = 0;
    holes_high_water_ = 0;
    next_event_ = none;
  }

  /// Delivers what goes out, if anything. False when the sink said "not now": call again.
  bool settle(Fragments<Index, Normal>& fragments, const Sink& sink, Statistics& statistics);

  uint32_t holes() const { return holes_; }
  uint32_t holes_high_water() const { return holes_high_water_; }

 private:
  static constexpr Event::Kind none = Event::Kind::finish;

  bool begin(Fragments<Index, Normal>& fragments);
  void begin_ring(const Records& records, Outgoing<Index>& out);
  void end_runs(Records& records, Outgoing<Index>& out, Statistics& statistics);
  Event next_event(const Records& records, const Outgoing<Index>& out, Cursor& after) const;
  bool go_on(Fragments<Index, Normal>& fragments, const Event& event, const Cursor& after,
             Statistics& statistics);

  Index& head_of(Incidence incidence, const Vertex& at) {
    const uint32_t offset = offset_of(incidence, at);
    // Multiplication by an odd constant near 2^32 over the golden ratio spreads neighbouring keys
    // (D. Knuth, The Art of Computer Programming, vol. 3, section 6.4).
    const uint32_t spread = (offset * incidence_codes + incidence) * 0x9E3779B1U;
    return heads_[spread >> 16 & heads_mask_];
  }
  bool keep_hole(Fragments<Index, Normal>& fragments, const Outgoing<Index>& out);
  void mark_holes(Records& records, const Outgoing<Index>& out);
  bool surrounds(const Records& records, const Outgoing<Index>& out, const Vertex& start,
                 Direction first) const;
  void take_hole(Records& records, Outgoing<Index>& out);

  Index* heads_ = nullptr;
  uint32_t heads_mask_ = 0;
  uint32_t most_holes_ = 0;
  uint32_t holes_ = 0;
  uint32_t holes_high_water_ = 0;
  bool sends_ = true;

  Event::Kind next_event_ = none;
  bool is_fragment_ = false;
  bool is_hole_ = false;
  uint32_t holes_due_ = 0;  // of the region
  Vertex start_{0, 0, 0};   // of the ring or fragment: where its first run does
  Cursor first_;
  Cursor cursor_;
};

// ---- implementation ----

template <class Index, class Normal>
bool Delivery<Index, Normal>::settle(Fragments<Index, Normal>& fragments, const Sink& sink,
                                     Statistics& statistics) {
  if (!fragments.has_outgoing()) return true;
  if (next_event_ == none && !begin(fragments)) return true;
  for (;;) {
    Cursor after = cursor_;
    const Event event = next_event(fragments.records(), fragments.outgoing(), after);
    if (sink.take(sink.context, event) != Answer::taken) return false;
    if (!go_on(fragments, event, after, statistics)) return true;
  }
}

// False when what goes out is a hole that stays for now.
template <class Index, class Normal>
bool Delivery<Index, Normal>::begin(Fragments<Index, Normal>& fragments) {
  Outgoing<Index>& out = fragments.outgoing();
  Records& records = fragments.records();
  next_event_ = Event::Kind::fragment;
  if (out.kind == Outgoing<Index>::Kind::fragment) {
    start_ = out.start;
    first_ = Cursor(records, out.last);
    return true;
  }
  begin_ring(records, out);
  if (!is_hole_) {
    mark_holes(records, out);
    next_event_ = Event::Kind::region;
    return true;
  }
  if (!keep_hole(fragments, out)) return true;
  next_event_ = none;
  out.kind = Outgoing<Index>::Kind::none;
  return false;
}

// Finds a corner to begin at, whether the ring is a hole, and the direction before its first run.
template <class Index, class Normal>
void Delivery<Index, Normal>::begin_ring(const Records& records, Outgoing<Index>& out) {
  const Incidence incidence = out.incidence;
  const Cursor begin(records, out.last);
  Cursor cursor = begin;
  const Direction first = cursor.run(records) & 7;
  Direction before = first;
  int turned = 0;
  do {
    const Direction direction = cursor.run(records) & 7;
    turned += turn(incidence, before, direction);
    before = direction;
    cursor.advance(records);
  } while (cursor != begin);
  is_hole_ = turned + turn(incidence, before, first) < 0;
  out.came = before;
  start_ = out.start;
  for (; (cursor.run(records) & 7) == before; cursor.advance(records)) {
    const Run run = long_run(cursor.run(records));
    start_ = moved(start_, link_of(incidence, run.direction()), run.length());
  }
  first_ = cursor;
}

template <class Index, class Normal>
Event Delivery<Index, Normal>::next_event(const Records& records, const Outgoing<Index>& out,
                                          Cursor& after) const {
  Event event{};
  event.kind = next_event_;
  event.incidence = out.incidence;
  event.start = start_;
  event.hole = is_hole_;
  event.came = out.came;
  if (next_event_ != Event::Kind::run) return event;
  event.run = long_run(cursor_.run(records));
  if constexpr (sizeof(typename Lists::Slot) > sizeof(ShortRun))
    event.normal = cursor_.slot(records).normal();
  do
    after.advance(records);
  while (after != first_ && event.run.absorb(long_run(after.run(records))));
  return event;
}

// The sink has taken an event: is there more?
template <class Index, class Normal>
bool Delivery<Index, Normal>::go_on(Fragments<Index, Normal>& fragments, const Event& event,
                                    const Cursor& after, Statistics& statistics) {
  Outgoing<Index>& out = fragments.outgoing();
  switch (next_event_) {
    case Event::Kind::region:
      next_event_ = Event::Kind::ring;
      return true;
    case Event::Kind::ring:
    case Event::Kind::fragment:
      cursor_ = first_;
      is_fragment_ = next_event_ == Event::Kind::fragment;
      next_event_ = Event::Kind::run;
      return true;
    case Event::Kind::run:
      statistics.links += event.run.length();
      cursor_ = after;
      if (cursor_ == first_) end_runs(fragments.records(), out, statistics);
      return true;
    case Event::Kind::region_end:
      ++statistics.regions;
      break;
    default:  // fragment_end
      ++statistics.fragments;
  }
  next_event_ = none;
  out.kind = Outgoing<Index>::Kind::none;
  return false;
}

template <class Index, class Normal>
void Delivery<Index, Normal>::end_runs(Records& records, Outgoing<Index>& out,
                                       Statistics& statistics) {
  Lists::give(records, out.last);
  if (is_fragment_) {
    next_event_ = Event::Kind::fragment_end;
    return;
  }
  ++statistics.rings;
  next_event_ = Event::Kind::region_end;
  if (holes_due_ == 0) return;
  take_hole(records, out);
  begin_ring(records, out);
  next_event_ = Event::Kind::ring;
}

// ---- holes ----

template <class Index, class Normal>
bool Delivery<Index, Normal>::keep_hole(Fragments<Index, Normal>& fragments,
                                        const Outgoing<Index>& out) {
  if (sends_ && (holes_ == most_holes_ || fragments.spare() < hole_records + 4)) return false;
  Records& records = fragments.records();
  const Index index = records.take();
  const Index start = records.take();
  records[start].hole_start.set(out.start);
  Index& head = head_of(out.incidence, out.start);
  Hole<Index>& hole = records[index].hole;
  hole.next = head;
  hole.last = out.last;
  hole.start = start;
  hole.incidence = out.incidence;
  hole.is_taken = 0;
  head = index;
  if (++holes_ > holes_high_water_) holes_high_water_ = holes_;
  return true;
}

// Counts the holes that lie in an outer ring, and marks them for delivery.
template <class Index, class Normal>
void Delivery<Index, Normal>::mark_holes(Records& records, const Outgoing<Index>& out) {
  holes_due_ = 0;
  if (holes_ == 0) return;
  const uint32_t offset = offset_of(out.incidence, out.start);
  for (Index i = head_of(out.incidence, out.start); i != no_record; i = records[i].linked.next) {
    Hole<Index>& hole = records[i].hole;
    if (hole.incidence != out.incidence) continue;
    const Vertex start = records[hole.start].hole_start.get();
    if (offset_of(out.incidence, start) != offset) continue;
    const Direction first = Cursor(records, hole.last).run(records) & 7;
    if (!surrounds(records, out, start, first)) continue;
    hole.is_taken = 1;
    ++holes_due_;
  }
}

// Whether an outer ring surrounds a hole of its plane that starts at a vertex in a direction. A
// point beside the middle of the hole's first link, within a facet and so on no ring, lies inside
// if a ray from it crosses the ring an odd number of times. Units: eighths of a half-step.
template <class Index, class Normal>
bool Delivery<Index, Normal>::surrounds(const Records& records, const Outgoing<Index>& out,
                                        const Vertex& start, Direction first) const {
  const Vertex n = normal(out.incidence);
  const int dropped = n.z != 0 ? 2 : n.y != 0 ? 1 : 0;
  const int u = dropped == 0 ? 1 : 0;
  const int v = dropped == 2 ? 1 : 2;
  const Direction count = direction_count(out.incidence);
  const Direction left = static_cast<Direction>(first + 1 < count ? first + 1 : 0);
  const Vertex along = direction_vector(out.incidence, first);
  const Vertex aside = direction_vector(out.incidence, left);
  const int64_t to_u = 4 * coordinate(along, u) + coordinate(aside, u);
  const int64_t to_v = 4 * coordinate(along, v) + coordinate(aside, v);
  // From the point to the ring's vertex.
  int64_t at_u = 8 * (int64_t{coordinate(out.start, u)} - coordinate(start, u)) - to_u;
  int64_t at_v = 8 * (int64_t{coordinate(out.start, v)} - coordinate(start, v)) - to_v;
  bool is_inside = false;
  const Cursor begin(records, out.last);
  Cursor cursor = begin;
  do {
    const Run run = long_run(cursor.run(records));
    const Vertex step = direction_vector(out.incidence, run.direction());
    const int step_u = coordinate(step, u);
    const int step_v = coordinate(step, v);
    const int64_t length = 8 * int64_t{run.length()};
    const int64_t end_v = at_v + length * step_v;
    if ((at_v > 0) != (end_v > 0)) {
      // Where the side crosses the ray's line, times |step_v|.
      const int64_t side = at_u * step_v - at_v * step_u;
      if (step_v > 0 ? side > 0 : side < 0) is_inside = !is_inside;
    }
    at_u += length * step_u;
    at_v = end_v;
    cursor.advance(records);
  } while (cursor != begin);
  return is_inside;
}

// Makes the next marked hole what goes out.
template <class Index, class Normal>
void Delivery<Index, Normal>::take_hole(Records& records, Outgoing<Index>& out) {
  Index* link = &head_of(out.incidence, out.start);
  while (records[*link].hole.is_taken == 0) link = &records[*link].linked.next;
  const Index index = *link;
  const Hole<Index>& hole = records[index].hole;
  *link = hole.next;
  out.last = hole.last;
  out.start = records[hole.start].hole_start.get();
  records.give(hole.start);
  records.give(index);
  --holes_;
  --holes_due_;
}

}  // namespace discmc::trace

#endif
