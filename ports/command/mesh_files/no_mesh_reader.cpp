// Where Assimp is not.
#include <stdexcept>

#include "mesh_reader.hpp"

namespace discmc::command {

Mesh read_mesh(const std::string& file) {
  throw std::runtime_error(file +
                           ": this discmc was built without Assimp, which reads meshes: install it "
                           "(Debian: libassimp-dev) and build anew");
}

}  // namespace discmc::command
