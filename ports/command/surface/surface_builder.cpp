#include "surface_builder.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include <discmc/polygon.hpp>

namespace discmc::host {

Answer SurfaceBuilder::take(const Event& event) {
  switch (event.kind) {
    case Event::Kind::region:
      incidence_ = event.incidence;
      rings_.clear();
      break;
    case Event::Kind::ring:
      rings_.push_back({event.start, {}});
      break;
    case Event::Kind::run:
      if (!rings_.empty()) rings_.back().sides.push_back({event.run, event.normal});
      break;
    case Event::Kind::region_end:
      end_region();
      break;
    case Event::Kind::fragment:
      rings_.clear();
      break;
    case Event::Kind::fragment_end:
      ++incomplete_regions_;
      break;
    case Event::Kind::start:
    case Event::Kind::lost:
    case Event::Kind::skipped:
    case Event::Kind::application:
    case Event::Kind::layer:
    case Event::Kind::finish:
      break;
  }
  return Answer::taken;
}

// Whether a chain closes, and within the coordinates that a scan can have: rings are unfolded in
// 32 bits.
bool SurfaceBuilder::is_sound(const Vertex& start, const std::vector<Side>& sides) {
  constexpr std::int64_t least = -1, most = (std::int64_t{1} << 31) - 3;
  std::int64_t x = start.x, y = start.y, z = start.z;
  const auto is_inside = [&] {
    return std::min({x, y, z}) >= least && std::max({x, y, z}) <= most;
  };
  std::uint64_t links = 0;
  bool is_always_inside = is_inside();
  for (const Side& side : sides) {
    const Vertex step = direction_vector(incidence_, side.run.direction());
    const std::int64_t length = side.run.length();
    x += step.x * length;
    y += step.y * length;
    z += step.z * length;
    links += side.run.length();
    is_always_inside = is_always_inside && is_inside();
  }
  const bool is_closed = x == start.x && y == start.y && z == start.z;
  if (!is_always_inside || !is_closed) return false;
  links_ += links;
  if (links_ > max_links)
    throw std::runtime_error("more than " + std::to_string(max_links) +
                             " links, more than is kept in memory: take the stream in parts");
  return true;
}

void SurfaceBuilder::add_normals(const Vertex& start, const std::vector<Side>& sides) {
  Vertex vertex = start;
  for (const Side& side : sides) {
    if (!side.normal.is_none()) surface_.normals.emplace(vertex, side.normal);
    vertex = vertex + displacement(incidence_, &side.run, 1);
  }
}

void SurfaceBuilder::add_simple_rings(const Vertex& start, const std::vector<Side>& sides,
                                      Polygon& polygon) {
  std::vector<Run> runs;
  runs.reserve(sides.size());
  for (const Side& side : sides) runs.push_back(side.run);
  const auto run_count = static_cast<std::uint32_t>(runs.size());
  std::vector<Vertex> vertices(link_count(runs.data(), run_count));
  std::vector<std::uint32_t> scratch(2 * vertices.size());
  unfold(polygon.incidence, start, runs.data(), run_count, vertices.data());
  const auto add = [](void* rings, const Vertex* begin, std::uint32_t count) {
    static_cast<std::vector<Ring>*>(rings)->emplace_back(begin, begin + count);
  };
  split_ring(vertices.data(), static_cast<std::uint32_t>(vertices.size()), scratch.data(),
             {&polygon.rings, add});
}

void SurfaceBuilder::end_region() {
  Polygon polygon{incidence_, {}};
  bool is_whole = true;
  for (const OpenRing& ring : rings_) {
    is_whole = is_whole && is_sound(ring.start, ring.sides);
    if (!is_whole) continue;
    add_simple_rings(ring.start, ring.sides, polygon);
    add_normals(ring.start, ring.sides);
  }
  const auto is_outer = [&](const Ring& ring) {
    return twice_area(incidence_, ring.data(), static_cast<std::uint32_t>(ring.size())) > 0;
  };
  const auto outer = std::find_if(polygon.rings.begin(), polygon.rings.end(), is_outer);
  if (!is_whole || outer == polygon.rings.end()) {
    ++incomplete_regions_;
    return;
  }
  std::iter_swap(polygon.rings.begin(), outer);
  surface_.polygons.push_back(std::move(polygon));
}

}  // namespace discmc::host
