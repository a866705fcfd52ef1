// Reads meshes from files, for comparison and for drawing.
#pragma once

#include <string>
#include <vector>

#include "file_mesh.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// Reads a file of any format that Assimp supports: vertices and triangles, each triangle a
/// polygon. Coordinates are as in the file, except for glTF: its metres with y upwards become
/// millimetres with z upwards. Returns one mesh per material, with its colour and, if there are
/// several, its name. Throws std::runtime_error with the file's name if the file cannot be read,
/// has no triangle, or has a vertex that is not finite. Without Assimp, always throws.
std::vector<FileMesh> read_meshes(const std::string& file);

}  // namespace discmc::command
