// The open chains: fragments grow at the vertices of their chains, join, and close to rings.
//
// A pass is the path of one chain through one vertex. An end of a fragment waits in the queue of
// its link to a vertex that is visited later. A link leaves the fragment at its tail, and arrives
// at its begin. If the sweep has visited a neighbour, an end waits for the pass: a tail in queue
// `in`, or a begin in queue `out`. A neighbour that is visited later is ahead:
//
//   arrives from   leaves to   process()
//   visited        ahead       lengthens the tail, which waits again
//   ahead          visited     lengthens the begin, which waits again
//   ahead          ahead       begins a fragment, whose two ends wait
//   visited        visited     joins two fragments, or closes a ring if they are one
//
// A run is added at a corner, at a join, where an end is cut, and where a side is full. If few
// slots are spare, the runs of long fragments leave early. An end without a slot to wait in is
// lost: its fragment then has a loose end. The queue keeps the position of the lost end, so that
// the ends behind it meet the right passes. A ring, and runs that leave a fragment, are outgoing()
// until Delivery has sent them.
#ifndef DISCMC_TRACE_FRAGMENTS_HPP
#define DISCMC_TRACE_FRAGMENTS_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/trace/passes.hpp>
#include <discmc/trace/queues.hpp>
#include <discmc/trace/run_list.hpp>

namespace discmc::detail::trace {

/// Tables that count the links between two places without a division.
struct LinkSteps {
  static constexpr int max_step = 6;
  static constexpr uint32_t fraction_bits = 15;

  int8_t place_step[link_codes];   ///< change of the place by each link
  uint16_t inverse[max_step + 1];  ///< by length of the step; rounded up
};
namespace derive {
constexpr LinkSteps link_steps() {
  LinkSteps steps{};
  for (Link link = 0; link < link_codes; ++link) {
    const Vertex v = link_vector(link);
    steps.place_step[link] = static_cast<int8_t>(3 * v.x + 2 * v.y + v.z);
  }
  for (int step = 1; step <= LinkSteps::max_step; ++step)
    steps.inverse[step] = static_cast<uint16_t>((1 << LinkSteps::fraction_bits) / step + 1);
  return steps;
}
}  // namespace derive
inline constexpr LinkSteps link_steps = derive::link_steps();

/// A side is full, and is split, if its ends are at least this many places apart.
constexpr uint32_t max_side_places = 4080;

/// Whether a side between two places is full, so that it must be split here. After two full sides
/// join, places still determine the length. The order of the places does not matter.
inline bool is_full_side(Place from, Place to) {
  return (to - from + max_side_places - 1) % (1U << place_bits) >= 2 * max_side_places - 1;
}
static_assert(2 * (max_side_places + LinkSteps::max_step) < 1U << place_bits,
              "two sides, each with a link more, are less than all places");
static_assert(2 * (max_side_places + LinkSteps::max_step) <= max_short_length,
              "a run has room for two sides of links that count one each");
static_assert(short_run(7, max_short_length) == UINT16_MAX && 3 + place_bits <= 16,
              "a run, and a side, have a direction and 13 bits");
static_assert(1U << place_bits < 1U << LinkSteps::fraction_bits,
              "what rounding adds to an inverse is less than a link");

/// Returns the number of links from one place to another. Limit: the places are less than 8,192
/// apart.
inline uint32_t links_between(Place from, Place to, Link link) {
  const int8_t step = link_steps.place_step[link];
  const uint32_t distance = step < 0 ? from - to : to - from;
  return (distance & ((1U << place_bits) - 1)) * link_steps.inverse[step < 0 ? -step : step] >>
         LinkSteps::fraction_bits;
}

/// Returns the place after a link.
inline Place moved(Place from, Link link) {
  return from + static_cast<uint32_t>(link_steps.place_step[link]);
}

/// A chain to deliver; its runs stay in the pool until then. A closed ring, or a loose fragment.
template <class Index>
struct Outgoing {
  enum class Kind : uint8_t { none, ring, fragment };
  Kind kind = Kind::none;
  Incidence incidence = 0;
  Direction incoming = 0;  // of a fragment
  Index runs = no_slot;    // their list
  Vertex start{0, 0, 0};
};

/// Index and Normal are as for the slots.
template <class Index, class Normal>
class Fragments {
 public:
  using Slots = Pool<Slot<Index, Normal>, Index>;
  using Lists = RunLists<Index, Normal>;

