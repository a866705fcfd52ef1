// Joins loose fragments by a map of their followers, as a reference for other methods.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "agreement.hpp"
#include "collector.hpp"

namespace discmc::reference {

/// Returns the rings that loose fragments form, each as a region; a hole has a negative area.
/// Errors: throws GrammarError if a fragment has no follower, or two fragments share one.
inline std::vector<Region> join_all(const std::vector<Fragment>& loose) {
  using End = std::tuple<int32_t, int32_t, int32_t, Incidence, Direction>;
  const auto end_at = [](const Vertex& vertex, Incidence incidence, Direction came) {
    return End{vertex.x, vertex.y, vertex.z, incidence, came};
  };
  std::map<End, const Fragment*> by_start;
  for (const Fragment& fragment : loose)
    if (!by_start.emplace(end_at(fragment.start, fragment.incidence, fragment.came), &fragment)
             .second)
      throw GrammarError("two loose fragments begin with one link");
  std::vector<Region> rings;
  while (!by_start.empty()) {
    Region ring{by_start.begin()->second->incidence, {{}}};
    auto next = by_start.begin();
    const Fragment* const first = next->second;
    for (;;) {
      const Fragment& fragment = *next->second;
      by_start.erase(next);
      const Ring part = vertices_of(fragment.incidence, fragment.start, fragment.runs);
      ring.rings[0].insert(ring.rings[0].end(), part.begin(), part.end());
      const Direction last = fragment.runs.back().direction();
      const End end = end_at(part.back() + direction_vector(fragment.incidence, last),
                             fragment.incidence, last);
      if (end == end_at(first->start, first->incidence, first->came)) break;
      next = by_start.find(end);
      if (next == by_start.end()) throw GrammarError("a loose fragment that nothing follows");
    }
    rings.push_back(ring);
  }
  return rings;
}

/// Returns the simple rings of regions, each as a canonical region.
inline std::vector<Region> single_rings(const std::vector<Region>& regions) {
  std::vector<Region> rings;
  for (const Region& region : simple_rings(regions))
    for (const Ring& ring : region.rings) rings.push_back({region.incidence, {ring}});
  return canonical(std::move(rings));
}

/// Returns the canonical rings of all collected parts, of one scan or of one slab each. Errors: as
/// join().
inline std::vector<Region> joined_rings(const std::vector<Collector>& scans) {
  std::vector<Region> rings;
  std::vector<Fragment> loose;
  for (const Collector& scan : scans) {
    rings.insert(rings.end(), scan.regions().begin(), scan.regions().end());
    loose.insert(loose.end(), scan.loose().begin(), scan.loose().end());
  }
  for (const Region& ring : join_all(loose)) rings.push_back(ring);
  return single_rings(rings);
}

/// Returns an empty text if the collected parts join to the rings of `merged`.
inline std::string unlike_joined(const std::vector<Collector>& scans,
                                 const std::vector<Region>& merged) {
  const std::vector<Region> rings = joined_rings(scans);
  const std::vector<Region> expected = single_rings(merged);
  return rings == expected ? "" : describe_difference(rings, expected);
}

}  // namespace discmc::reference
