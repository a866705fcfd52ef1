#include "cavities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "meshes/point.hpp"

namespace discmc::command {
namespace {

using Extent = std::array<Vertex, 2>;  // the least and the greatest coordinates

Extent extent_of(const Surface& surface, const Component& component) {
  const Vertex first = surface.polygons[component.polygons[0]].rings[0][0];
  Extent extent = {first, first};
  auto& [least, greatest] = extent;
  for (const std::uint32_t polygon : component.polygons)
    for (const Vertex& at : surface.polygons[polygon].rings[0]) {
      least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
      greatest = {std::max(greatest.x, at.x), std::max(greatest.y, at.y),
                  std::max(greatest.z, at.z)};
    }
  return extent;
}

bool is_within(const Extent& inner, const Extent& outer) {
  return inner[0].x >= outer[0].x && inner[0].y >= outer[0].y && inner[0].z >= outer[0].z &&
         inner[1].x <= outer[1].x && inner[1].y <= outer[1].y && inner[1].z <= outer[1].z;
}

// On a side of a polygon, or so near that no other surface is between: sides are of one surface
// alone. Away from all planes of the lattice.
Point point_of(const Surface& surface, const Component& component) {
  const Ring ring = surface.polygons[component.polygons[0]].rings[0];
  const Vertex& from = ring[0];
  const Vertex link = side_between(from, ring[1]).link;
  return {from.x + 0.5 * link.x + 0.00131, from.y + 0.5 * link.y + 0.00173,
          from.z + 0.5 * link.z + 0.00219};
}

// Half the solid angle of a triangle (A. van Oosterom, J. Strackee, 1983). a, b, c: its corners,
// seen from the point.
double half_solid_angle(const Point& a, const Point& b, const Point& c) {
  const double p = std::sqrt(dot(a, a)), q = std::sqrt(dot(b, b)), r = std::sqrt(dot(c, c));
  return std::atan2(dot(a, cross(b, c)), p * q * r + dot(a, b) * r + dot(b, c) * p + dot(c, a) * q);
}

bool is_inside(const Point& point, const Surface& surface, const Component& component) {
  const auto seen = [&point](const Vertex& at) {
    return Point{at.x - point[0], at.y - point[1], at.z - point[2]};
  };
  double sum = 0;
  for (const std::uint32_t polygon : component.polygons)
    for (const Ring& ring : surface.polygons[polygon].rings)
      for (std::size_t i = 2; i < ring.size(); ++i)
        sum += half_solid_angle(seen(ring[0]), seen(ring[i - 1]), seen(ring[i]));
  return std::abs(sum) > std::acos(-1.0);  // 2 pi inside, 0 outside
}

}  // namespace

void fill_cavities(const Surface& surface, std::vector<Component>& components) {
  std::vector<const Component*> cavities;
  std::vector<Extent> extents;
  for (const Component& component : components) {
    if (component.volume_mm3 >= 0) continue;
    cavities.push_back(&component);
    extents.push_back(extent_of(surface, component));
  }
  const auto is_filled = [&](const Component& component) {
    if (component.volume_mm3 < 0) return true;
    const Extent extent = extent_of(surface, component);
    for (std::size_t i = 0; i < cavities.size(); ++i)
      if (is_within(extent, extents[i]) &&
          is_inside(point_of(surface, component), surface, *cavities[i]))
        return true;
    return false;
  };
  std::vector<Component> left;
  for (const Component& component : components)
    if (!is_filled(component)) left.push_back(component);
  components = std::move(left);
}

}  // namespace discmc::command
