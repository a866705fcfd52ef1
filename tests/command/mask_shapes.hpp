// Masks of small shapes for measuring the accuracy of smoothing: balls, rods, sheets, necks,
// tunnels, shells.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "surface/point.hpp"

namespace mask_shapes {

using discmc::meshing::dot;
using discmc::meshing::Point;

struct Shape {
  std::string name;
  std::array<std::uint32_t, 3> dims;
  Point spacing_mm;
  std::vector<int> samples;  ///< 1 inside, 0 outside
  /// Returns the vector along the exact shape's normal at a point near its surface. Empty if
  /// unknown; zero where the shape has no normal.
  std::function<Point(const Point&)> normal{};

  double volume_mm3() const {
    return static_cast<double>(std::count(samples.begin(), samples.end(), 1)) * spacing_mm[0] *
           spacing_mm[1] * spacing_mm[2];
  }
};

/// The argument is the position relative to the middle of the volume. Units: millimetres.
using Inside = std::function<bool(const Point&)>;

inline Shape shape_of(const std::string& name, const std::array<std::uint32_t, 3>& dims,
                      const Point& spacing_mm, const Inside& is_inside,
                      const std::function<Point(const Point&)>& normal = {}) {
  Shape shape{name, dims, spacing_mm, {}};
  Point middle;
  for (std::size_t axis = 0; axis < 3; ++axis)
    middle[axis] = (dims[axis] - 1) / 2.0 * spacing_mm[axis];
  for (std::uint32_t z = 0; z < dims[2]; ++z)
    for (std::uint32_t y = 0; y < dims[1]; ++y)
      for (std::uint32_t x = 0; x < dims[0]; ++x)
        shape.samples.push_back(
            is_inside({x * spacing_mm[0] - middle[0], y * spacing_mm[1] - middle[1],
                       z * spacing_mm[2] - middle[2]})
                ? 1
                : 0);
  if (normal)
    shape.normal = [normal, middle](const Point& at) {
      return normal(discmc::meshing::difference(at, middle));
    };
  return shape;
}

inline Shape box(const std::string& name, const std::array<std::uint32_t, 3>& size,
                 unsigned tunnel = 0) {
  constexpr std::uint32_t around = 7;
  const std::array<std::uint32_t, 3> dims = {size[0] + 2 * around, size[1] + 2 * around,
                                             size[2] + 2 * around};
  Shape shape{name, dims, {1, 1, 1}, std::vector<int>(std::size_t{dims[0]} * dims[1] * dims[2])};
  const auto is_in = [&](std::uint32_t at, std::size_t axis) {
    return at >= around && at < around + size[axis];
  };
  const auto is_in_tunnel = [&](std::uint32_t at, std::size_t axis) {
    return at >= dims[axis] / 2 && at < dims[axis] / 2 + tunnel;
  };
  std::size_t place = 0;
  for (std::uint32_t z = 0; z < dims[2]; ++z)
    for (std::uint32_t y = 0; y < dims[1]; ++y)
      for (std::uint32_t x = 0; x < dims[0]; ++x)
        shape.samples[place++] =
            is_in(x, 0) && is_in(y, 1) && is_in(z, 2) && !(is_in_tunnel(x, 0) && is_in_tunnel(y, 1))
                ? 1
                : 0;
  return shape;
}

inline Shape ball(const std::string& name, double radius, const Point& spacing_mm,
                  const Point& away) {
  std::array<std::uint32_t, 3> dims;
  for (std::size_t axis = 0; axis < 3; ++axis)
    dims[axis] = static_cast<std::uint32_t>(2 * radius / spacing_mm[axis]) + 16;
  const auto from_centre = [away](const Point& at) {
    return Point{at[0] + away[0], at[1] + away[1], at[2] + away[2]};
  };
  return shape_of(
      name, dims, spacing_mm,
      [=](const Point& at) {
        const Point from = from_centre(at);
        return dot(from, from) <= radius * radius;
      },
      from_centre);
}

inline Shape rod(const std::string& name, double radius, double half_length, Point along,
                 const std::array<std::uint32_t, 3>& dims, const Point& spacing_mm) {
  along = discmc::meshing::unit_or_zero(along);
  const auto across = [along](const Point& at) {
    const double way = dot(at, along);
    return Point{at[0] - way * along[0], at[1] - way * along[1], at[2] - way * along[2]};
  };
  return shape_of(
      name, dims, spacing_mm,
      [=](const Point& at) {
        const Point away = across(at);
        return dot(away, away) <= radius * radius && std::fabs(dot(at, along)) < half_length;
      },
      [=](const Point& at) {
        return std::fabs(dot(at, along)) < half_length * 0.75 ? across(at) : Point{};
      });
}

inline Shape dumbbell(unsigned neck) {
  const double off = neck % 2 == 1 ? 0.5 : 0;
  return shape_of("dumbbell with a neck of " + std::to_string(neck), {28, 28, 44}, {1, 1, 1},
                  [=](const Point& at) {
                    const double x = at[0] + off, y = at[1] + off, z = std::fabs(at[2]);
                    const double half = neck / 2.0 - 0.01;
                    return std::hypot(x, y, z - 10) <= 5 ||
                           (std::fabs(x) <= half && std::fabs(y) <= half && z <= 10);
                  });
}

inline Shape shell(double thickness) {
  return shape_of("shell of " + std::to_string(thickness), {34, 34, 34}, {1, 1, 1},
                  [=](const Point& at) {
                    const double away = std::hypot(at[0] + 0.1, at[1] - 0.2, at[2]);
                    return away <= 9 && away > 9 - thickness;
                  });
}

inline Shape slope() {
  const Point up = discmc::meshing::unit_or_zero({0.15, 0.1, 1});
  return shape_of(
      "slope", {40, 40, 40}, {1, 1, 1},
      [=](const Point& at) {
        return std::fabs(dot(at, up)) <= 6 && std::fabs(at[0]) < 12 && std::fabs(at[1]) < 12;
      },
      [=](const Point& at) {
        if (std::fabs(at[0]) >= 9 || std::fabs(at[1]) >= 9) return Point{};
        return dot(at, up) > 0 ? up : discmc::meshing::difference({}, up);
      });
}

/// All 24 shapes.
inline std::vector<Shape> all() {
  std::vector<Shape> shapes = {box("1 voxel", {1, 1, 1}), box("2 x 2 x 2", {2, 2, 2})};
  const Point away = {0.13, -0.21, 0.07}, cubes = {1, 1, 1}, long_voxels = {0.8, 0.8, 3};
  for (const unsigned radius : {2U, 3U, 5U, 10U})
    shapes.push_back(ball("ball " + std::to_string(radius), radius, cubes, away));
  for (const unsigned width : {1U, 2U, 3U})
    shapes.push_back(box("rod " + std::to_string(width), {width, width, 14}));
  for (const unsigned width : {1U, 2U, 3U})
    shapes.push_back(box("sheet " + std::to_string(width), {18, 18, width}));
  for (const unsigned neck : {1U, 2U}) shapes.push_back(dumbbell(neck));
  for (const double thickness : {1.2, 2.0}) shapes.push_back(shell(thickness));
  for (const unsigned width : {1U, 2U})
    shapes.push_back(box("tunnel " + std::to_string(width), {12, 12, 12}, width));
  shapes.push_back(rod("oblique rod 1.2", 1.2, 12, {0.3, 0.5, 1}, {40, 40, 40}, cubes));
  shapes.push_back(rod("oblique rod 3", 3, 12, {0.3, 0.5, 1}, {40, 40, 40}, cubes));
  shapes.push_back(slope());
  for (const unsigned radius : {5U, 15U})
    shapes.push_back(ball("ball of long voxels " + std::to_string(radius), radius, long_voxels,
                          {0.1, -0.2, 0.4}));
  shapes.push_back(rod("rod of long voxels", 2.5, 24, {0.6, 0.2, 1}, {60, 60, 26}, long_voxels));
  return shapes;
}

}  // namespace mask_shapes
