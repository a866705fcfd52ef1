// The mesh of a surface whose polygons stay in their planes.
#ifndef DISCMC_MESH_MESHES_PLANE_MESH_HPP
#define DISCMC_MESH_MESHES_PLANE_MESH_HPP

#include "mesh.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

/// As build_mesh(). vertices: of its polygons. Limit: nothing is interpolated.
FaceMesh plane_mesh(const Surface& surface, VertexNumbers vertices, const MeshingOptions& options);

}  // namespace discmc::meshing

#endif
