// The mesh of a surface whose vertices are moved to the crossings.
#ifndef DISCMC_MESH_MESHES_INTERPOLATED_MESH_HPP
#define DISCMC_MESH_MESHES_INTERPOLATED_MESH_HPP

#include "mesh.hpp"
#include "numbered_corners.hpp"

namespace discmc::meshing {

/// As build_mesh(). corners: of the surface. Limit: the options have crossings.
FaceMesh interpolated_mesh(const Surface& surface, NumberedCorners corners,
                           const MeshingOptions& options);

}  // namespace discmc::meshing

#endif
