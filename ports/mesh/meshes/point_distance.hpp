// How far a point is from a line segment and from a triangle.
#ifndef DISCMC_MESH_MESHES_POINT_DISTANCE_HPP
#define DISCMC_MESH_MESHES_POINT_DISTANCE_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "surface/point.hpp"

namespace discmc::meshing {

inline double squared_distance(const Point& point, const std::array<Point, 2>& segment) {
  const Point along = difference(segment[1], segment[0]);
  const Point away = difference(point, segment[0]);
  const double squared_length = dot(along, along);
  const double part =
      squared_length > 0 ? std::clamp(dot(away, along) / squared_length, 0.0, 1.0) : 0;
  const Point rest = {away[0] - part * along[0], away[1] - part * along[1],
                      away[2] - part * along[2]};
  return dot(rest, rest);
}

inline double squared_distance(const Point& point, const std::array<Point, 3>& triangle) {
  const Point normal =
      cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
  const double squared_area = dot(normal, normal);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<Point, 2> side = {triangle[i], triangle[(i + 1) % 3]};
    const Point inwards = cross(normal, difference(side[1], side[0]));
    if (squared_area > 0 && dot(inwards, difference(point, side[0])) >= 0) continue;
    nearest = std::min(nearest, squared_distance(point, side));
  }
  if (nearest < std::numeric_limits<double>::infinity()) return nearest;
  const double height = dot(normal, difference(point, triangle[0]));
  return height * height / squared_area;
}

}  // namespace discmc::meshing

#endif
