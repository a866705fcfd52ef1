// Makes the mesh of a surface whose polygons stay in their planes.
#ifndef DISCMC_MESH_MESHES_PLANE_MESH_HPP
#define DISCMC_MESH_MESHES_PLANE_MESH_HPP

#include "mesh.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

/// Implements build_mesh(). vertices: of its polygons. Limit: no interpolation.
FaceMesh plane_mesh(const Surface& surface, const VertexNumbers& vertices,
                    const MeshingOptions& options);

}  // namespace discmc::meshing

#endif
