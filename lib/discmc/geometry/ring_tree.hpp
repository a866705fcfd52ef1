// A tree of waiting rings, sorted by plane and by position in the plane.
//
// The tree finds which rings lie inside another ring. A point beside each ring represents it, so
// the ring lies on one line of its plane. The nearest side of the other ring before the point
// decides, as that side leads inside or outside. Therefore each side of the other ring is noted at
// the next ring behind it, on every line that it crosses. Rings between two notes are on the same
// side, and need no look-up.
#ifndef DISCMC_GEOMETRY_RING_TREE_HPP
#define DISCMC_GEOMETRY_RING_TREE_HPP

#include <discmc/chain.hpp>
#include <discmc/geometry/treap.hpp>

namespace discmc {

/// A point or a vector of a plane, projected along an axis that the plane does not contain: u is
/// along x or y.
struct ProjectedPoint {
  int64_t u, v;
};

constexpr ProjectedPoint projected(Incidence incidence, const Vertex& p) {
  const Vertex n = incidence_normal(incidence);
  if (n.z != 0) return {p.x, p.y};
  if (n.y != 0) return {p.x, p.z};
  return {p.y, p.z};
}

/// Widens a box so that it contains a point.
constexpr void widen(ProjectedPoint& low, ProjectedPoint& high, const ProjectedPoint& point) {
  if (point.u < low.u) low.u = point.u;
  if (point.v < low.v) low.v = point.v;
  if (point.u > high.u) high.u = point.u;
  if (point.v > high.v) high.v = point.v;
}

/// A point of the region that a ring bounds. It lies close to the middle of the ring's first link
/// and to the left of the link, for outer rings and holes alike. No ring of a surface passes
/// through this point. Units: eighths of a half-step.
constexpr ProjectedPoint point_beside(Incidence incidence, const Vertex& start, Direction first) {
  const Vertex link = direction_vector(incidence, first);
  const ProjectedPoint begin = projected(incidence, start);
  const ProjectedPoint forward = projected(incidence, link);
  const ProjectedPoint left = projected(incidence, cross(incidence_normal(incidence), link));
  return {8 * begin.u + 4 * forward.u + left.u, 8 * begin.v + 4 * forward.v + left.v};
}

/// A side of a ring, in its plane. Units: eighths of a half-step. A side crosses the line at its
/// lower end, and not the line at its upper end. If two sides meet on a line, one crosses.
class RingSide {
 public:
  RingSide(Incidence incidence, const Vertex& from, Run run) {
    const Vertex link = direction_vector(incidence, run.direction());
    const ProjectedPoint step = projected(incidence, link);
    const ProjectedPoint begin = projected(incidence, from);
    const ProjectedPoint end = projected(incidence, after_run(incidence, from, run));
    first_line_ = 8 * (begin.v < end.v ? begin.v : end.v);
    end_line_ = 8 * (begin.v < end.v ? end.v : begin.v);
    slope_ = static_cast<int32_t>(step.u * step.v);  // -1, 0 or 1
    on_line_0_ = 8 * (begin.u - slope_ * begin.v);
    leads_left_ = projected(incidence, cross(incidence_normal(incidence), link)).u > 0;
  }

  /// The crossed lines: from first_line() to before the end.
  int64_t first_line() const { return first_line_; }
  int64_t end_line() const { return end_line_; }
  /// Its position on a line.
  int64_t crossing(int64_t line) const { return on_line_0_ + slope_ * line; }
  /// Its position half an eighth above a line, where two sides that meet on the line are apart.
  /// Units: sixteenths of a half-step.
  int64_t crossing_above(int64_t line) const { return 2 * crossing(line) + slope_; }
  /// Whether it is crossed towards larger u from its right to its left: into an outer ring, and out
  /// of a hole.
  bool leads_left() const { return leads_left_; }

 private:
  int64_t first_line_;
  int64_t end_line_;
  int64_t on_line_0_;  // where it would cross line 0
  int32_t slope_;
  bool leads_left_;
};

/// Look-ups are not inlined, because many places call them rarely.
/// Rings: a type with left(ring) and right(ring), which return links by reference, and with
/// incidence(ring), start(ring) and first(ring), the direction of the first link. Rings are numbers
/// from 1 on. Cost of every function: the depth of a treap; for has_any() and cross(), per line.
template <class Rings>
class RingTree {
 public:
  /// Returns any ring, or no_slot.
  uint32_t any() const { return tree_.root(); }

  DISCMC_NOINLINE void insert(const Rings& rings, uint32_t ring) {
    tree_.insert(Nodes{rings}, ring);
  }
  DISCMC_NOINLINE void remove(const Rings& rings, uint32_t ring) {
    tree_.remove(Nodes{rings}, ring);
  }

