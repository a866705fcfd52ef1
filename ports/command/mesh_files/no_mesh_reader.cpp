// Replaces the mesh reader in builds without Assimp.
#include <stdexcept>

#include "mesh_reader.hpp"

namespace discmc::command {

std::vector<FileMesh> read_meshes(const std::string& file) {
  throw std::runtime_error(file +
                           ": this is a mesh, and discmc was built without Assimp; install "
                           "libassimp-dev and build again");
}

}  // namespace discmc::command
