// The corners of a surface's polygons as numbers of vertices.
#ifndef DISCMC_COMMAND_MESHES_NUMBERED_CORNERS_HPP
#define DISCMC_COMMAND_MESHES_NUMBERED_CORNERS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/surface.hpp"
#include "vertex_numbers.hpp"

namespace discmc::host {

/// Places in Surface::polygons.
struct PolygonSpan {
  std::size_t first, end;
};

/// Polygons are worked on in blocks, as many of them at once as there are jobs.
PolygonSpan block_of(const Surface& surface, std::size_t block);

struct NumberedCorners {
  VertexNumbers vertices;
  std::vector<std::vector<std::uint32_t>> of_block;  ///< of every corner of every ring
};

/// Numbers vertices in the order of their first corners. The jobs do not change it.
NumberedCorners number_corners(const Surface& surface, unsigned jobs);

}  // namespace discmc::host

#endif