  /// No fragment is sent early while this many slots are spare.
  static constexpr uint32_t min_spare_to_hold = 1024;
  /// The most slots that a pass allocates.
  static constexpr uint32_t slots_per_pass = 6;
  /// The number of slots reserved for ends within the slice, unless half of all is less.
  static constexpr uint32_t max_reserved_for_slice = 80;

  void start(Slot<Index, Normal>* slots, uint32_t capacity, Queue<Index>* queues) {
    slots_.start(slots, capacity);
    queues_.start(queues);
    reserved_for_slice_ =
        capacity / 2 < max_reserved_for_slice ? capacity / 2 : max_reserved_for_slice;
    spare_for_all_ends_ = slots_per_pass + 2 * reserved_for_slice_;
  }
  void clear() {
    slots_.clear();
    queues_.clear();
    outgoing_.kind = Outgoing<Index>::Kind::none;
  }

  /// Processes a chain's pass at a vertex. Limit: nothing is outgoing. intake.normal_at(vertex)
  /// returns the normal at a corner. Cost: constant, except for sending.
  template <class Intake>
  void process(const Pass& pass, const Vertex& vertex, const Intake& intake);

  /// Cuts a pass at a vertex of the slice above a slab. A chain that rises to the vertex ends
  /// there; a chain that descends from it begins, loose, at the next vertex. Limits and cost as
  /// process().
  void cut_at(const Pass& pass, const Vertex& vertex, bool ends);

  /// Sets whether chains from below belong to another slab.
  void set_below_is_lost(bool is_lost) {
    queues_.lose_from(is_lost ? first_rising_queue : queue_count);
  }

  bool has_outgoing() const { return outgoing_.kind != Outgoing<Index>::Kind::none; }
  /// Returns the outgoing chain. After delivery, the caller sets its kind to none.
  Outgoing<Index>& outgoing() { return outgoing_; }
  /// Makes runs outgoing that begin at `start`.
  void set_outgoing(typename Outgoing<Index>::Kind kind, Incidence incidence, Index runs,
                    const Vertex& start) {
    outgoing_.kind = kind;
    outgoing_.incidence = incidence;
    outgoing_.runs = runs;
    outgoing_.start = start;
  }
  Slots& slots() { return slots_; }
  const Slots& slots() const { return slots_; }
  /// Returns the free slots, less one for each queue whose last entry is an end (queues.hpp).
  uint32_t spare() const { return slots_.available(); }

 private:
  using EndSlot = End<Index, Normal>;
  using Entry = typename Lists::Entry;

  EndSlot& end(Index index) { return slots_[index].end; }
  static Direction direction(const Pass& pass, Link link) {
    return discmc::direction_of(pass.incidence, link);
  }
  static void follow(Vertex& vertex, Link link) { translate(vertex, link, 1); }
  // Returns the vertex that a chain reaches next.
  static Vertex next_vertex(const Pass& pass, const Vertex& vertex) {
    Vertex next = vertex;
    if (pass.has_centroid()) follow(next, pass.outgoing);
    follow(next, pass.after_centroid);
    return next;
  }
  // Returns the beginning of the side along which a chain leaves.
  static Vertex last_corner(const Pass& pass, const Vertex& vertex) {
    Vertex corner = vertex;
    if (pass.turns_at_centroid()) translate(corner, pass.outgoing, 1);
    return corner;
  }

