// Keeps waiting holes sorted by position, for the many holes that 32-bit indices can count. The
// holes and their order equal those of the lists (holes.hpp).
#ifndef DISCMC_TRACE_HOLE_TREE_HPP
#define DISCMC_TRACE_HOLE_TREE_HPP

#include <discmc/geometry/ring_tree.hpp>
#include <discmc/trace/holes.hpp>

namespace discmc::detail::trace {

template <class Normal>
class Holes<uint32_t, Normal> {
 public:
  using Slots = Pool<Slot<uint32_t, Normal>, uint32_t>;
  using Ring = Outgoing<uint32_t>;

  static constexpr uint32_t slots_each = 2;

  void start(uint32_t* /*heads*/) {}
  void clear() { *this = Holes(); }

  uint32_t count() const { return count_; }
  uint32_t peak() const { return peak_; }

  /// Keeps a ring. Limit: there are slots_each slots.
  void keep(Slots& slots, const Ring& ring) {
    const uint32_t index = slots.allocate();
    const uint32_t start = slots.allocate();
    Hole<uint32_t>& hole = slots[index].hole;
    hole.number = number_++;
    hole.runs = ring.runs;
    hole.start = start;
    hole.set(ring.incidence, direction_of(Cursor(slots, ring.runs).run(slots)));
    slots[start].hole_start.set(ring.start);
    waiting_.insert(Nodes{slots}, index);
    if (++count_ > peak_) peak_ = count_;
  }

  /// Whether there are holes on the plane of a vertex, between two corners of a box. Units:
  /// half-steps. Cost: a look-up in a tree per line with holes.
  bool has_any(Slots& slots, Incidence incidence, const Vertex& at, const ProjectedPoint& low,
               const ProjectedPoint& high) const {
    return waiting_.has_any(Nodes{slots}, incidence, at, {8 * low.u, 8 * low.v},
                            {8 * high.u, 8 * high.v});
  }

  /// Marks the holes inside a ring, or all holes on the plane of a fragment. Returns their number.
  /// Limit: none is marked. Cost: a look-up per line of the plane that a side crosses and that has
  /// holes, and per marked hole.
  uint32_t mark(Slots& slots, const Ring& chain) {
    uint32_t marked = 0;
    if (count_ == 0) return marked;
    if (chain.kind == Ring::Kind::ring) return mark_inside(slots, chain);
    for (;; ++marked) {
      const uint32_t hole = waiting_.any_on_plane(Nodes{slots}, chain.incidence, chain.start);
      if (hole == no_slot) return marked;
      mark_one(slots, hole);
    }
  }

  /// Removes one of the holes that the last mark() has marked, the newest first. Returns its runs
  /// and their start. Limit: there is one.
  void remove(Slots& slots, uint32_t& runs, Vertex& start) {
    const uint32_t index = marked_.first(Newest{{slots}}, [](uint32_t) { return true; });
    marked_.remove(Newest{{slots}}, index);
    const Hole<uint32_t>& hole = slots[index].hole;
    runs = hole.runs;
    start = slots[hole.start].hole_start.get();
    slots.release(hole.start);
    slots.release(index);
    --count_;
  }

  /// Finds a plane that has holes. Limit: count() > 0, and none is marked.
  void any_plane(const Slots& slots, Incidence& incidence, Vertex& at) const {
    const Hole<uint32_t>& hole = slots[waiting_.any()].hole;
    incidence = hole.incidence();
    at = slots[hole.start].hole_start.get();
  }

 private:
  using Cursor = RunCursor<uint32_t, Normal>;

  // Presents the slots as nodes of trees.
  struct Nodes {
    Slots& slots;
    Incidence incidence(uint32_t hole) const { return slots[hole].hole.incidence(); }
    Direction first(uint32_t hole) const { return slots[hole].hole.first(); }
    Vertex start(uint32_t hole) const { return node(hole).get(); }
    uint32_t& left(uint32_t hole) const { return node(hole).left; }
    uint32_t& right(uint32_t hole) const { return node(hole).right; }
    HoleStart<uint32_t>& node(uint32_t hole) const {
      return slots[slots[hole].hole.start].hole_start;
    }
  };
  struct Newest : Nodes {
    bool precedes(uint32_t hole, uint32_t other) const {
      const uint32_t difference = this->slots[hole].hole.number - this->slots[other].hole.number;
      return static_cast<int32_t>(difference) > 0;
    }
  };

  uint32_t mark_inside(Slots& slots, const Ring& ring);
  void mark_one(Slots& slots, uint32_t hole) {
    waiting_.remove(Nodes{slots}, hole);
    marked_.insert(Newest{{slots}}, hole);
  }

  // Calls visit(vertex, run) for the sides of a ring.
  template <class Visit>
  static void for_each_side(const Slots& slots, const Ring& ring, Visit visit) {
    Vertex at = ring.start;
    const Cursor begin(slots, ring.runs);
    Cursor cursor = begin;
    do {
      const Run run = long_run(cursor.run(slots));
      visit(at, run);
      at = after_run(ring.incidence, at, run);
      cursor.advance(slots);
    } while (cursor != begin);
  }
  // Calls visit(hole, crossing, leads_inside) for each crossing with the sides of a ring:
  // RingTree::cross().
  template <class Visit>
  void for_each_crossing(Slots& slots, const Ring& ring, Visit visit) {
    for_each_side(slots, ring, [&](const Vertex& at, Run run) {
      const RingSide side(ring.incidence, at, run);
      waiting_.cross(Nodes{slots}, ring.incidence, ring.start, side,
                     [&](uint32_t hole, int64_t crossing) {
                       visit(slots[hole].hole, hole, crossing, side.leads_left());
                     });
    });
  }
  bool may_surround_any(Slots& slots, const Ring& ring) const;

  RingTree<Nodes> waiting_;
  Treap<Newest> marked_;
  uint32_t number_ = 0;  // of the next hole
  uint32_t count_ = 0;
  uint32_t peak_ = 0;
};

// ---- implementation ----

template <class Normal>
uint32_t Holes<uint32_t, Normal>::mark_inside(Slots& slots, const Ring& ring) {
  uint32_t marked = 0;
  if (!may_surround_any(slots, ring)) return marked;
  using H = Hole<uint32_t>;
  for_each_crossing(slots, ring, [](H& hole, uint32_t, int64_t crossing, bool leads_inside) {
    if (!hole.is_noted() || crossing > hole.crossing()) hole.set_note(crossing, leads_inside);
  });
  for_each_crossing(slots, ring, [&](const H& hole, uint32_t index, int64_t, bool) {
    if (!hole.leads_inside()) return;
    uint32_t inside = index;
    do {
      const uint32_t next = waiting_.next_on_line(Nodes{slots}, inside);
      mark_one(slots, inside);
      ++marked;
      inside = next;
    } while (inside != no_slot && !slots[inside].hole.is_noted());
  });
  for_each_crossing(slots, ring, [](H& hole, uint32_t, int64_t, bool) { hole.clear_note(); });
  return marked;
}

// Whether there are holes in the box around a ring; most rings have none.
template <class Normal>
bool Holes<uint32_t, Normal>::may_surround_any(Slots& slots, const Ring& ring) const {
  ProjectedPoint low = projected(ring.incidence, ring.start), high = low;
  for_each_side(slots, ring,
                [&](const Vertex& at, Run) { widen(low, high, projected(ring.incidence, at)); });
  return has_any(slots, ring.incidence, ring.start, low, high);
}

}  // namespace discmc::detail::trace

#endif
