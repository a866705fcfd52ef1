// Meshes from files, to compare with them and to draw them.
#ifndef DISCMC_COMMAND_MESH_FILES_MESH_READER_HPP
#define DISCMC_COMMAND_MESH_FILES_MESH_READER_HPP

#include <string>
#include <vector>

#include "file_mesh.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// Reads a file of any format that Assimp supports: vertices and triangles, each of which is a
/// polygon of its own; coordinates as they are in the file; of glTF, which is in metres with y
/// upwards, in millimetres with z upwards. One mesh per material, with its colour and, if there are
/// several, its name. Throws std::runtime_error with the file's name: when it cannot be read, when
/// it holds no triangle or a vertex that is not finite, and always where the program was built
/// without Assimp.
std::vector<FileMesh> read_meshes(const std::string& file);

}  // namespace discmc::command

#endif
