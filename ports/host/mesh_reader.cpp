#include "mesh_reader.hpp"

#include <string>

#include "mesh_input.hpp"
#include "volume_format.hpp"

namespace discmc::host {
namespace {

std::string extension_of(const std::filesystem::path& file) {
  return lower(file.extension().string());
}

}  // namespace

bool is_mesh_name(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  return extension == ".ply" || extension == ".obj" || extension == ".stl";
}

Mesh read_mesh(const std::filesystem::path& file) {
  MeshInput input(file);
  const std::string extension = extension_of(file);
  if (extension == ".ply")
    read_ply(input);
  else if (extension == ".obj")
    read_obj(input);
  else
    read_stl(input);
  return input.finish();
}

}  // namespace discmc::host
