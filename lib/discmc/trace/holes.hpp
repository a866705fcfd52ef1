// Holes wait for the ring around them.
//
// An outer ring closes after the holes in it, for no hole reaches as far along the sweep as what
// surrounds it. So an outer ring that closes takes the holes of its plane that lie in it; those
// further in were taken by the rings between. Holes are rare: lists by plane, whose records come
// from the pool, so that they have no capacity of their own to be set wrong.
#ifndef DISCMC_TRACE_HOLES_HPP
#define DISCMC_TRACE_HOLES_HPP

#include <discmc/trace/fragments.hpp>

namespace discmc::trace {

/// The plane of a vertex among those of an incidence. Wraps.
inline uint32_t plane_of(Incidence incidence, const Vertex& v) {
  const Vertex n = normal(incidence);
  return static_cast<uint32_t>(n.x) * static_cast<uint32_t>(v.x) +
         static_cast<uint32_t>(n.y) * static_cast<uint32_t>(v.y) +
         static_cast<uint32_t>(n.z) * static_cast<uint32_t>(v.z);
}

template <class Index, class Normal>
class Holes {
 public:
  using Records = Pool<Record<Index, Normal>, Index>;
  using Cursor = RunCursor<Index, Normal>;

  static constexpr uint32_t records_each = 2;

  /// heads: of the lists; a power of two of them.
  void start(Index* heads, uint32_t heads_count) {
    heads_ = heads;
    heads_mask_ = heads_count - 1;
  }
  void clear() {
    for (uint32_t i = 0; i <= heads_mask_; ++i) heads_[i] = no_record;
    count_ = 0;
    high_water_ = 0;
    incidences_ = 0;
  }

  uint32_t count() const { return count_; }
  uint32_t high_water() const { return high_water_; }

  /// Keeps a ring. Limit: there are records_each records.
  void keep(Records& records, const Outgoing<Index>& ring);

  /// Marks the holes that lie in a ring, and counts them. Cost: the holes of the plane times the
  /// ring's runs.
  uint32_t mark_within(Records& records, const Outgoing<Index>& ring) const;
  /// Marks all holes of a plane, and counts them.
  uint32_t mark_plane(Records& records, Incidence incidence, const Vertex& at) const;

  /// Takes a marked hole of a plane out. Limit: there is one.
  void take(Records& records, Outgoing<Index>& out);

  /// A plane that has holes. Limit: count() > 0.
  void any_plane(const Records& records, Incidence& incidence, Vertex& at) const;

 private:
  Index& head_of(Incidence incidence, const Vertex& at) const {
    // Multiplication by an odd constant near 2^32 over the golden ratio spreads neighbouring keys
    // (D. Knuth, The Art of Computer Programming, vol. 3, section 6.4).
    const uint32_t spread =
        (plane_of(incidence, at) * incidence_codes + incidence) * 0x9E3779B1U;
    return heads_[spread >> 16 & heads_mask_];
  }
  template <class Wanted>
  uint32_t mark(Records& records, Incidence incidence, const Vertex& at, Wanted is_wanted) const;
  static bool surrounds(const Records& records, const Outgoing<Index>& ring, const Vertex& start,
                        Direction first);

