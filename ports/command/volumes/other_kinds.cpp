#include "other_kinds.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "text/words.hpp"

namespace discmc::command {

bool is_stream_name(const std::filesystem::path& file) {
  return lower(file.extension().string()) == ".dmc";
}

bool is_mesh_name(const std::filesystem::path& file) {
  constexpr std::string_view meshes[] = {".stl", ".ply", ".obj", ".glb", ".gltf", ".3mf", ".vtp"};
  const std::string extension = lower(file.extension().string());
  return std::find(std::begin(meshes), std::end(meshes), extension) != std::end(meshes);
}

}  // namespace discmc::command
