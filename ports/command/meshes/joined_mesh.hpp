// Several meshes as one.
#ifndef DISCMC_COMMAND_MESHES_JOINED_MESH_HPP
#define DISCMC_COMMAND_MESHES_JOINED_MESH_HPP

#include <vector>

#include "mesh.hpp"

namespace discmc::command {

/// The faces of all, in their order, with their polygons and normals; a single mesh as it is.
/// Limit: all have normals, or none.
Mesh joined(std::vector<Mesh> parts);

}  // namespace discmc::command

#endif
