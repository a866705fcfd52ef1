// The mesh of a surface whose polygons stay in their planes.
#ifndef DISCMC_COMMAND_MESHES_PLANE_MESH_HPP
#define DISCMC_COMMAND_MESHES_PLANE_MESH_HPP

#include "mesh.hpp"
#include "numbered_corners.hpp"

namespace discmc::command {

/// As build_mesh(). corners: of the surface. Limit: nothing is interpolated.
Mesh plane_mesh(const Surface& surface, NumberedCorners corners, const MeshOptions& options);

}  // namespace discmc::command

#endif
