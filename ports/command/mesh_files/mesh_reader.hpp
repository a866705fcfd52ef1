// Meshes from files, to compare with them.
#ifndef DISCMC_COMMAND_MESH_FILES_MESH_READER_HPP
#define DISCMC_COMMAND_MESH_FILES_MESH_READER_HPP

#include <string>

#include "meshes/mesh.hpp"

namespace discmc::command {

/// Reads a mesh of any format that Assimp supports: vertices and triangles, coordinates as they are
/// in the file; of glTF, which is in metres with y upwards, in millimetres with z upwards. Throws
/// std::runtime_error with the file's name: when it cannot be read, when it holds no triangle or a
/// vertex that is not finite, and always where the program was built without Assimp.
Mesh read_mesh(const std::string& file);

}  // namespace discmc::command

#endif