  /// Returns any ring on the plane of a vertex, or no_slot.
  DISCMC_NOINLINE uint32_t any_on_plane(const Rings& rings, Incidence incidence,
                                        const Vertex& at) const {
    const Plane plane{incidence, plane_offset(incidence, at)};
    return tree_.find(Nodes{rings}, [&](uint32_t ring) {
      const Plane own = plane_of(rings, ring);
      if (own.incidence != plane.incidence) return own.incidence - plane.incidence;
      return (own.offset > plane.offset) - (own.offset < plane.offset);
    });
  }

  /// Returns the next ring on the line of a ring, or no_slot.
  DISCMC_NOINLINE uint32_t next_on_line(const Rings& rings, uint32_t ring) const {
    const ProjectedPoint at = point(rings, ring);
    return first_on_line(rings, plane_of(rings, ring), {at.u + 1, at.v});
  }

  /// Whether a ring waits on the plane of a vertex, between two corners of a box: eighths of a
  /// half-step.
  bool has_any(const Rings& rings, Incidence incidence, const Vertex& at, const ProjectedPoint& low,
               const ProjectedPoint& high) const {
    const Plane plane{incidence, plane_offset(incidence, at)};
    int64_t line = low.v;
    for (;;) {
      const uint32_t ring = first_from(rings, plane, {low.u, line});
      if (ring == no_slot || !is_on(rings, ring, plane)) return false;
      const ProjectedPoint at_ring = point(rings, ring);
      if (at_ring.v > high.v) return false;
      if (at_ring.u > high.u)
        line = at_ring.v + 1;
      else if (at_ring.u < low.u)
        line = at_ring.v;
      else
        return true;
    }
  }

  /// Calls visit(ring, crossing) for the ring behind a side of another ring, on each line that the
  /// side crosses: RingSide::crossing_above(). at: a vertex of the plane.
  template <class Visit>
  void cross(const Rings& rings, Incidence incidence, const Vertex& at, const RingSide& side,
             Visit visit) const {
    const Plane plane{incidence, plane_offset(incidence, at)};
    for (int64_t line = side.first_line(); line < side.end_line(); ++line) {
      uint32_t ring = first_from(rings, plane, {INT64_MIN, line});
      if (ring == no_slot || !is_on(rings, ring, plane)) return;
      line = point(rings, ring).v;
      if (line >= side.end_line()) return;
      ring = first_on_line(rings, plane, {side.crossing(line), line});
      if (ring != no_slot) visit(ring, side.crossing_above(line));
    }
  }

 private:
  struct Plane {
    Incidence incidence;
    int32_t offset;
  };

  struct Nodes {
    const Rings& rings;
    uint32_t& left(uint32_t ring) const { return rings.left(ring); }
    uint32_t& right(uint32_t ring) const { return rings.right(ring); }
    bool precedes(uint32_t ring, uint32_t other) const {
      const Plane plane = plane_of(rings, other);
      const ProjectedPoint at = point(rings, other);
      if (is_behind(rings, ring, plane, {at.u + 1, at.v})) return false;
      // Two rings may be equal. Without an order of equal rings the tree would be deep.
      return !is_behind(rings, ring, plane, at) || ring < other;
    }
  };

  static Plane plane_of(const Rings& rings, uint32_t ring) {
    const Incidence incidence = rings.incidence(ring);
    return {incidence, plane_offset(incidence, rings.start(ring))};
  }
  static bool is_on(const Rings& rings, uint32_t ring, const Plane& plane) {
    return rings.incidence(ring) == plane.incidence &&
           plane_offset(plane.incidence, rings.start(ring)) == plane.offset;
  }
  DISCMC_NOINLINE static ProjectedPoint point(const Rings& rings, uint32_t ring) {
    return point_beside(rings.incidence(ring), rings.start(ring), rings.first(ring));
  }
  // Whether a ring lies at a point or behind it, by plane, line and position on the line.
  static bool is_behind(const Rings& rings, uint32_t ring, const Plane& plane,
                        const ProjectedPoint& at) {
    const Incidence incidence = rings.incidence(ring);
    if (incidence != plane.incidence) return incidence > plane.incidence;
    const int32_t offset = plane_offset(incidence, rings.start(ring));
    if (offset != plane.offset) return offset > plane.offset;
    const ProjectedPoint own = point(rings, ring);
    return own.v > at.v || (own.v == at.v && own.u >= at.u);
  }
  DISCMC_NOINLINE uint32_t first_from(const Rings& rings, const Plane& plane,
                                      const ProjectedPoint& at) const {
    return tree_.first(Nodes{rings},
                       [&](uint32_t ring) { return is_behind(rings, ring, plane, at); });
  }
  uint32_t first_on_line(const Rings& rings, const Plane& plane, const ProjectedPoint& at) const {
    const uint32_t ring = first_from(rings, plane, at);
    const bool is_there =
        ring != no_slot && is_on(rings, ring, plane) && point(rings, ring).v == at.v;
    return is_there ? ring : no_slot;
  }

  Treap<Nodes> tree_;
};

}  // namespace discmc

#endif
