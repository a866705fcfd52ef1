#include "components.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "cavities.hpp"
#include "sets.hpp"

namespace discmc::meshing {
namespace {

// A line of links of either direction: its point next to a coordinate plane, and the step to the
// next vertex.
struct Line {
  std::array<std::int64_t, 3> point;
  std::array<std::int32_t, 3> step;

  bool operator==(const Line& other) const { return point == other.point && step == other.step; }
  bool operator<(const Line& other) const {
    return point != other.point ? point < other.point : step < other.step;
  }
};

// A side of a polygon, by its line and its range on the line.
struct LineSide {
  Line line;
  std::int32_t begin, end;  // Units: links
  std::uint32_t polygon;

  bool operator<(const LineSide& other) const {
    return line == other.line ? begin < other.begin : line < other.line;
  }
};

LineSide line_side(const Vertex& from, Side side, std::uint32_t polygon) {
  const std::array<std::int32_t, 3> at = {from.x, from.y, from.z};
  std::array<std::int32_t, 3> step = {side.link.x, side.link.y, side.link.z};
  const auto along = static_cast<std::size_t>(
      std::find_if(step.begin(), step.end(), [](std::int32_t each) { return each != 0; }) -
      step.begin());
  const bool is_backwards = step[along] < 0;
  if (is_backwards)
    for (std::int32_t& each : step) each = -each;
  const std::int32_t rest = (at[along] % step[along] + step[along]) % step[along];
  const std::int32_t position = (at[along] - rest) / step[along];
  const std::int64_t steps = position;
  LineSide result{{{}, step}, position, position, polygon};
  for (std::size_t axis = 0; axis < 3; ++axis)
    result.line.point[axis] = at[axis] - steps * step[axis];
  (is_backwards ? result.begin : result.end) += is_backwards ? -side.links : side.links;
  return result;
}

std::vector<LineSide> sorted_sides(const Surface& surface) {
  std::vector<LineSide> sides;
  sides.reserve(surface.polygons.corners().size());
  for (std::size_t i = 0; i < surface.polygons.size(); ++i)
    for (const Ring& ring : surface.polygons[i].rings)
      for (std::size_t k = 0; k < ring.size(); ++k)
        sides.push_back(line_side(ring[k], side_between(ring[k], ring[(k + 1) % ring.size()]),
                                  static_cast<std::uint32_t>(i)));
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Joins polygons whose sides share a link.
void join_neighbours(const std::vector<LineSide>& sides, Sets& sets) {
  const LineSide* farthest = nullptr;  // the side on the line that ends farthest so far
  for (const LineSide& side : sides) {
    const bool is_beside = farthest != nullptr && farthest->line == side.line;
    if (is_beside && side.begin < farthest->end) sets.join(side.polygon, farthest->polygon);
    if (!is_beside || side.end > farthest->end) farthest = &side;
  }
}

// Returns six times the volume of the pyramid from a polygon to the origin. Units: half-steps.
double six_volumes(const Polygon& polygon, const Vertex& origin) {
  double sum = 0;
  for (const Ring& ring : polygon.rings) {
    const Vertex apex = ring[0] - origin;
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const Vertex a = ring[i - 1] - origin;
      const Vertex b = ring[i] - origin;
      const double x = double{1} * a.y * b.z - double{1} * a.z * b.y;
      const double y = double{1} * a.z * b.x - double{1} * a.x * b.z;
      const double z = double{1} * a.x * b.y - double{1} * a.y * b.x;
      sum += apex.x * x + apex.y * y + apex.z * z;
    }
  }
  return sum;
}

}  // namespace

std::vector<Component> components(const Surface& surface) {
  Sets sets(surface.polygons.size());
  join_neighbours(sorted_sides(surface), sets);

  std::vector<Component> result;
  std::vector<std::uint32_t> index_of(surface.polygons.size());
  for (std::uint32_t i = 0; i < index_of.size(); ++i) {
    const std::uint32_t root = sets.root(i);
    if (root == i) {
      index_of[i] = static_cast<std::uint32_t>(result.size());
      result.emplace_back();
    }
    result[index_of[root]].polygons.push_back(i);
  }
  const auto& spacing = surface.spacing_mm;
  const double unit_mm3 = std::fabs(spacing[0] * spacing[1] * spacing[2]) / 8;
  for (Component& component : result) {
    // The origin is near, so that rounding errors stay small.
    const Vertex origin = surface.polygons[component.polygons[0]].rings[0][0];
    double sum = 0;
    for (const std::uint32_t polygon : component.polygons)
      sum += six_volumes(surface.polygons[polygon], origin);
    component.volume_mm3 = sum / 6 * unit_mm3;
  }
  return result;
}

namespace {

double size_of(const Component& component) {
  return std::fabs(component.volume_mm3);
}

Surface surface_of(const Surface& surface, const std::vector<Component>& components) {
  std::vector<std::uint32_t> kept_polygons;
  for (const Component& component : components)
    kept_polygons.insert(kept_polygons.end(), component.polygons.begin(), component.polygons.end());
  std::sort(kept_polygons.begin(), kept_polygons.end());
  Surface kept;
  kept.spacing_mm = surface.spacing_mm;
  for (const std::uint32_t polygon : kept_polygons)
    kept.polygons.push_back(surface.polygons[polygon]);
  return kept;
}

// The bodies, each with its cavities, the largest first.
std::vector<std::vector<Component>> grouped(const Surface& surface,
                                            std::vector<Component> components) {
  const std::vector<std::size_t> body_of = bodies_of(surface, components);
  std::vector<std::size_t> bodies;
  for (std::size_t i = 0; i < body_of.size(); ++i)
    if (body_of[i] == i) bodies.push_back(i);
  std::stable_sort(bodies.begin(), bodies.end(), [&](std::size_t a, std::size_t b) {
    return size_of(components[a]) > size_of(components[b]);
  });
  std::vector<std::size_t> index_of(components.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) index_of[bodies[i]] = i;
  std::vector<std::vector<Component>> groups(bodies.size());
  for (const std::size_t body : bodies)
    groups[index_of[body]].push_back(std::move(components[body]));
  for (std::size_t i = 0; i < body_of.size(); ++i)
    if (body_of[i] != i) groups[index_of[body_of[i]]].push_back(std::move(components[i]));
  return groups;
}

}  // namespace

ComponentCounts keep_components(Surface& surface, const ComponentChoice& choice) {
  std::vector<Component> kept = components(surface);
  const std::uint64_t found_count = kept.size();
  if (choice.fills) fill_cavities(surface, kept);
  kept.erase(std::remove_if(kept.begin(), kept.end(),
                            [&](const Component& component) {
                              return size_of(component) < choice.min_volume_mm3;
                            }),
             kept.end());
  if (choice.largest > 0) {
    std::vector<std::vector<Component>> groups = grouped(surface, std::exchange(kept, {}));
    groups.resize(std::min<std::uint64_t>(groups.size(), choice.largest));
    for (std::vector<Component>& group : groups)
      std::move(group.begin(), group.end(), std::back_inserter(kept));
  }
  surface.polygons = surface_of(surface, kept).polygons;
  return {found_count, kept.size()};
}

std::vector<Surface> bodies(const Surface& surface) {
  std::vector<Surface> bodies;
  for (const std::vector<Component>& group : grouped(surface, components(surface)))
    bodies.push_back(surface_of(surface, group));
  return bodies;
}

}  // namespace discmc::meshing
