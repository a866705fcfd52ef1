// Makes the mesh of a surface whose polygons stay in their planes.
#ifndef DISCMC_MESH_MESHES_PLANE_MESH_HPP
#define DISCMC_MESH_MESHES_PLANE_MESH_HPP

#include <functional>

#include "mesh.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

/// Implements build_mesh(). vertices: of its polygons. Limit: no interpolation.
FaceMesh plane_mesh(const Surface& surface, const VertexNumbers& vertices,
                    const MeshingOptions& options);

/// Makes the faces of plane_mesh() block by block, without vertices. consume: called with those of
/// each block, in order.
void for_each_face_block(const Surface& surface, const VertexNumbers& vertices,
                         const MeshingOptions& options,
                         const std::function<void(const FaceMesh&)>& consume);

}  // namespace discmc::meshing

#endif
