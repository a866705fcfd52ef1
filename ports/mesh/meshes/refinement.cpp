#include "refinement.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "point_distance.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {
namespace {

bool is_corner(const std::array<PlanePoint, 3>& corners, const PlanePoint& point) {
  return std::any_of(corners.begin(), corners.end(), [&point](const PlanePoint& corner) {
    return corner.u == point.u && corner.v == point.v;
  });
}

std::int64_t floor_of_quotient(std::int64_t a, std::int64_t b) {
  return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}
std::int64_t ceiling_of_quotient(std::int64_t a, std::int64_t b) {
  return -floor_of_quotient(-a, b);
}

// The points of a row that lie within a triangle.
class RowWithin {
 public:
  explicit RowWithin(std::int64_t v) : v_(v) {}

  // Keeps points to the left of an edge, and points on it if with_edge.
  void cut(const PlanePoint& from, const PlanePoint& to, bool with_edge) {
    const std::int64_t du = to.u - from.u, dv = to.v - from.v, product = du * (v_ - from.v);
    if (dv > 0)
      last = std::min(last, from.u + (with_edge ? floor_of_quotient(product, dv)
                                                : ceiling_of_quotient(product, dv) - 1));
    else if (dv < 0)
      first = std::max(first, from.u + (with_edge ? ceiling_of_quotient(product, dv)
                                                  : floor_of_quotient(product, dv) + 1));
    else if (v_ == from.v && !with_edge)
      last = first - 1;
  }

  std::int64_t first = -2 * max_plane_coordinate;
  std::int64_t last = 2 * max_plane_coordinate;

 private:
  std::int64_t v_;
};

// Calls `call` for all crossings in a triangle except its corners. with_side: includes one side per
// corner, from that corner to the next.
template <class Call>
void for_each_crossing(const LatticePlane& plane, const std::array<PlanePoint, 3>& corners,
                       const std::array<bool, 3>& with_side, Call call) {
  const auto [low, high] = std::minmax({corners[0].v, corners[1].v, corners[2].v});
  for (std::int64_t v = low; v <= high; ++v) {
    RowWithin row(v);
    for (std::size_t i = 0; i < 3; ++i) row.cut(corners[i], corners[(i + 1) % 3], with_side[i]);
    for (std::int64_t u = row.first; u <= row.last; ++u) {
      const Vertex vertex = plane.vertex({u, v});
      if (is_middle(vertex) && !is_corner(corners, {u, v})) call(PlanePoint{u, v}, vertex);
    }
  }
}

// Whether a side has crossings between its ends.
bool has_crossings(const Vertex& from, const Vertex& to) {
  const Side side = side_between(from, to);
  Vertex vertex = from;
  for (std::int32_t i = 1; i < side.links; ++i) {
    vertex = vertex + side.link;
    if (is_middle(vertex)) return true;
  }
  return false;
}

}  // namespace

Refinement::Refinement(const Crossings& crossings, double tolerance)
    : crossings_(crossings),
      // Finite, so that a required vertex, at infinite distance, always exceeds it.
      squared_tolerance_(std::min(4 * tolerance * tolerance, std::numeric_limits<double>::max())) {}

const std::vector<std::size_t>& Refinement::needed(const std::vector<Vertex>& side) {
  needed_.clear();
  if (side.size() == 2) return needed_;  // the usual case
  side_.resize(side.size());
  for (std::size_t i = 0; i < side.size(); ++i)
    if (i == 0 || i + 1 == side.size() || is_middle(side[i])) side_[i] = moved(side[i]);
  spans_.assign(1, {0, side.size() - 1});
  while (!spans_.empty()) {
    const auto [begin, end] = spans_.back();
    spans_.pop_back();
    double max_distance = squared_tolerance_;
    std::size_t farthest = begin;
    for (std::size_t i = begin + 1; i < end; ++i) {
      if (!is_middle(side[i])) continue;  // a centroid, the mean of crossings, adds nothing
      const double distance = squared_distance(side_[i], std::array{side_[begin], side_[end]});
      if (distance <= max_distance) continue;
      max_distance = distance;
      farthest = i;
    }
    if (farthest == begin) continue;
    needed_.push_back(farthest);
    spans_.emplace_back(begin, farthest);
    spans_.emplace_back(farthest, end);
  }
  return needed_;
}

void Refinement::refine(const LatticePlane& plane, const VertexNumbers& required,
                        MovedTriangles& triangles) {
  flips_.improve(triangles.points, triangles.triangles);
  waiting_.resize(triangles.triangles.size());
  std::iota(waiting_.begin(), waiting_.end(), 0U);
  waits_.assign(waiting_.size(), true);
  triangles.leaves_out.resize(waiting_.size());
  while (!waiting_.empty()) {
    const std::uint32_t triangle = waiting_.back();
    waiting_.pop_back();
    waits_[triangle] = false;
    const Farthest added = farthest(plane, required, triangles, triangle);
    triangles.leaves_out[triangle] = added.leaves_out;
    if (added.squared_distance <= squared_tolerance_) continue;
    triangles.points.push_back(added.point);
    triangles.moved.push_back(added.moved);
    flips_.insert(triangles.points, triangles.triangles, triangle);
    waits_.resize(triangles.triangles.size(), false);
    triangles.leaves_out.resize(triangles.triangles.size());
    for (const std::uint32_t changed : flips_.changed()) {
      if (waits_[changed]) continue;
      waits_[changed] = true;
      waiting_.push_back(changed);
    }
  }
}

Refinement::Farthest Refinement::farthest(const LatticePlane& plane, const VertexNumbers& required,
                                          const MovedTriangles& triangles,
                                          std::uint32_t triangle) const {
  std::array<PlanePoint, 3> corners;
  std::array<Point, 3> moved_corners;
  std::array<bool, 3> is_shared;
  for (std::uint32_t i = 0; i < 3; ++i) {
    corners[i] = triangles.points[triangles.triangles[triangle][i]];
    moved_corners[i] = triangles.moved[triangles.triangles[triangle][i]];
    is_shared[i] = flips_.is_shared(triangle, i);
  }
  Farthest result{};
  for_each_crossing(plane, corners, is_shared, [&](const PlanePoint& at, const Vertex& vertex) {
    result.leaves_out = true;
    const Point point = moved(vertex);
    const double distance = required.has(vertex) ? std::numeric_limits<double>::infinity()
                                                 : squared_distance(point, moved_corners);
    if (distance > result.squared_distance) result = {distance, at, point, true};
  });
  for (std::size_t i = 0; i < 3 && !result.leaves_out; ++i)
    result.leaves_out = !is_shared[i] &&
                        has_crossings(plane.vertex(corners[i]), plane.vertex(corners[(i + 1) % 3]));
  return result;
}

std::vector<Vertex> Refinement::crossings_in(const LatticePlane& plane,
                                             const std::array<PlanePoint, 3>& corners) {
  std::vector<Vertex> crossings;
  for_each_crossing(
      plane, corners, {true, true, true},
      [&crossings](const PlanePoint&, const Vertex& vertex) { crossings.push_back(vertex); });
  return crossings;
}

}  // namespace discmc::meshing
