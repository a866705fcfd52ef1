// Checks whether two triangles of a mesh intersect.
#ifndef DISCMC_MESH_MESHES_TRIANGLE_INTERSECTION_HPP
#define DISCMC_MESH_MESHES_TRIANGLE_INTERSECTION_HPP

#include <cstddef>
#include <cstdint>

#include "box_tree.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// A triangle of a mesh: the numbers and positions of its vertices.
struct PlacedTriangle {
  const std::uint32_t* numbers;
  Corners corners;
};

/// Returns the number of vertices that two triangles share.
inline unsigned count_shared(const std::uint32_t* a, const std::uint32_t* b) {
  unsigned count = 0;
  for (std::size_t i = 0; i < 3; ++i) count += a[i] == b[0] || a[i] == b[1] || a[i] == b[2];
  return count;
}

/// Whether two triangles meet outside their shared vertex. False if they lie in one plane. Limit:
/// no shared edge.
bool intersect(const PlacedTriangle& a, const PlacedTriangle& b);

}  // namespace discmc::meshing

#endif