  Index* heads_ = nullptr;
  uint32_t heads_mask_ = 0;
  uint32_t count_ = 0;
  uint32_t high_water_ = 0;
  uint32_t incidences_ = 0;  // a bit for each that may have holes
};

// ---- implementation ----

template <class Index, class Normal>
void Holes<Index, Normal>::keep(Records& records, const Outgoing<Index>& ring) {
  const Index index = records.take();
  const Index start = records.take();
  records[start].hole_start.set(ring.start);
  Index& head = head_of(ring.incidence, ring.start);
  Hole<Index>& hole = records[index].hole;
  hole.next = head;
  hole.last = ring.last;
  hole.start = start;
  hole.incidence = ring.incidence;
  hole.is_marked = 0;
  head = index;
  incidences_ |= uint32_t{1} << ring.incidence;
  if (++count_ > high_water_) high_water_ = count_;
}

template <class Index, class Normal>
template <class Wanted>
uint32_t Holes<Index, Normal>::mark(Records& records, Incidence incidence, const Vertex& at,
                                    Wanted is_wanted) const {
  uint32_t marked = 0;
  if ((incidences_ >> incidence & 1) == 0) return marked;
  const uint32_t plane = plane_of(incidence, at);
  for (Index i = head_of(incidence, at); i != no_record; i = records[i].linked.next) {
    Hole<Index>& hole = records[i].hole;
    if (hole.incidence != incidence) continue;
    const Vertex start = records[hole.start].hole_start.get();
    if (plane_of(incidence, start) != plane || !is_wanted(hole, start)) continue;
    hole.is_marked = 1;
    ++marked;
  }
  return marked;
}

template <class Index, class Normal>
uint32_t Holes<Index, Normal>::mark_within(Records& records, const Outgoing<Index>& ring) const {
  return mark(records, ring.incidence, ring.start, [&](const Hole<Index>& hole, const Vertex& at) {
    const ShortRun first = Cursor(records, hole.last).run(records);
    return surrounds(records, ring, at, direction_of(first));
  });
}

template <class Index, class Normal>
uint32_t Holes<Index, Normal>::mark_plane(Records& records, Incidence incidence,
                                          const Vertex& at) const {
  return mark(records, incidence, at, [](const Hole<Index>&, const Vertex&) { return true; });
}

template <class Index, class Normal>
void Holes<Index, Normal>::take(Records& records, Outgoing<Index>& out) {
  Index* link = &head_of(out.incidence, out.start);
  const auto is_wanted = [&](const Hole<Index>& hole) {
    return hole.is_marked != 0 && hole.incidence == out.incidence;
  };
  while (!is_wanted(records[*link].hole)) link = &records[*link].linked.next;
  const Index index = *link;
  const Hole<Index> hole = records[index].hole;
  *link = hole.next;
  out.last = hole.last;
  out.start = records[hole.start].hole_start.get();
  records.give(hole.start);
  records.give(index);
  if (--count_ == 0) incidences_ = 0;
}

template <class Index, class Normal>
void Holes<Index, Normal>::any_plane(const Records& records, Incidence& incidence,
                                     Vertex& at) const {
  uint32_t i = 0;
  while (heads_[i] == no_record) ++i;
  const Hole<Index>& hole = records[heads_[i]].hole;
  incidence = hole.incidence;
  at = records[hole.start].hole_start.get();
}

// Whether an outer ring surrounds a hole of its plane that starts at a vertex in a direction. A
// point beside the middle of the hole's first link, within a facet and so on no ring, lies inside
// if a ray from it crosses the ring an odd number of times. Units: eighths of a half-step.
template <class Index, class Normal>
bool Holes<Index, Normal>::surrounds(const Records& records, const Outgoing<Index>& ring,
                                     const Vertex& start, Direction first) {
  const Vertex n = normal(ring.incidence);
  const int dropped = n.z != 0 ? 2 : n.y != 0 ? 1 : 0;
  const int u = dropped == 0 ? 1 : 0;
  const int v = dropped == 2 ? 1 : 2;
  const Direction count = direction_count(ring.incidence);
  const Direction left = static_cast<Direction>(first + 1 < count ? first + 1 : 0);
  const Vertex along = direction_vector(ring.incidence, first);
  const Vertex aside = direction_vector(ring.incidence, left);
  // From the point to the ring's vertex.
  const auto from_point = [&](int axis) {
    return 8 * (int64_t{coordinate(ring.start, axis)} - coordinate(start, axis)) -
           int64_t{4} * coordinate(along, axis) - coordinate(aside, axis);
  };
  int64_t at_u = from_point(u);
  int64_t at_v = from_point(v);
  bool is_inside = false;
  const Cursor begin(records, ring.last);
  Cursor cursor = begin;
  do {
    const Run run = long_run(cursor.run(records));
    const Vertex step = direction_vector(ring.incidence, run.direction());
    const int32_t step_u = coordinate(step, u);
    const int32_t step_v = coordinate(step, v);
    const int64_t length = 8 * int64_t{run.length()};
    const int64_t end_v = at_v + length * step_v;
    if ((at_v > 0) != (end_v > 0)) {
      // Where the side crosses the ray's line, times step_v.
      const int64_t crossing = at_u * step_v - at_v * step_u;
      if (step_v > 0 ? crossing > 0 : crossing < 0) is_inside = !is_inside;
    }
    at_u += length * step_u;
    at_v = end_v;
    cursor.advance(records);
  } while (cursor != begin);
  return is_inside;
}

}  // namespace discmc::trace

#endif
