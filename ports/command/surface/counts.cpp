#include "counts.hpp"

#include <discmc/polygon.hpp>

namespace discmc::host {

Counts count(const Surface& surface) {
  Counts counts;
  counts.normals = surface.normals.size();
  for (const Polygon& polygon : surface.polygons) {
    std::uint64_t corners = 0;
    for (const Ring& ring : polygon.rings) {
      const auto vertices = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t i = 0; i < vertices; ++i) corners += is_corner(ring.data(), vertices, i);
      counts.links += vertices;
    }
    ++counts.regions;
    counts.rings += polygon.rings.size();
    counts.holes += polygon.rings.size() - 1;
    counts.corners += corners;
    ++(corners == 3 ? counts.three : corners == 4 ? counts.four : counts.more);
  }
  return counts;
}

}  // namespace discmc::host
