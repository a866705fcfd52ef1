// Reads meshes from GLB, 3MF and VTP files, with libraries for JSON, XML and ZIP. If a mandatory
// part of a file is missing, the test fails.
#pragma once

#include <string>
#include <vector>

#include "mesh_files/file_mesh.hpp"

namespace command_tests {

/// Converts metres, y upwards, to millimetres, z upwards.
std::vector<discmc::command::FileMesh> meshes_of_glb(const std::string& bytes);
discmc::command::FileMesh mesh_of_glb(const std::string& bytes);

/// Also checks that the parts of the package refer to each other.
std::vector<discmc::command::FileMesh> meshes_of_3mf(const std::string& bytes);
discmc::command::FileMesh mesh_of_3mf(const std::string& bytes);

/// With the colours of points, if the file has them.
discmc::command::FileMesh mesh_of_vtp(const std::string& bytes);

}  // namespace command_tests
