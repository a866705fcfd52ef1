// Meshes from files: PLY, OBJ and STL.
#ifndef DISCMC_COMMAND_MESH_FILES_MESH_READER_HPP
#define DISCMC_COMMAND_MESH_FILES_MESH_READER_HPP

#include <filesystem>
#include <string>

#include "meshes/mesh.hpp"

namespace discmc::host {

/// Whether the name is that of a mesh, by its extension: .ply, .obj or .stl.
bool is_mesh_name(const std::filesystem::path& file);

/// Reads a mesh in the format of its extension: PLY in text or binary of either byte order, OBJ,
/// STL in text or binary. Every face is a polygon of its own; n-gons stay n-gons; there are normals
/// where vertices have them in the file. Colours, textures and groups are dropped.
///
/// Any bytes end in a mesh whose numbers are in range or in a std::runtime_error that names the
/// file, the fault and the remedy. What is allocated is in proportion to the bytes of the file.
Mesh read_mesh(const std::filesystem::path& file);

/// The same from the bytes of a file at hand.
Mesh read_mesh(const std::filesystem::path& name, std::string bytes);

}  // namespace discmc::host

#endif
