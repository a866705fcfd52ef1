// The mesh of a surface whose polygons stay in their planes.
#ifndef DISCMC_MESH_MESHES_PLANE_MESH_HPP
#define DISCMC_MESH_MESHES_PLANE_MESH_HPP

#include "mesh.hpp"
#include "numbered_corners.hpp"

namespace discmc::meshing {

/// As build_mesh(). corners: of the surface. Limit: nothing is interpolated.
FaceMesh plane_mesh(const Surface& surface, NumberedCorners corners, const MeshingOptions& options);

}  // namespace discmc::meshing

#endif
