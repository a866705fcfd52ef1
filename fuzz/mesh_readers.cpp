// Fuzz target. The promise: any bytes as PLY, OBJ or STL end in a std::runtime_error that names the
// file and the remedy, or in a mesh whose numbers are all in range and whose size is in proportion
// to the bytes.
//
//   fuzz_mesh_readers -max_len=1000 corpus/mesh_readers
//   fuzz_mesh_readers corpus/mesh_readers                   with replay_main.cpp

#include "mesh_files/mesh_reader.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "input.hpp"
#include "require.hpp"

using namespace discmc::host;

namespace {

void check_mesh(const Mesh& mesh, size_t bytes) {
  require(mesh.face_begin.size() == mesh.face_count() + 1, "faces without an end");
  require(mesh.face_begin.back() == mesh.corners.size(), "corners of no face");
  require(mesh.polygons.size() == mesh.face_count(), "a face without a polygon");
  require(mesh.incidences.empty(), "an incidence out of nothing");
  require(mesh.vertices_mm.size() <= bytes && mesh.corners.size() <= bytes, "more than was there");
  for (size_t face = 0; face < mesh.face_count(); ++face)
    require(mesh.face_size(face) >= 3, "a face of less than three corners");
  for (const uint32_t corner : mesh.corners)
    require(corner < mesh.vertices_mm.size(), "a corner that is no vertex");
  for (const Point& vertex : mesh.vertices_mm)
    for (const double coordinate : vertex)
      require(std::fabs(coordinate) <= 1e30, "a coordinate out of range");
  require(mesh.normals.empty() || mesh.normals.size() == mesh.vertices_mm.size(),
          "normals of some vertices only");
  for (const Point& normal : mesh.normals) {
    const double square = dot(normal, normal);
    require(square == 0 || std::fabs(square - 1) < 1e-9, "a normal that is no unit vector");
  }
}

void check_error(const std::string& text, const std::string& name) {
  require(text.rfind(name + ": ", 0) == 0, "an error that does not name the file");
  require(text.find("; ") != std::string::npos, "an error without a remedy");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  constexpr const char* names[] = {"m.ply", "m.obj", "m.stl"};
  Input input(data, size);
  const std::string name = names[input.below(3)];
  const std::vector<uint8_t> rest = input.bytes(size);
  try {
    check_mesh(read_mesh(name, std::string(rest.begin(), rest.end())), rest.size());
  } catch (const std::runtime_error& error) {
    check_error(error.what(), name);
  }
  return 0;
}
