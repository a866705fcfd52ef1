#include "components.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace discmc::command {
namespace {

// A link of whichever direction, and a polygon that has it: twice its middle, and on which of the
// diagonals through it it lies.
struct Link {
  std::array<std::int64_t, 3> doubled_middle;
  unsigned diagonal;
  std::uint32_t polygon;

  bool is_same_link(const Link& other) const {
    return doubled_middle == other.doubled_middle && diagonal == other.diagonal;
  }
  bool operator<(const Link& other) const {
    return doubled_middle != other.doubled_middle ? doubled_middle < other.doubled_middle
                                                  : diagonal < other.diagonal;
  }
};

Link link_from(const Vertex& a, const Vertex& step, std::uint32_t polygon) {
  const Vertex b = a + step;
  // The signs of two steps beside the third, which are the same from both ends.
  const unsigned diagonal = (step.x * step.y < 0 ? 1U : 0U) | (step.x * step.z < 0 ? 2U : 0U) |
                            (step.y * step.z < 0 ? 4U : 0U);
  return {{std::int64_t{a.x} + b.x, std::int64_t{a.y} + b.y, std::int64_t{a.z} + b.z},
          diagonal,
          polygon};
}

std::vector<Link> sorted_links(const Surface& surface) {
  std::vector<Link> links;
  for (std::size_t i = 0; i < surface.polygons.size(); ++i)
    for (const Ring& ring : surface.polygons[i].rings)
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Side side = side_between(ring[k], ring[(k + 1) % ring.size()]);
        Vertex at = ring[k];
        for (std::int32_t link = 0; link < side.links; ++link, at = at + side.link)
          links.push_back(link_from(at, side.link, static_cast<std::uint32_t>(i)));
      }
  std::sort(links.begin(), links.end());
  return links;
}

// Sets of polygons; each is named by its lowest.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t name(std::uint32_t polygon) {
    while (parent_[polygon] != polygon) {
      parent_[polygon] = parent_[parent_[polygon]];
      polygon = parent_[polygon];
    }
    return polygon;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = name(a);
    const std::uint32_t second = name(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// Six times what the pyramid between a polygon and the origin encloses. Units: half-steps.
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
  const std::vector<Link> links = sorted_links(surface);
  Sets sets(surface.polygons.size());
  for (std::size_t i = 1; i < links.size(); ++i)
    if (links[i].is_same_link(links[i - 1])) sets.join(links[i].polygon, links[i - 1].polygon);

  std::vector<Component> found;
  std::vector<std::uint32_t> place(surface.polygons.size());
  for (std::uint32_t i = 0; i < place.size(); ++i) {
    const std::uint32_t name = sets.name(i);
    if (name == i) {
      place[i] = static_cast<std::uint32_t>(found.size());
      found.emplace_back();
    }
    found[place[name]].polygons.push_back(i);
  }
  const auto& s = surface.spacing_mm;
  const double unit_mm3 = std::fabs(s[0] * s[1] * s[2]) / 8;
  for (Component& component : found) {
    // Near by, so that nothing is rounded that counts.
    const Vertex origin = surface.polygons[component.polygons[0]].rings[0][0];
    double sum = 0;
    for (const std::uint32_t polygon : component.polygons)
      sum += six_volumes(surface.polygons[polygon], origin);
    component.volume_mm3 = sum / 6 * unit_mm3;
  }
  return found;
}

ComponentCounts keep_components(Surface& surface, const ComponentChoice& choice) {
  std::vector<Component> kept = components(surface);
  const std::uint64_t found = kept.size();
  const auto size = [](const Component& component) { return std::fabs(component.volume_mm3); };
  kept.erase(std::remove_if(kept.begin(), kept.end(),
                            [&](const Component& component) {
                              return size(component) < choice.min_volume_mm3;
                            }),
             kept.end());
  if (choice.largest > 0 && kept.size() > choice.largest) {
    std::stable_sort(kept.begin(), kept.end(),
                     [&](const Component& a, const Component& b) { return size(a) > size(b); });
    kept.resize(choice.largest);
  }
  std::vector<std::uint32_t> stay;
  for (const Component& component : kept)
    stay.insert(stay.end(), component.polygons.begin(), component.polygons.end());
  std::sort(stay.begin(), stay.end());
  Polygons polygons;
  for (const std::uint32_t polygon : stay) polygons.push_back(surface.polygons[polygon]);
  surface.polygons = std::move(polygons);
  return {found, kept.size()};
}

}  // namespace discmc::command