  template <class Intake>
  static Normal normal_if(bool is_corner, const Vertex& vertex, const Intake& intake) {
    return is_corner ? intake.normal_at(vertex) : Normal{};
  }
  template <class Intake>
  Index begin_fragment(const Pass& pass, const Vertex& vertex, const Intake& intake);
  template <class Intake>
  Index new_tail(const Pass& pass, const Vertex& vertex, Index mate, const Intake& intake);
  template <class Intake>
  void lengthen_begin(const Pass& pass, const Vertex& vertex, Index begin, const Intake& intake);
  void cut_begin(const Pass& pass, Index begin, Link incoming, const Vertex& vertex);
  void send_if_long(const Pass& pass, const Vertex& vertex, Index index, bool is_tail);
  // Returns the runs of the fragment with this begin.
  Index& runs_of(Index begin) {
    EndSlot& slot = end(begin);
    return is_loose(slot.mate) ? slot.runs : end(slot.mate).runs;
  }
  void turn(Index tail, Link incoming, Place corner, Direction onwards, Normal normal);
  void turn_back(Index begin, Link onwards, Place corner, Direction incoming, Normal normal);
  void cut_tail(const Pass& pass, const Vertex& vertex, Index tail);
  void end_tail(const Pass& pass, Index tail, Link along, Vertex& at);
  void join(const Pass& pass, const Vertex& vertex, Index tail, Index begin);

  Index pop(uint8_t queue) { return queues_.pop(slots_, queue); }
  // Appends an end, waiting or lost, to its queue.
  void push(uint8_t queue, Index end) { queues_.push(slots_, queue, end); }
  void push_lost(uint8_t queue) { queues_.push_lost(slots_, queue); }
  // Makes the two ends mates and stores the runs in both. If neither is loose, only the tail's copy
  // stays valid.
  void connect(Index begin, Index tail, Index list);
  // Whether an end may wait.
  bool admits(uint8_t queue, Index mate) const {
    return spare() >= spare_for_all_ends_ || spare() >= min_spare(queue, mate);
  }
  uint32_t min_spare(uint8_t queue, Index mate) const;
  // Whether fragments must be sent early, and this one is long enough.
  bool should_send(Index list, Index other = no_slot) const {
    return spare() < min_spare_to_hold && is_long(list, other);
  }
  bool is_long(Index list, Index other) const;
  void move_to_begin(Vertex& at, Incidence incidence, Index list) const;
  void send(const Pass& pass, Index begin, Index tail, Index list, const Vertex& start);

