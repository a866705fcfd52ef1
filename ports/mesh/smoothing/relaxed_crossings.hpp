// Finds the smoothest surface between the voxels, without samples.
#ifndef DISCMC_MESH_SMOOTHING_RELAXED_CROSSINGS_HPP
#define DISCMC_MESH_SMOOTHING_RELAXED_CROSSINGS_HPP

#include <discmc/limits.hpp>
#include <functional>

#include "extraction/crossings.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

struct Relaxation {
  Border border = Border::closed;  ///< of the volume
  double tolerance = 0;            ///< as MeshingOptions, for the mesh to be made
  std::function<void()> check{};   ///< as MeshingOptions
};

/// Moves crossings within their intervals to the smoothest surface, in the manner of constrained
/// elastic surface nets (S. Gibson, 1998), whose nodes move within cells. No crossing passes a
/// voxel, so the surface stays closed, and no body, gap or tunnel is lost. Straight parts stay
/// straight. If faces of the mesh would intersect, their crossings return to the middles of their
/// edges. surface: has these crossings. Cost: two meshes, or more if faces intersect.
void relax(Crossings& crossings, const Surface& surface, const Relaxation& relaxation);

/// The last step of relax(): moves crossings of intersecting faces to the middle of their edges.
void separate(Crossings& crossings, const Surface& surface, const Relaxation& relaxation);

}  // namespace discmc::meshing

#endif
