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
      in_fragment_ = false;
      break;
    case Event::Kind::ring:
      rings_.push_back({event.start, {}});
      break;
    case Event::Kind::run:
      if (in_fragment_)
        fragment_.push_back(event.run);
      else if (!rings_.empty())
        rings_.back().runs.push_back(event.run);
      break;
    case Event::Kind::region_end:
      end_region();
      break;
    case Event::Kind::fragment:
      fragment_number_ = event.number;
      fragment_.clear();
      in_fragment_ = true;
      break;
    case Event::Kind::fragment_end:
      fragments_[fragment_number_] = std::move(fragment_);
      in_fragment_ = false;
      break;
    case Event::Kind::lost:
      in_fragment_ = false;
      break;
    case Event::Kind::skipped:
    case Event::Kind::layer:
    case Event::Kind::finish:
      break;
  }
  return Answer::taken;
}

// Puts runs behind a chain, fragments and the fragments in them in their places. Every fragment is
// used once. False when one is missing.
bool SurfaceBuilder::append(const std::vector<Run>& runs, std::vector<Run>& whole) {
  std::vector<Run> waiting(runs.rbegin(), runs.rend());
  while (!waiting.empty()) {
    const Run run = waiting.back();
    waiting.pop_back();
    if (!run.is_fragment()) {
      whole.push_back(run);
      continue;
    }
    const auto fragment = fragments_.find(run.fragment_number());
    if (fragment == fragments_.end()) return false;
    waiting.insert(waiting.end(), fragment->second.rbegin(), fragment->second.rend());
    fragments_.erase(fragment);
  }
  return true;
}

// Whether a chain closes, and within the coordinates that a scan can have: rings are unfolded in
// 32 bits.
bool SurfaceBuilder::is_sound(const OpenRing& ring, const std::vector<Run>& runs) {
  constexpr std::int64_t least = -1, most = (std::int64_t{1} << 31) - 3;
  std::int64_t x = ring.start.x, y = ring.start.y, z = ring.start.z;
  const auto is_inside = [&] {
    return std::min({x, y, z}) >= least && std::max({x, y, z}) <= most;
  };
  std::uint64_t links = 0;
  bool is_always_inside = is_inside();
  for (const Run& run : runs) {
    const Vertex step = direction_vector(incidence_, run.direction());
    const std::int64_t length = run.length();
    x += step.x * length;
    y += step.y * length;
    z += step.z * length;
    links += run.length();
    is_always_inside = is_always_inside && is_inside();
  }
  const bool is_closed = x == ring.start.x && y == ring.start.y && z == ring.start.z;
  if (!is_always_inside || !is_closed) return false;
  links_ += links;
  if (links_ > max_links)
    throw std::runtime_error("more than " + std::to_string(max_links) +
                             " links, more than is kept in memory: take the stream in parts");
  return true;
}

void SurfaceBuilder::add_simple_rings(const OpenRing& ring, const std::vector<Run>& runs,
                                      Polygon& polygon) {
  const auto run_count = static_cast<std::uint32_t>(runs.size());
  std::vector<Vertex> vertices(link_count(runs.data(), run_count));
  std::vector<std::uint32_t> scratch(2 * vertices.size());
  unfold(polygon.incidence, ring.start, runs.data(), run_count, vertices.data());
  const auto add = [](void* rings, const Vertex* begin, std::uint32_t count) {
    static_cast<std::vector<Ring>*>(rings)->emplace_back(begin, begin + count);
  };
  split_ring(vertices.data(), static_cast<std::uint32_t>(vertices.size()), scratch.data(),
             {&polygon.rings, add});
}

void SurfaceBuilder::end_region() {
  Polygon polygon{incidence_, {}};
  bool is_whole = true;
  std::vector<Run> runs;
  for (const OpenRing& ring : rings_) {
    runs.clear();
    is_whole = append(ring.runs, runs) && is_whole && is_sound(ring, runs);
    if (is_whole) add_simple_rings(ring, runs, polygon);
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
