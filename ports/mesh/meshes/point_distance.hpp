// Distances of a point from a line segment and from a triangle.
#ifndef DISCMC_MESH_MESHES_POINT_DISTANCE_HPP
#define DISCMC_MESH_MESHES_POINT_DISTANCE_HPP

#include <algorithm>
#include <array>
#include <cstddef>

#include "surface/point.hpp"

namespace discmc::meshing {

inline double squared_distance(const Point& point, const std::array<Point, 2>& segment) {
  const Point along = difference(segment[1], segment[0]);
  const Point away = difference(point, segment[0]);
  const double squared_length = dot(along, along);
  const double part =
      squared_length > 0 ? std::clamp(dot(away, along) / squared_length, 0.0, 1.0) : 0;
  const Point to_point = {away[0] - part * along[0], away[1] - part * along[1],
                          away[2] - part * along[2]};
  return dot(to_point, to_point);
}

/// Distinguishes the region above which the point lies: of a corner, of a side, or of the triangle
/// itself (C. Ericson, Real-Time Collision Detection, 2005).
inline double squared_distance(const Point& point, const std::array<Point, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Point ab = difference(b, a), ac = difference(c, a), from_a = difference(point, a);
  const double ab_a = dot(ab, from_a), ac_a = dot(ac, from_a);
  if (ab_a <= 0 && ac_a <= 0) return dot(from_a, from_a);
  const Point from_b = difference(point, b);
  const double ab_b = dot(ab, from_b), ac_b = dot(ac, from_b);
  if (ab_b >= 0 && ac_b <= ab_b) return dot(from_b, from_b);
  const double beyond_ab = ab_a * ac_b - ab_b * ac_a;
  if (beyond_ab <= 0 && ab_a >= 0 && ab_b <= 0)
    return squared_distance(point, std::array<Point, 2>{a, b});
  const Point from_c = difference(point, c);
  const double ab_c = dot(ab, from_c), ac_c = dot(ac, from_c);
  if (ac_c >= 0 && ab_c <= ac_c) return dot(from_c, from_c);
  const double beyond_ac = ab_c * ac_a - ab_a * ac_c;
  if (beyond_ac <= 0 && ac_a >= 0 && ac_c <= 0)
    return squared_distance(point, std::array<Point, 2>{a, c});
  const double beyond_bc = ab_b * ac_c - ab_c * ac_b;
  if (beyond_bc <= 0 && ac_b >= ab_b && ab_c >= ac_c)
    return squared_distance(point, std::array<Point, 2>{b, c});
  const Point normal = cross(ab, ac);
  const double height = dot(normal, from_a), squared_area = dot(normal, normal);
  if (squared_area > 0) return height * height / squared_area;
  return std::min({squared_distance(point, std::array<Point, 2>{a, b}),
                   squared_distance(point, std::array<Point, 2>{a, c}),
                   squared_distance(point, std::array<Point, 2>{b, c})});
}

}  // namespace discmc::meshing

#endif
