// Small surfaces, made by hand, for tests of the command's meshes, files and pictures.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "meshes/mesh.hpp"
#include "oracle/region.hpp"
#include "surface/surface.hpp"

namespace hand_made {

using discmc::Vertex;
using discmc::meshing::FaceMesh;
using discmc::meshing::Point;
using discmc::meshing::Polygon;
using discmc::meshing::Polygons;
using discmc::meshing::Ring;
using discmc::meshing::Surface;
using Corners = std::vector<Vertex>;  // of a ring that a test may modify

inline std::vector<Corners> rings_of(const Polygon& polygon) {
  std::vector<Corners> rings;
  for (const Ring& ring : polygon.rings) rings.emplace_back(ring.begin(), ring.end());
  return rings;
}

inline bool are_same(const Surface& a, const Surface& b) {
  if (a.polygons.size() != b.polygons.size()) return false;
  for (std::size_t i = 0; i < a.polygons.size(); ++i)
    if (a.polygons[i].incidence != b.polygons[i].incidence ||
        rings_of(a.polygons[i]) != rings_of(b.polygons[i]))
      return false;
  return true;
}

// corners: three per face.
inline FaceMesh triangles_of(std::vector<Point> vertices, std::vector<std::uint32_t> corners) {
  FaceMesh mesh;
  mesh.vertices_mm = std::move(vertices);
  mesh.corners = std::move(corners);
  for (std::size_t end = 3; end <= mesh.corners.size(); end += 3) mesh.face_begin.push_back(end);
  return mesh;
}

// One polygon.
inline Polygons polygon_of(discmc::Incidence incidence, const std::vector<Corners>& rings) {
  Polygons polygons;
  polygons.add_polygon(incidence);
  for (const Corners& ring : rings) polygons.add_ring({ring.data(), ring.data() + ring.size()});
  return polygons;
}

// The polygons with these numbers.
inline Polygons only(const Polygons& polygons, const std::vector<std::size_t>& places) {
  Polygons some;
  for (const std::size_t place : places) some.push_back(polygons[place]);
  return some;
}

// The same polygons, with the rings of each modified by change(index, rings).
template <class Change>
Polygons changed(const Polygons& polygons, Change change) {
  Polygons all;
  for (std::size_t place = 0; place < polygons.size(); ++place) {
    std::vector<Corners> rings = rings_of(polygons[place]);
    change(place, rings);
    all.append(polygon_of(polygons[place].incidence, rings));
  }
  return all;
}

// The ring through these corners in unit steps. Links along an axis are two half-steps long.
inline std::vector<Vertex> every_vertex(const Ring& corners) {
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vertex side = corners[(i + 1) % corners.size()] - corners[i];
    std::int32_t steps = std::gcd(std::gcd(side.x, side.y), side.z);
    if (std::abs(side.x) + std::abs(side.y) + std::abs(side.z) == steps) steps /= 2;
    const Vertex step = {side.x / steps, side.y / steps, side.z / steps};
    Vertex vertex = corners[i];
    for (std::int32_t j = 0; j < steps; ++j, vertex = vertex + step) result.push_back(vertex);
  }
  return result;
}

// Six times the signed volume between the origin and the ring's surface.
inline std::int64_t six_volumes(const Ring& ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 2; i < ring.size(); ++i)
    sum += dot_product(ring[0], cross(ring[i - 1], ring[i]));
  return sum;
}

inline std::int64_t six_volumes(const Surface& surface) {
  std::int64_t sum = 0;
  for (const Polygon& polygon : surface.polygons)
    for (const Ring& ring : polygon.rings) sum += six_volumes(ring);
  return sum;
}

// The polygons of a surface, as regions of the oracle.
inline std::vector<discmc::reference::Region> regions_of(const Surface& surface) {
  std::vector<discmc::reference::Region> regions;
  for (const Polygon& polygon : surface.polygons) {
    regions.push_back({polygon.incidence, {}});
    for (const Ring& ring : polygon.rings) regions.back().rings.push_back(every_vertex(ring));
  }
  return discmc::reference::canonical(std::move(regions));
}

// A polygon of rings of corners, oriented for its normal.
inline Polygons polygon(const Vertex& normal, std::vector<Corners> rings) {
  for (Corners& ring : rings) {
    std::int64_t area = 0;
    for (std::size_t i = 2; i < ring.size(); ++i)
      area += dot_product(normal, cross(ring[i - 1] - ring[0], ring[i] - ring[0]));
    if ((area > 0) != (&ring == &rings[0])) std::reverse(ring.begin(), ring.end());
  }
  return polygon_of(discmc::incidence_of(normal), rings);
}

// The surface of one voxel at the origin.
inline Surface octahedron(const Point& spacing_mm = {2, 2, 2}) {
  Surface surface{spacing_mm, {}};
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1})
        surface.polygons.append(polygon({x, y, z}, {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}));
  return surface;
}

