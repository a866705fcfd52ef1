#include "mesh_reader.hpp"

#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh_input.hpp"
#include "volumes/volume_format.hpp"

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
  std::ifstream in;
  if (std::filesystem::is_regular_file(file)) in.open(file, std::ios::binary);
  if (!in.is_open())
    throw std::runtime_error(file.string() +
                             ": cannot be read; check the name and its permissions");
  std::string bytes(std::filesystem::file_size(file), ' ');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return read_mesh(file, std::move(bytes));
}

Mesh read_mesh(const std::filesystem::path& name, std::string bytes) {
  MeshInput input(name, std::move(bytes));
  const std::string extension = extension_of(name);
  if (extension == ".ply")
    read_ply(input);
  else if (extension == ".obj")
    read_obj(input);
  else
    read_stl(input);
  return input.finish();
}

}  // namespace discmc::host
