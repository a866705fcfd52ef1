// Keeps holes until the ring around them closes.
//
// An outer ring closes after the holes of its region (DESIGN.md has the proof). Therefore a closing
// outer ring claims the holes of its plane that lie inside it; holes further inside have been
// claimed by rings between. Holes are rare. Lists by plane use slots of the pool, so holes need no
// capacity of their own. With 32-bit indices there may be many holes, which need a tree
// (hole_tree.hpp).
#ifndef DISCMC_TRACE_HOLES_HPP
#define DISCMC_TRACE_HOLES_HPP

#include <discmc/capacities.hpp>
#include <discmc/chain.hpp>
#include <discmc/trace/fragments.hpp>

namespace discmc::detail::trace {

template <class Index, class Normal>
class Holes {
 public:
  using Slots = Pool<Slot<Index, Normal>, Index>;
  using Cursor = RunCursor<Index, Normal>;

  static constexpr uint32_t slots_each = 2;

  /// heads: detail::sizing::hole_lists<Index> lists.
  void start(Index* heads) { heads_ = heads; }
  void clear() {
    for (uint32_t i = 0; i < detail::sizing::hole_lists<Index>; ++i) heads_[i] = no_slot;
    count_ = 0;
    peak_ = 0;
  }

  uint32_t count() const { return count_; }
  uint32_t peak() const { return peak_; }

  /// Keeps a ring. Limit: there are slots_each slots.
  void keep(Slots& slots, const Outgoing<Index>& ring);

  /// Whether there are holes on the plane of a vertex. Cost: the holes of a list.
  bool has_any(const Slots& slots, Incidence incidence, const Vertex& at) const;

  /// Marks the holes inside a ring, or all holes on the plane of a fragment. Returns their number.
  /// Limit: none is marked. Cost: the holes of the list, and the ring's runs; for each hole in the
  /// ring's extent, the runs again.
  uint32_t mark(Slots& slots, const Outgoing<Index>& chain);

  /// Removes one of the holes that the last mark() has marked. Returns its runs and their start.
  /// Limit: there is one.
  void remove(Slots& slots, Index& runs, Vertex& start);

  /// Finds a plane that has holes. Limit: count() > 0.
  void any_plane(const Slots& slots, Incidence& incidence, Vertex& at) const;

 private:
  uint32_t list_of(Incidence incidence, int32_t plane) const {
    // Multiplication by an odd constant near 2^32 over the golden ratio spreads neighbouring keys
    // (D. Knuth, The Art of Computer Programming, vol. 3, section 6.4).
    const uint32_t spread =
        (static_cast<uint32_t>(plane) * incidence_codes + incidence) * 0x9E3779B1U;
    return spread >> 16 & (detail::sizing::hole_lists<Index> - 1);
  }
  static bool lies_on(const Slots& slots, Index index, Incidence incidence, int32_t plane) {
    const Hole<Index>& hole = slots[index].hole;
    return hole.incidence == incidence &&
           plane_offset(incidence, slots[hole.start].hole_start.get()) == plane;
  }
  // The corners of a box around a ring.
  struct Extent {
    Vertex low, high;
    bool contains(const Vertex& v) const {
      return v.x >= low.x && v.y >= low.y && v.z >= low.z && v.x <= high.x && v.y <= high.y &&
             v.z <= high.z;
    }
  };
  static Extent extent_of(const Slots& slots, const Outgoing<Index>& ring);
  static bool surrounds(const Slots& slots, const Outgoing<Index>& ring, const Vertex& start,
                        Direction first);

