// The mesh of a surface whose vertices are moved to the crossings.
#ifndef DISCMC_COMMAND_MESHES_INTERPOLATED_MESH_HPP
#define DISCMC_COMMAND_MESHES_INTERPOLATED_MESH_HPP

#include "mesh.hpp"
#include "numbered_corners.hpp"

namespace discmc::command {

/// As build_mesh(). corners: of the surface. Limit: the options have crossings.
Mesh interpolated_mesh(const Surface& surface, NumberedCorners corners, const MeshOptions& options);

}  // namespace discmc::command

#endif
