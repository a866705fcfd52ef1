// The edges between voxels that cross merged polygons.
#ifndef DISCMC_MESH_SURFACE_POLYGON_CROSSINGS_HPP
#define DISCMC_MESH_SURFACE_POLYGON_CROSSINGS_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <discmc/lattice.hpp>

#include "polygons.hpp"

namespace discmc::meshing {

/// Calls call(middle) for each edge along an axis that crosses a polygon. An edge through a side or
/// a corner crosses only one of the polygons there. Such an edge counts as moved slightly across
/// the axis, more along the next axis than along the third.
template <class Call>
void for_each_crossing(const Polygon& polygon, std::size_t axis, Call call) {
  using Turned = std::array<std::int32_t, 3>;  // from the axis on
  const auto turned = [axis](const Vertex& vertex) {
    const Turned at = {vertex.x, vertex.y, vertex.z};
    return Turned{at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]};
  };
  const auto turned_back = [axis](const Turned& at) {
    return Vertex{at[(3 - axis) % 3], at[(4 - axis) % 3], at[(5 - axis) % 3]};
  };
  const Turned n = turned(incidence_normal(polygon.incidence));
  if (n[0] == 0) return;

  struct Meeting {  // of a line along the second axis with a side
    std::int32_t line, at;
    bool operator<(const Meeting& other) const {
      return line != other.line ? line < other.line : at < other.at;
    }
  };
  std::vector<Meeting> meetings;
  for (const Ring& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Turned low = turned(ring[i]), high = turned(ring[i + 1 < ring.size() ? i + 1 : 0]);
      if (low[2] > high[2]) std::swap(low, high);
      // Along the second axis a side changes as much as along the third, or not at all.
      const std::int32_t slope = high[1] > low[1] ? 1 : high[1] < low[1] ? -1 : 0;
      for (std::int32_t line = low[2] + (low[2] & 1); line < high[2]; line += 2)
        meetings.push_back({line, low[1] + slope * (line - low[2])});
    }
  std::sort(meetings.begin(), meetings.end());
  const Turned origin = turned(polygon.rings[0][0]);
  for (std::size_t i = 0; i + 1 < meetings.size(); i += 2) {
    const std::int32_t line = meetings[i].line;
    for (std::int32_t at = meetings[i].at + (meetings[i].at & 1); at < meetings[i + 1].at;
         at += 2) {
      const std::int32_t along =
          origin[0] - n[0] * (n[1] * (at - origin[1]) + n[2] * (line - origin[2]));
      call(turned_back({along, at, line}));
    }
  }
}

/// Returns the share of one polygon in the number of voxels that a closed surface encloses. The sum
/// is negative for a cavity.
inline std::int64_t enclosed_voxels(const Polygon& polygon) {
  std::int64_t voxels = 0;
  const bool is_end = incidence_normal(polygon.incidence).x > 0;
  for_each_crossing(polygon, 0, [&](const Vertex& middle) {
    const std::int64_t before = (std::int64_t{middle.x} + 1) / 2;
    voxels += is_end ? before : -before;
  });
  return voxels;
}

}  // namespace discmc::meshing

#endif
