// Fractions: where the surface crosses the edges between voxels.
//
// A polygon has its vertices at the midpoints of the edges that the surface crosses. A stream of
// slices may also contain where on each edge the samples reach the threshold: see
// fraction_slice_encoder.hpp. A receiver moves the vertices there, and has the interpolated
// surface. It receives an event `fractions` for each row, before all polygons with a vertex on one
// of these edges. The centroids of cells, which have three odd coordinates, lie on no edge.
#ifndef DISCMC_FRACTION_HPP
#define DISCMC_FRACTION_HPP

#include <stdint.h>
#include <discmc/lattice.hpp>

namespace discmc {

/// Returns the crossing of the surface with the edge from a voxel to the voxel before it along an
/// axis. entry: of the voxel, in an event. axis: 0 for x, 1 for y, 2 for z. Units: eighths of the
/// edge, counted from the voxel before. The number is the middle of the interval that contains the
/// crossing: 2 or 6 for 2 levels; 1, 3, 5 or 7 for 4. 0: the surface does not cross the edge, or
/// the crossing is unknown. Then leave the vertex at the midpoint.
constexpr uint32_t fraction_of(uint16_t entry, uint32_t axis) {
  return uint32_t{entry} >> 3 * axis & 7;
}

/// The midpoint of that edge of voxel (x, y, z), where polygons have their vertex.
constexpr Vertex edge_midpoint(uint32_t x, uint32_t y, uint32_t z, uint32_t axis) {
  const auto at = [axis](uint32_t voxel, uint32_t along) {
    return static_cast<int32_t>(2 * voxel - (axis == along ? 1 : 0));
  };
  return {at(x, 0), at(y, 1), at(z, 2)};
}

}  // namespace discmc

#endif
