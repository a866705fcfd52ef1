// The corners of a surface's polygons as numbers of vertices.
#ifndef DISCMC_MESH_MESHES_NUMBERED_CORNERS_HPP
#define DISCMC_MESH_MESHES_NUMBERED_CORNERS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/polygons.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

/// Places in Surface::polygons.
struct PolygonSpan {
  std::size_t first, end;
};

/// Polygons are worked on in blocks, as many of them at once as there are jobs.
std::size_t block_count(const Polygons& polygons);
PolygonSpan block_of(const Polygons& polygons, std::size_t block);

struct NumberedCorners {
  VertexNumbers vertices;
  std::vector<std::uint32_t> numbers;  ///< one a corner: see Polygons::corners()
};

/// Numbers vertices in the order of their first corners. The jobs do not change it.
NumberedCorners number_corners(const Polygons& polygons, unsigned jobs);

}  // namespace discmc::meshing

#endif
