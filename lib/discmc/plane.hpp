// Chains in their plane: where they lead, and what lies inside a closed one.
//
// Coordinates wrap: any start and any runs are safe, and those of a scan come out right.
#ifndef DISCMC_PLANE_HPP
#define DISCMC_PLANE_HPP

#include <discmc/chain.hpp>

namespace discmc {

/// Whether a number is an incidence, a direction in its planes, a run along these.
constexpr bool is_incidence(Incidence incidence) {
  return incidence < incidence_codes && incidence != no_incidence;
}
constexpr bool is_direction_of(Incidence incidence, Direction direction) {
  return direction < direction_count(incidence);
}
constexpr bool is_run_of(Incidence incidence, Run run) {
  return is_direction_of(incidence, run.direction()) && run.length() >= 1 &&
         run.length() <= Run::max_length;
}

/// Where a run leads.
constexpr Vertex after_run(Incidence incidence, const Vertex& from, Run run) {
  Vertex to = from;
  move(to, incidence, run.direction(), run.length());
  return to;
}

/// The offset n.p of the plane that a vertex lies in.
constexpr int32_t plane_offset(Incidence incidence, const Vertex& p) {
  const Vertex n = normal(incidence);
  const auto term = [](int32_t factor, int32_t coordinate) {
    return static_cast<uint32_t>(factor) * static_cast<uint32_t>(coordinate);
  };
  return static_cast<int32_t>(term(n.x, p.x) + term(n.y, p.y) + term(n.z, p.z));
}

/// A point or a vector of a plane, projected along an axis that the plane does not contain.
struct PlanePoint {
  int64_t u, v;
};

constexpr PlanePoint projected(Incidence incidence, const Vertex& p) {
  const Vertex n = normal(incidence);
  if (n.z != 0) return {p.x, p.y};
  if (n.y != 0) return {p.x, p.z};
  return {p.y, p.z};
}

/// A point of the region that a ring bounds, close to the middle of the ring's first link: to the
/// left of it, for outer rings and holes alike. No ring of a surface passes through it.
/// Units: eighths of a half-step.
constexpr PlanePoint point_beside(Incidence incidence, const Vertex& start, Direction first) {
  const Vertex link = direction_vector(incidence, first);
  const PlanePoint begin = projected(incidence, start);
  const PlanePoint forward = projected(incidence, link);
  const PlanePoint left = projected(incidence, cross(normal(incidence), link));
  return {8 * begin.u + 4 * forward.u + left.u, 8 * begin.v + 4 * forward.v + left.v};
}

/// A run where it lies, projected. A point lies inside a ring when the ray from it along u meets an
/// odd number of the ring's sides.
class PlaneSide {
 public:
  constexpr PlaneSide(Incidence incidence, const Vertex& from, Run run)
      : begin_(projected(incidence, from)),
        end_v_(projected(incidence, after_run(incidence, from, run)).v),
        step_(projected(incidence, direction_vector(incidence, run.direction()))) {}

  /// A side has its lower end and not its upper one, so that of two that meet on the ray one
  /// counts. Units of the point: eighths of a half-step.
  constexpr bool meets_ray(const PlanePoint& point) const {
    if ((8 * begin_.v > point.v) == (8 * end_v_ > point.v)) return false;
    const int64_t side = step_.u * (point.v - 8 * begin_.v) - step_.v * (point.u - 8 * begin_.u);
    return (side > 0) == (step_.v > 0);
  }

 private:
  PlanePoint begin_;
  int64_t end_v_;
  PlanePoint step_;
};

}  // namespace discmc

#endif
