// Meshes from files, to compare with them and to draw them.
#pragma once

#include <string>
#include <vector>

#include "file_mesh.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// Reads a file of any format that Assimp supports: vertices and triangles, each a polygon of its
/// own. Coordinates are as in the file, except those of glTF, which is in metres with y upwards:
/// they become millimetres with z upwards. One mesh per material, with its colour and, if there are
/// several, its name. Throws std::runtime_error with the file's name if it cannot be read, or has
/// no triangle, or has a vertex that is not finite. Without Assimp, it always throws.
std::vector<FileMesh> read_meshes(const std::string& file);

}  // namespace discmc::command
