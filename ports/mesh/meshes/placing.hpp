// Moves a mesh to the placement of its volume.
#ifndef DISCMC_MESH_MESHES_PLACING_HPP
#define DISCMC_MESH_MESHES_PLACING_HPP

#include "mesh.hpp"
#include "samples/volume_placement.hpp"

namespace discmc::meshing {

/// Moves a mesh of build_mesh() to the placement; call it once. Transforms vertices and normals, as
/// planes, even for oblique axes. Reverses corners if the placement mirrors. A vertex (x, y, z), in
/// half-steps, then lies at origin + (x axes[0] + y axes[1] + z axes[2]) / 2. Limit:
/// is_usable(placement).
void place(FaceMesh& mesh, const VolumePlacement& placement);

}  // namespace discmc::meshing

#endif
