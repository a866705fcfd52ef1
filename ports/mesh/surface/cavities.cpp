#include "cavities.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace discmc::meshing {
namespace {

// A ray leaves a point of a component along x. A body lies in a cavity if the ray leaves cavities
// more often than it enters them. The same holds for a cavity in a body.
//
// All coordinates are doubled, and a ray lies slightly beyond its integers: more along x than along
// y, and more along y than z. So the ray meets no vertex and no side.
using Doubled = std::int64_t;

// The line of a ray: z first.
using RayLine = std::array<Doubled, 2>;

struct Start {
  RayLine line;
  Doubled x;
  std::size_t component;

  bool operator<(const Start& other) const {
    return std::tie(line, other.x) < std::tie(other.line, x);
  }
};

// The point at which a line meets a polygon. Its sign is 1 if a ray along x enters the inside of
// the surface, else -1.
struct Meeting {
  std::size_t line;
  Doubled x;
  int entry_sign;
  std::size_t component;

  bool operator<(const Meeting& other) const {
    return std::tie(line, other.x) < std::tie(other.line, x);
  }
};

// Returns the point near the middle of a link on a side. No two components share a link.
Start start_of(const Surface& surface, const Component& component, std::size_t number) {
  const Ring ring = surface.polygons[component.polygons[0]].rings[0];
  const Vertex& from = ring[0];
  const Vertex link = side_between(from, ring[1]).link;
  return {{Doubled{2} * from.z + link.z, Doubled{2} * from.y + link.y},
          Doubled{2} * from.x + link.x,
          number};
}

class Rays {
 public:
  explicit Rays(std::vector<Start> starts) : starts_(std::move(starts)) {
    std::sort(starts_.begin(), starts_.end());
    for (const Start& start : starts_)
      if (lines_.empty() || lines_.back() != start.line) lines_.push_back(start.line);
  }

  // Finds the points at which lines meet a polygon. Cost: per side, the different z of lines that
  // it passes; and the points.
  void meet(const Polygon& polygon, std::size_t component) {
    const Vertex n = incidence_normal(polygon.incidence);
    if (n.x == 0) return;
    crossings_.clear();
    for (const Ring& ring : polygon.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        add_crossings(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    std::sort(crossings_.begin(), crossings_.end());
    // Lines between the first crossing and the second lie inside, and so on.
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      const std::size_t end = line_from(crossings_[i + 1]);
      for (std::size_t line = line_from(crossings_[i]); line < end; ++line)
        meetings_.push_back(
            {line, x_of(polygon.rings[0][0], n, lines_[line]), n.x < 0 ? 1 : -1, component});
    }
  }

  // Calls call(component of the ray, meeting) for each meeting of a ray.
  template <class Call>
  void for_each_meeting(const Call& call) {
    std::sort(meetings_.begin(), meetings_.end());
    auto first = meetings_.cbegin();  // of the line
    std::size_t line = 0;
    for (const Start& start : starts_) {
      while (lines_[line] != start.line) ++line;
      while (first != meetings_.cend() && first->line < line) ++first;
      for (auto meeting = first;
           meeting != meetings_.cend() && meeting->line == line && meeting->x > start.x; ++meeting)
        call(start.component, *meeting);
    }
  }

 private:
  std::size_t line_from(const RayLine& line) const {
    const auto found = std::lower_bound(lines_.begin(), lines_.end(), line);
    return static_cast<std::size_t>(found - lines_.begin());
  }

  // Adds where a side crosses each z of the lines. Along y a side changes as much as along z, or
  // not at all.
  void add_crossings(const Vertex& a, const Vertex& b) {
    const Vertex& low = a.z < b.z ? a : b;
    const Vertex& high = a.z < b.z ? b : a;
    const Doubled slope = high.y > low.y ? 1 : high.y < low.y ? -1 : 0;
    const Doubled begin = Doubled{2} * low.z, end = Doubled{2} * high.z;
    for (std::size_t line = line_from({begin, lowest}); line < lines_.size();
         line = line_from({lines_[line][0] + 1, lowest})) {
      const Doubled z = lines_[line][0];
      if (z >= end) return;
      crossings_.push_back({z, Doubled{2} * low.y + slope * (z - begin)});
    }
  }

  static Doubled x_of(const Vertex& vertex, const Vertex& n, const RayLine& line) {
    const Doubled y = line[1] - Doubled{2} * vertex.y, z = line[0] - Doubled{2} * vertex.z;
    return Doubled{2} * vertex.x - n.x * (n.y * y + n.z * z);
  }

  static constexpr Doubled lowest = INT64_MIN;

  std::vector<Start> starts_;
  std::vector<RayLine> lines_;  // of the starts, in order
  std::vector<RayLine> crossings_;
  std::vector<Meeting> meetings_;
};

bool is_cavity(const Component& component) {
  return component.volume_mm3 < 0;
}

// Returns the rays from all cavities, or from all bodies, to the polygons of the others.
Rays rays_between(const Surface& surface, const std::vector<Component>& components,
                  bool is_from_cavities) {
  std::vector<Start> starts;
  for (std::size_t i = 0; i < components.size(); ++i)
    if (is_cavity(components[i]) == is_from_cavities)
      starts.push_back(start_of(surface, components[i], i));
  Rays rays(std::move(starts));
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (is_cavity(components[i]) == is_from_cavities) continue;
    for (const std::uint32_t polygon : components[i].polygons)
      rays.meet(surface.polygons[polygon], i);
  }
  return rays;
}

}  // namespace

void fill_cavities(const Surface& surface, std::vector<Component>& components) {
  std::vector<int> depth(components.size());  // cavities around each body
  rays_between(surface, components, false)
      .for_each_meeting(
          [&](std::size_t body, const Meeting& meeting) { depth[body] += meeting.entry_sign; });
  std::size_t number = 0;
  components.erase(std::remove_if(components.begin(), components.end(),
                                  [&](const Component& component) {
                                    return depth[number++] > 0 || is_cavity(component);
                                  }),
                   components.end());
}

std::vector<std::size_t> bodies_of(const Surface& surface,
                                   const std::vector<Component>& components) {
  std::map<std::pair<std::size_t, std::size_t>, int> depth;  // of a cavity in a body
  rays_between(surface, components, true)
      .for_each_meeting([&](std::size_t cavity, const Meeting& meeting) {
        depth[{cavity, meeting.component}] -= meeting.entry_sign;
      });
  std::vector<std::size_t> bodies(components.size());
  std::iota(bodies.begin(), bodies.end(), std::size_t{0});
  for (const auto& [pair, count] : depth) {
    if (count <= 0) continue;
    std::size_t& body = bodies[pair.first];
    if (body == pair.first || components[pair.second].volume_mm3 < components[body].volume_mm3)
      body = pair.second;
  }
  return bodies;
}

}  // namespace discmc::meshing