// The four sides of an upright box. `sign` -1 turns them inside out.
inline void add_sides(Surface& surface, const Vertex& low, const Vertex& high, int sign) {
  for (const bool is_high : {false, true}) {
    const int out = is_high ? sign : -sign;
    const int x = is_high ? high.x : low.x;
    const int y = is_high ? high.y : low.y;
    surface.polygons.append(polygon(
        {out, 0, 0},
        {{{x, low.y, low.z}, {x, high.y, low.z}, {x, high.y, high.z}, {x, low.y, high.z}}}));
    surface.polygons.append(polygon(
        {0, out, 0},
        {{{low.x, y, low.z}, {high.x, y, low.z}, {high.x, y, high.z}, {low.x, y, high.z}}}));
  }
}

inline std::vector<Vertex> level_square(const Vertex& low, const Vertex& high, int z) {
  return {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}};
}

// A box of 8 x 8 x 8 half-steps with an upright hole of 4 x 4 through it.
inline Surface box_with_hole(const Point& spacing_mm = {2, 2, 2}) {
  const Vertex low = {1, 0, 0}, high = {9, 8, 8}, hole_low = {3, 2, 0}, hole_high = {7, 6, 8};
  Surface surface{spacing_mm, {}};
  add_sides(surface, low, high, 1);
  add_sides(surface, hole_low, hole_high, -1);
  for (const int z : {0, 8})
    surface.polygons.append(
        polygon({0, 0, z == 0 ? -1 : 1},
                {level_square(low, high, z), level_square(hole_low, hole_high, z)}));
  return surface;
}

struct Pit {
  int column, row;  // 0 to 3
};

// A block of 16 x 16 x 8 half-steps with pyramidal pits in its top. Neighbouring pits have a common
// vertex; outer pits touch the rim. Each pit has 32 six-volumes.
inline Surface pitted_block(const std::vector<Pit>& pits) {
  const Vertex low = {1, 0, 0}, high = {17, 16, 8};
  Surface surface{{2, 2, 2}, {}};
  add_sides(surface, low, high, 1);
  surface.polygons.append(polygon({0, 0, -1}, {level_square(low, high, 0)}));
  std::vector<std::vector<Vertex>> top = {level_square(low, high, 8)};
  for (const Pit& pit : pits) {
    const int x = 3 + 4 * pit.column, y = 2 + 4 * pit.row;
    top.push_back({{x + 2, y, 8}, {x, y + 2, 8}, {x - 2, y, 8}, {x, y - 2, 8}});
    for (const int u : {-1, 1})
      for (const int v : {-1, 1})
        surface.polygons.append(
            polygon({-u, -v, 1}, {{{x + 2 * u, y, 8}, {x, y + 2 * v, 8}, {x, y, 6}}}));
  }
  surface.polygons.append(polygon({0, 0, 1}, top));
  return surface;
}

// A box with half of its front wall leaning back. The straight front side of the bottom belongs to
// two walls, so there is a T-junction at (5, 0, 0).
inline Surface leaning_wall() {
  Surface surface{{2, 2, 2}, {}};
  auto add = [&surface](const Vertex& normal, const std::vector<Vertex>& corners) {
    surface.polygons.append(polygon(normal, {corners}));
  };
  add({0, 0, -1}, {{1, 0, 0}, {9, 0, 0}, {9, 8, 0}, {1, 8, 0}});
  add({0, -1, 0}, {{1, 0, 0}, {5, 0, 0}, {5, 0, 4}, {1, 0, 4}});
  add({0, -1, 1}, {{5, 0, 0}, {9, 0, 0}, {9, 4, 4}, {5, 4, 4}});
  add({1, 0, 0}, {{5, 0, 0}, {5, 4, 4}, {5, 0, 4}});
  add({0, 0, 1}, {{1, 0, 4}, {5, 0, 4}, {5, 4, 4}, {9, 4, 4}, {9, 8, 4}, {1, 8, 4}});
  add({0, 1, 0}, {{1, 8, 0}, {9, 8, 0}, {9, 8, 4}, {1, 8, 4}});
  add({-1, 0, 0}, {{1, 0, 0}, {1, 8, 0}, {1, 8, 4}, {1, 0, 4}});
  add({1, 0, 0}, {{9, 0, 0}, {9, 8, 0}, {9, 8, 4}, {9, 4, 4}});
  return surface;
}

// A flat strip with a saw-tooth side: one open polygon with `count` corners, an odd number.
inline Surface saw(int count) {
  const int last = count - 3;
  std::vector<Vertex> corners;
  for (int i = 0; i <= last; ++i) corners.push_back({1 + i, i % 2, 0});
  corners.push_back({1 + last, 4, 0});
  corners.push_back({1, 4, 0});
  return Surface{{2, 2, 2}, polygon({0, 0, 1}, {corners})};
}

}  // namespace hand_made
