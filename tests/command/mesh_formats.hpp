// Meshes from GLB, 3MF and VTP files, read with libraries for their JSON, XML and ZIP. What a file
// must have and lacks fails the test.
#pragma once

#include <string>
#include <vector>

#include "mesh_files/file_mesh.hpp"

namespace command_tests {

/// Brought from the metres of the file, y upwards, to millimetres, z upwards.
std::vector<discmc::command::FileMesh> meshes_of_glb(const std::string& bytes);
discmc::command::FileMesh mesh_of_glb(const std::string& bytes);

/// Also checks that the parts of the package find each other.
std::vector<discmc::command::FileMesh> meshes_of_3mf(const std::string& bytes);
discmc::command::FileMesh mesh_of_3mf(const std::string& bytes);

/// With the colour of its points, where they have one.
discmc::command::FileMesh mesh_of_vtp(const std::string& bytes);

}  // namespace command_tests
