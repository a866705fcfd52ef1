// Several meshes as one.
#ifndef DISCMC_COMMAND_MESH_FILES_JOINED_MESH_HPP
#define DISCMC_COMMAND_MESH_FILES_JOINED_MESH_HPP

#include <vector>

#include "file_mesh.hpp"

namespace discmc::command {

/// The faces of all, in their order, with their polygons and normals; a single mesh as it is.
/// Limit: all have normals, or none.
FileMesh joined(std::vector<FileMesh> parts);

}  // namespace discmc::command

#endif