  Index* heads_ = nullptr;
  uint32_t marked_list_ = 0;
  uint32_t count_ = 0;
  uint32_t peak_ = 0;
};

// ---- implementation ----

template <class Index, class Normal>
void Holes<Index, Normal>::keep(Slots& slots, const Outgoing<Index>& ring) {
  DISCMC_LIMIT(slots.available() >= slots_each);
  const Index index = slots.allocate();
  const Index start = slots.allocate();
  slots[start].hole_start.set(ring.start);
  Index& head = heads_[list_of(ring.incidence, plane_offset(ring.incidence, ring.start))];
  Hole<Index>& hole = slots[index].hole;
  hole.next = head;
  hole.runs = ring.runs;
  hole.start = start;
  hole.incidence = ring.incidence;
  hole.is_marked = 0;
  head = index;
  if (++count_ > peak_) peak_ = count_;
}

template <class Index, class Normal>
bool Holes<Index, Normal>::has_any(const Slots& slots, Incidence incidence,
                                   const Vertex& at) const {
  const int32_t plane = plane_offset(incidence, at);
  Index i = heads_[list_of(incidence, plane)];
  while (i != no_slot && !lies_on(slots, i, incidence, plane)) i = slots[i].linked.next;
  return i != no_slot;
}

template <class Index, class Normal>
uint32_t Holes<Index, Normal>::mark(Slots& slots, const Outgoing<Index>& chain) {
  uint32_t marked = 0;
  if (count_ == 0 || !has_any(slots, chain.incidence, chain.start)) return marked;
  const int32_t plane = plane_offset(chain.incidence, chain.start);
  const bool is_ring = chain.kind == Outgoing<Index>::Kind::ring;
  const Extent extent = is_ring ? extent_of(slots, chain) : Extent{};
  marked_list_ = list_of(chain.incidence, plane);
  for (Index i = heads_[marked_list_]; i != no_slot; i = slots[i].linked.next) {
    if (!lies_on(slots, i, chain.incidence, plane)) continue;
    Hole<Index>& hole = slots[i].hole;
    const Vertex start = slots[hole.start].hole_start.get();
    const Direction first = direction_of(Cursor(slots, hole.runs).run(slots));
    if (is_ring && !(extent.contains(start) && surrounds(slots, chain, start, first))) continue;
    hole.is_marked = 1;
    ++marked;
  }
  return marked;
}

template <class Index, class Normal>
void Holes<Index, Normal>::remove(Slots& slots, Index& runs, Vertex& start) {
  Index* link = &heads_[marked_list_];
  while (slots[*link].hole.is_marked == 0) link = &slots[*link].linked.next;
  const Index index = *link;
  const Hole<Index>& hole = slots[index].hole;
  *link = hole.next;
  runs = hole.runs;
  start = slots[hole.start].hole_start.get();
  slots.release(hole.start);
  slots.release(index);
  --count_;
}

template <class Index, class Normal>
void Holes<Index, Normal>::any_plane(const Slots& slots, Incidence& incidence, Vertex& at) const {
  DISCMC_LIMIT(count_ > 0);
  uint32_t i = 0;
  while (heads_[i] == no_slot) ++i;
  const Hole<Index>& hole = slots[heads_[i]].hole;
  incidence = hole.incidence;
  at = slots[hole.start].hole_start.get();
}

template <class Index, class Normal>
typename Holes<Index, Normal>::Extent Holes<Index, Normal>::extent_of(const Slots& slots,
                                                                      const Outgoing<Index>& ring) {
  Extent extent{ring.start, ring.start};
  const auto widen = [](int32_t& low, int32_t& high, int32_t to) {
    if (to < low) low = to;
    if (to > high) high = to;
  };
  Vertex at = ring.start;
  const Cursor begin(slots, ring.runs);
  Cursor cursor = begin;
  do {
    const ShortRun run = cursor.run(slots);
    translate(at, ring.incidence, direction_of(run), length_of(run));
    widen(extent.low.x, extent.high.x, at.x);
    widen(extent.low.y, extent.high.y, at.y);
    widen(extent.low.z, extent.high.z, at.z);
    cursor.advance(slots);
  } while (cursor != begin);
  return extent;
}

// Whether an outer ring surrounds a hole of its plane that starts at a vertex in a direction. The
// middle of the hole's first link lies on no other ring. It lies inside if a ray from it crosses
// the ring an odd number of times. The plane is projected along an axis that does not lie in it;
// only v may be z, along which a ring may be long. Coordinates relative to the hole fit into 32
// bits.
template <class Index, class Normal>
bool Holes<Index, Normal>::surrounds(const Slots& slots, const Outgoing<Index>& ring,
                                     const Vertex& start, Direction first) {
  const Vertex n = incidence_normal(ring.incidence);
  const int v = n.z != 0 ? 1 : 2;
  const int u = n.z != 0 || n.y != 0 ? 0 : 1;
  const auto step = [&](Direction direction) {
    return detail::link_table.vector[link_of(ring.incidence, direction)];
  };
  // The middle, relative to the hole's start, is half of `link`, in half-steps. The ring's vertex
  // follows.
  const int8_t* const link = step(first);
  int32_t at_u = component(ring.start, u) - component(start, u);
  int32_t at_v = component(ring.start, v) - component(start, v);
  const auto is_above = [&](int32_t at) { return at > link[v] >> 1; };
  bool is_inside = false;
  const Cursor begin(slots, ring.runs);
  Cursor cursor = begin;
  do {
    const ShortRun run = cursor.run(slots);
    const int32_t length = static_cast<int32_t>(length_of(run));
    const int8_t* const side = step(direction_of(run));
    const int32_t end_v = at_v + length * side[v];
    if (is_above(at_v) != is_above(end_v)) {
      // The position at which the side crosses the line of the ray, times the step in v. It is
      // never 0. At a crossing, at_v is small.
      const int32_t crossing = (2 * at_u - link[u]) * side[v] - (2 * at_v - link[v]) * side[u];
      if ((crossing > 0) == (side[v] > 0)) is_inside = !is_inside;
    }
    at_u += length * side[u];
    at_v = end_v;
    cursor.advance(slots);
  } while (cursor != begin);
  return is_inside;
}

}  // namespace discmc::detail::trace

#endif
