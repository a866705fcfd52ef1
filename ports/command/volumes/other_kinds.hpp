// Files that commands take and that are no volumes, by their names.
#pragma once

#include <filesystem>

namespace discmc::command {

bool is_stream_name(const std::filesystem::path& file);
bool is_mesh_name(const std::filesystem::path& file);

/// The end of an error where a mesh is given to another command.
constexpr const char* who_takes_meshes =
    "only discmc compare, render and view read meshes: .stl, .ply, .obj, .glb or .3mf";

}  // namespace discmc::command
