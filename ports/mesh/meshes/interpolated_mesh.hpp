// Makes the mesh of a surface whose vertices move to the crossings.
#ifndef DISCMC_MESH_MESHES_INTERPOLATED_MESH_HPP
#define DISCMC_MESH_MESHES_INTERPOLATED_MESH_HPP

#include "mesh.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

/// Implements build_mesh(). vertices: of its polygons. Limit: the options have crossings.
FaceMesh interpolated_mesh(const Surface& surface, VertexNumbers vertices,
                           const MeshingOptions& options);

}  // namespace discmc::meshing

#endif
