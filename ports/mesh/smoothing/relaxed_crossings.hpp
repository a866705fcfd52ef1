// The smoothest surface between the voxels, from the voxels alone.
#ifndef DISCMC_MESH_SMOOTHING_RELAXED_CROSSINGS_HPP
#define DISCMC_MESH_SMOOTHING_RELAXED_CROSSINGS_HPP

#include <discmc/limits.hpp>
#include <functional>

#include "extraction/crossings.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

struct Relaxation {
  Border border = Border::closed;  ///< of the volume
  double tolerance = 0;            ///< as MeshingOptions, of the mesh that is to be made
  std::function<void()> check{};   ///< as MeshingOptions
};

/// Moves crossings within their intervals to the smoothest surface, in the manner of constrained
/// elastic surface nets (S. Gibson, 1998), whose nodes move within cells. None passes a voxel: the
/// surface stays closed, and no body, gap or tunnel is lost. Straight parts stay straight. If faces
/// of the mesh would intersect, their crossings move back to the middles of their edges. surface:
/// the one that has these crossings. Cost: two meshes, or more if there are such faces.
void relax(Crossings& crossings, const Surface& surface, const Relaxation& relaxation);

/// Its last step: moves crossings of faces that intersect to the middle of their edges.
void separate(Crossings& crossings, const Surface& surface, const Relaxation& relaxation);

}  // namespace discmc::meshing

#endif