  Slots slots_;                      // first, so its address is that of this object: less code
  uint32_t reserved_for_slice_ = 0;  // slots that ends waiting for the next slice must not use
  uint32_t spare_for_all_ends_ = 0;  // while this many are spare, no end is lost
  Outgoing<Index> outgoing_;
  Queues<Index, Normal> queues_;
};

// ---- implementation ----

template <class Index, class Normal>
template <class Intake>
DISCMC_NOINLINE void Fragments<Index, Normal>::process(const Pass& pass, const Vertex& vertex,
                                                       const Intake& intake) {
  DISCMC_LIMIT(!has_outgoing());
  const Place here = place_of(vertex);
  const Index begin = pass.goes_ahead() ? Index{no_slot} : pop(pass.out_queue);
  Index tail;
  bool has_new_runs = pass.turns_at_centroid();
  if (pass.comes_from_ahead) {
    if (begin != no_slot) return lengthen_begin(pass, vertex, begin, intake);
    tail = begin_fragment(pass, vertex, intake);
  } else {
    tail = pop(pass.in_queue);
    if (tail == no_slot) {
      // The end of the incoming link was lost.
      tail = new_tail(pass, vertex, loose_end<Index>(direction(pass, pass.incoming)), intake);
    } else if (pass.turns() || is_full_side(end(tail).side.place(), here)) {
      turn(tail, pass.incoming, here, direction(pass, pass.outgoing),
           normal_if(pass.turns(), vertex, intake));
      has_new_runs = true;
    }
  }
  if (pass.turns_at_centroid())
    turn(tail, pass.outgoing, moved(here, pass.outgoing), direction(pass, pass.after_centroid),
         intake.normal_at(last_corner(pass, vertex)));
  if (begin != no_slot) return join(pass, vertex, tail, begin);
  if (pass.goes_ahead()) {
    if (admits(pass.out_queue, end(tail).mate)) {
      push(pass.out_queue, tail);
      if (has_new_runs) send_if_long(pass, vertex, tail, true);
      return;
    }
    push_lost(pass.out_queue);
  }
  cut_tail(pass, vertex, tail);
}

// ---- how a chain arrives at the vertex ----

// Returns a tail that starts here. mate: its fragment's begin, or the mark of a loose begin.
template <class Index, class Normal>
template <class Intake>
DISCMC_NOINLINE Index Fragments<Index, Normal>::new_tail(const Pass& pass, const Vertex& vertex,
                                                         Index mate, const Intake& intake) {
  const Index tail = slots_.allocate();
  EndSlot& slot = end(tail);
  slot.mate = mate;
  slot.runs = no_slot;
  slot.side = Side(direction(pass, pass.outgoing), place_of(vertex));
  slot.set_normal(normal_if(pass.turns(), vertex, intake));
  return tail;
}

template <class Index, class Normal>
template <class Intake>
DISCMC_ALWAYS_INLINE Index Fragments<Index, Normal>::begin_fragment(const Pass& pass,
                                                                    const Vertex& vertex,
                                                                    const Intake& intake) {
  const Direction incoming = direction(pass, pass.incoming);
  Index mate = loose_end<Index>(incoming);
  if (admits(pass.in_queue, pass.goes_ahead() ? Index{no_slot} : mate)) {
    mate = slots_.allocate();
    push(pass.in_queue, mate);
    end(mate).runs = no_slot;
    end(mate).side = Side(incoming, place_of(vertex));
  } else {
    push_lost(pass.in_queue);
  }
  const Index tail = new_tail(pass, vertex, mate, intake);
  if (!is_loose(mate)) end(mate).mate = tail;
  return tail;
}

// Continues a waiting fragment by a chain from a later vertex.
template <class Index, class Normal>
template <class Intake>
DISCMC_ALWAYS_INLINE void Fragments<Index, Normal>::lengthen_begin(const Pass& pass,
                                                                   const Vertex& vertex,
                                                                   Index begin,
                                                                   const Intake& intake) {
  const Place here = place_of(vertex);
  const bool may_wait = admits(pass.in_queue, end(begin).mate);
  bool has_new_runs = pass.turns_at_centroid();
  if (has_new_runs) {
    turn_back(begin, pass.after_centroid, moved(here, pass.outgoing),
              direction(pass, pass.outgoing), intake.normal_at(last_corner(pass, vertex)));
  }
  if (pass.turns() || !may_wait || is_full_side(here, end(begin).side.place())) {
    turn_back(begin, pass.outgoing, here, direction(pass, pass.incoming),
              normal_if(pass.turns(), vertex, intake));
    has_new_runs = true;
  }
  if (!may_wait) {
    push_lost(pass.in_queue);
    return cut_begin(pass, begin, pass.incoming, vertex);
  }
  push(pass.in_queue, begin);
  if (has_new_runs) send_if_long(pass, vertex, begin, false);
}

// The fragment begins loose at a vertex, where it arrives by a link.
template <class Index, class Normal>
void Fragments<Index, Normal>::cut_begin(const Pass& pass, Index begin, Link incoming,
                                         const Vertex& vertex) {
  const Index tail = end(begin).mate;
  const Index list = runs_of(begin);
  slots_.release(begin);
  const Index loose = loose_end<Index>(direction(pass, incoming));
  if (list != no_slot && (is_loose(tail) || should_send(list)))
    return send(pass, loose, tail, list, vertex);
  if (!is_loose(tail)) end(tail).mate = loose;
}

// ---- corners ----

// Ends the current side of a tail at a corner, and begins the next side.
template <class Index, class Normal>
void Fragments<Index, Normal>::turn(Index tail, Link incoming, Place corner, Direction onwards,
                                    Normal normal) {
  EndSlot& slot = end(tail);
  const Side side = slot.side;
  Entry run;
  run.run = short_run(side.direction(), links_between(side.place(), corner, incoming));
  run.set_normal(slot.normal());
  slot.side = Side(onwards, corner);
  slot.set_normal(normal);
  Lists::append(slots_, slot.runs, run);
}

// Begins the current side of a begin at a corner, and ends the previous side.
template <class Index, class Normal>
void Fragments<Index, Normal>::turn_back(Index begin, Link onwards, Place corner,
                                         Direction incoming, Normal normal) {
  EndSlot& slot = end(begin);
  const Side side = slot.side;
  Entry run;
  run.run = short_run(side.direction(), links_between(corner, side.place(), onwards));
  run.set_normal(normal);
  slot.side = Side(incoming, corner);
  Lists::prepend(slots_, runs_of(begin), run);
}

// ---- the end of a fragment ----

// Ends the fragment loose at the next vertex.
template <class Index, class Normal>
DISCMC_ALWAYS_INLINE void Fragments<Index, Normal>::cut_tail(const Pass& pass, const Vertex& vertex,
                                                             Index tail) {
  Vertex next = next_vertex(pass, vertex);
  end_tail(pass, tail, pass.after_centroid, next);
}

// Ends the fragment loose at a vertex. along: its last link. If its runs are sent, `at` becomes the
// vertex at which they begin.
template <class Index, class Normal>
void Fragments<Index, Normal>::end_tail(const Pass& pass, Index tail, Link along, Vertex& at) {
  turn(tail, along, place_of(at), {}, {});
  const Index begin = end(tail).mate;
  const Index list = end(tail).runs;
  slots_.release(tail);
  if (!is_loose(begin) && !should_send(list)) return connect(begin, loose_end<Index>(), list);
  move_to_begin(at, pass.incidence, list);
  send(pass, begin, loose_end<Index>(), list, at);
}

// Joins the fragment to the fragment that waits behind it, or closes it to a ring.
template <class Index, class Normal>
DISCMC_ALWAYS_INLINE void Fragments<Index, Normal>::join(const Pass& pass, const Vertex& vertex,
                                                         Index tail, Index begin) {
  EndSlot& before = end(tail);
  const Side after = end(begin).side;
  const Index first_end = before.mate;
  const Index last_end = end(begin).mate;
  const bool is_closed = first_end == begin;
  Index& runs_after = runs_of(begin);  // for a ring, also the list of `before`
  Entry run;
  run.run = short_run(after.direction(),
                      links_between(before.side.place(), after.place(), pass.after_centroid));
  run.set_normal(before.normal());
  const bool is_prepended = before.runs == no_slot && runs_after != no_slot;
  if (is_prepended)
    Lists::prepend(slots_, runs_after, run);
  else
    Lists::append(slots_, before.runs, run);
  const Index list = before.runs;
  const Index list_after = runs_after;
  slots_.release(tail);
  slots_.release(begin);
  const bool is_loose_piece = is_loose(first_end) && is_loose(last_end);
  if (!is_closed && !is_loose_piece && !should_send(list, list_after))
    return connect(first_end, last_end, Lists::concatenate(slots_, list, list_after));
  Vertex corner = last_corner(pass, vertex);
  translate(corner, pass.after_centroid,
            links_between(place_of(corner), after.place(), pass.after_centroid));
  if (is_closed) {
    set_outgoing(Outgoing<Index>::Kind::ring, pass.incidence, list, corner);
    return;
  }
  if (is_prepended)
    translate(corner, pass.after_centroid, 0 - length_of(run.run));
  else
    move_to_begin(corner, pass.incidence, list);
  send(pass, first_end, last_end, Lists::concatenate(slots_, list, list_after), corner);
}

template <class Index, class Normal>
void Fragments<Index, Normal>::connect(Index begin, Index tail, Index list) {
  if (!is_loose(begin)) {
    end(begin).mate = tail;
    end(begin).runs = list;
  }
  if (!is_loose(tail)) {
    end(tail).mate = begin;
    end(tail).runs = list;
  }
}

// ---- at the seam of a slab ----

// No cell above the seam exists here, so no chain rises from this vertex. A pass with a rising
// queue has its link in the slice below. One function for both directions needs less flash and
// stack than two.
template <class Index, class Normal>
void Fragments<Index, Normal>::cut_at(const Pass& pass, const Vertex& vertex, bool ends) {
  DISCMC_LIMIT(!has_outgoing());
  Vertex at = ends ? vertex : next_vertex(pass, vertex);
  const Link along = ends ? pass.incoming : pass.after_centroid;
  const uint8_t queue = ends ? pass.in_queue : pass.out_queue;
  if (queue < first_rising_queue) return;
  const Index index = pop(queue);
  if (index == no_slot) return;
  if (ends) return end_tail(pass, index, along, at);
  const Side side = end(index).side;
  if (side.place() != place_of(at)) turn_back(index, along, place_of(at), side.direction(), {});
  cut_begin(pass, index, along, at);
}

// ---- short of slots ----

// Ends of links within the slice are lost last, because they leave their queue soon. Other ends are
// lost earlier if their chain has already lost an end, so that more regions stay whole. They are
// also lost earlier behind a lost end: a further lost end there only raises a count.
template <class Index, class Normal>
uint32_t Fragments<Index, Normal>::min_spare(uint8_t queue, Index mate) const {
  if (queue < first_rising_queue) return slots_per_pass;
  uint32_t needed = slots_per_pass + reserved_for_slice_;
  if (is_loose(mate)) needed += reserved_for_slice_ / 2;
  if (queues_.is_last_lost(slots_, queue)) needed += reserved_for_slice_ / 4;
  return needed;
}

// A fragment is long if it has more than a sixteenth of the spare slots. With less than 16 spare
// slots, every fragment with a run is long. Sending frees the slots that the pass has allocated.
template <class Index, class Normal>
bool Fragments<Index, Normal>::is_long(Index list, Index other) const {
  const uint32_t max_slots = spare() / 16;
  return Lists::slots_up_to(slots_, list, max_slots) +
             Lists::slots_up_to(slots_, other, max_slots) >
         max_slots;
}

// Sends the runs of a fragment that a vertex has lengthened, if there are too many. Index: of its
// tail or begin.
template <class Index, class Normal>
DISCMC_ALWAYS_INLINE void Fragments<Index, Normal>::send_if_long(const Pass& pass,
                                                                 const Vertex& vertex, Index index,
                                                                 bool is_tail) {
  const EndSlot& slot = end(index);
  const Index list = is_tail ? slot.runs : runs_of(index);
  if (!should_send(list)) return;
  // Finds the corner: the vertex, or the centroid behind it.
  Vertex start = vertex;
  if (slot.side.place() != place_of(vertex)) follow(start, pass.outgoing);
  if (!is_tail) return send(pass, index, slot.mate, list, start);
  move_to_begin(start, pass.incidence, list);
  send(pass, slot.mate, index, list, start);
}

// Moves a vertex from the end of a list of runs to the list's beginning.
template <class Index, class Normal>
void Fragments<Index, Normal>::move_to_begin(Vertex& at, Incidence incidence, Index list) const {
  const RunCursor<Index, Normal> first(slots_, list);
  RunCursor<Index, Normal> cursor = first;
  do {
    const ShortRun run = cursor.run(slots_);
    translate(at, incidence, direction_of(run), 0 - length_of(run));
    cursor.advance(slots_);
  } while (cursor != first);
}

// Sends the runs of a fragment. Its waiting ends then begin or end at the runs' ends.
template <class Index, class Normal>
void Fragments<Index, Normal>::send(const Pass& pass, Index begin, Index tail, Index list,
                                    const Vertex& start) {
  const Direction incoming =
      is_loose(begin) ? static_cast<Direction>(begin & 7) : end(begin).side.direction();
  set_outgoing(Outgoing<Index>::Kind::fragment, pass.incidence, list, start);
  outgoing_.incoming = incoming;
  const Direction last = direction_of(Lists::last_run(slots_, list));
  connect(begin, loose_end<Index>(), no_slot);
  connect(loose_end<Index>(last), tail, no_slot);
}

}  // namespace discmc::detail::trace

#endif
