#include "counts.hpp"

#include <cstddef>

namespace discmc::command {

Counts count(const Surface& surface) {
  Counts counts;
  counts.normals = surface.normals.size();
  for (const Polygon& polygon : surface.polygons) {
    std::uint64_t corners = 0;
    for (const Ring& ring : polygon.rings) {
      corners += ring.size();
      for (std::size_t i = 0; i < ring.size(); ++i)
        counts.links += static_cast<std::uint64_t>(
            side_between(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]).links);
    }
    ++counts.regions;
    counts.rings += polygon.rings.size();
    counts.holes += polygon.rings.size() - 1;
    counts.corners += corners;
    ++(corners == 3 ? counts.three : corners == 4 ? counts.four : counts.more);
  }
  return counts;
}

}  // namespace discmc::command
