// Arrays of samples for tests of the mesh library, and meshes as comparable sets of triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "discmc/mesh.hpp"
#include "oracle/volume.hpp"

namespace mesh_tests {

/// An array with its extents. x runs fastest.
template <class Sample>
struct Array {
  std::array<std::int64_t, 3> size;
  std::vector<Sample> samples;

  discmc::Extents extents() const { return {size[0], size[1], size[2]}; }
  discmc::Samples view() const { return {samples, extents()}; }
};

/// Calls sample(x, y, z) for every voxel.
template <class Sample, class Field>
Array<Sample> array_of(std::array<std::int64_t, 3> size, Field sample) {
  Array<Sample> array{size, {}};
  for (std::int64_t z = 0; z < size[2]; ++z)
    for (std::int64_t y = 0; y < size[1]; ++y)
      for (std::int64_t x = 0; x < size[0]; ++x)
        array.samples.push_back(static_cast<Sample>(sample(x, y, z)));
  return array;
}

constexpr double ball_level = 50;
constexpr double ball_radius = 7.3;
constexpr std::array<double, 3> ball_centre{9.1, 10.2, 11.3};
constexpr std::array<std::int64_t, 3> ball_size{20, 22, 24};

/// A ball: 50 on a sphere, and 4 less per voxel outwards.
template <class Sample>
Array<Sample> ball() {
  return array_of<Sample>(ball_size, [](std::int64_t x, std::int64_t y, std::int64_t z) {
    const double distance =
        std::hypot(static_cast<double>(x) - ball_centre[0], static_cast<double>(y) - ball_centre[1],
                   static_cast<double>(z) - ball_centre[2]);
    return ball_level + 4 * (ball_radius - distance);
  });
}

inline Array<std::uint8_t> array_of(const discmc::reference::BitVolume& volume) {
  return {{volume.width, volume.height, volume.depth}, volume.on};
}

/// Volumes of the oracle: one body, many bodies, cavities, and vertices where surfaces touch.
inline std::vector<Array<std::uint8_t>> bit_volumes() {
  namespace reference = discmc::reference;
  return {array_of(reference::torus({30, 28, 12}, 18, 7)), array_of(reference::comb({12, 9, 7})),
          array_of(reference::random({9, 10, 11}, 128, 3)),
          array_of(reference::random({12, 7, 9}, 200, 4)),
          array_of(reference::checkerboard({6, 5, 7}))};
}

using Triangle = std::array<std::array<double, 3>, 3>;

inline std::vector<std::array<double, 3>> sorted(std::vector<std::array<double, 3>> points) {
  std::sort(points.begin(), points.end());
  return points;
}

using Ring = std::vector<std::array<double, 3>>;

/// Returns the rings of all polygons in an order that depends only on the surface.
inline std::vector<Ring> rings_of(const discmc::Mesh& mesh) {
  const discmc::MeshPolygons& polygons = mesh.polygons;
  std::vector<Ring> rings;
  for (std::size_t i = 1; i < polygons.corner_begin.size(); ++i) {
    Ring ring;
    for (std::size_t at = polygons.corner_begin[i - 1]; at < polygons.corner_begin[i]; ++at)
      ring.push_back(mesh.vertices[polygons.corners[at]]);
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    rings.push_back(ring);
  }
  std::sort(rings.begin(), rings.end());
  return rings;
}

/// Returns the triangles in an order that depends only on the surface.
inline std::vector<Triangle> triangles_of(const discmc::Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& corners : mesh.triangles) {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = mesh.vertices[corners[i]];
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

inline std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline std::array<double, 3> difference(const std::array<double, 3>& a,
                                        const std::array<double, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Returns the enclosed volume, positive if the triangles face outwards.
inline double signed_volume(const discmc::Mesh& mesh) {
  double volume = 0;
  for (const auto& triangle : mesh.triangles)
    volume += dot(mesh.vertices[triangle[0]],
                  cross(mesh.vertices[triangle[1]], mesh.vertices[triangle[2]])) /
              6;
  return volume;
}

}  // namespace mesh_tests
