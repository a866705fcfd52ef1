// Compares a sweep with the reference. The results are text, so that a failed check prints why.
#pragma once

#include <string>
#include <vector>

#include "collector.hpp"
#include "merge.hpp"
#include "surface.hpp"

namespace discmc::reference {

inline size_t link_count(const std::vector<Region>& regions) {
  size_t links = 0;
  for (const Region& region : regions)
    for (const Ring& ring : region.rings) links += ring.size();
  return links;
}

/// Returns an empty text if the regions of a complete sweep equal `merged`, which is canonical,
/// ring for ring.
inline std::string unlike_regions(const std::vector<Region>& swept,
                                  const std::vector<Region>& merged) {
  const std::vector<Region> simple = canonical(simple_rings(swept));
  if (simple != merged) return describe_difference(simple, merged);
  return link_count(swept) == link_count(merged) ? "" : "a slit";
}

/// Likewise compares with the regions that the paper's Merge finds in a volume.
inline std::string unlike_merge(const std::vector<Region>& swept, const BitVolume& volume,
                                bool is_closed) {
  return unlike_regions(swept, canonical(merge(volume, is_closed)));
}

/// Returns an empty text if the totals of cells, facets and triangles equal those of the volume's
/// cells.
inline std::string miscounted(const Collector& collector, const BitVolume& volume, bool is_closed) {
  uint64_t cells = 0, facets = 0, triangles = 0;
  for_each_cell(volume, is_closed, [&](const Vertex&, Configuration configuration) {
    cells += cell_facts.facets[configuration] > 0;
    facets += cell_facts.facets[configuration];
    triangles += cell_facts.classic_triangles[configuration];
  });
  const Statistics& statistics = collector.statistics();
  if (statistics.cells != cells) return "other cells counted";
  if (statistics.facets != facets) return "other facets counted";
  return statistics.classic_triangles == triangles ? "" : "other triangles counted";
}

/// Returns an empty text if the regions of a sweep, however cut, form the surface of the volume.
/// Every plane must have an equal area and boundary, and only open borders leave unpaired links.
inline std::string unlike_surface(const std::vector<Region>& swept, const BitVolume& volume,
                                  bool is_closed) {
  const Surface surface = surface_of(swept);
  const Surface expected = surface_of_cells(volume, is_closed);
  if (surface.areas != expected.areas) return "other areas on the planes";
  if (surface.open_links != expected.open_links) return "other links left over";
  if (surface.boundary != expected.boundary) return "other boundaries on the planes";
  if (surface.six_volumes != expected.six_volumes) return "another volume";
  if (is_closed && surface.open_links != 0) return "a surface that is not closed";
  for (const Region& region : simple_rings(swept))
    if (region.rings.empty() || signed_area(region.incidence, region.rings[0]) <= 0)
      return "a region without an outer ring";
  return {};
}

}  // namespace discmc::reference
