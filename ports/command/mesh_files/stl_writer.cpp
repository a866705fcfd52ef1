#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh_files.hpp"
#include "writer.hpp"

namespace discmc::host {

void write_stl(const Mesh& mesh, std::ostream& out) {
  require_triangles(mesh, "STL");
  if (mesh.face_count() > 0xFFFFFFFFu) throw std::invalid_argument("too many triangles for STL");
  Writer writer(out);
  std::string header = "binary STL, ";  // "solid" would announce text
  header += header_text(mesh);
  header.resize(80, ' ');
  writer.text(header);
  writer.bytes(mesh.face_count(), 4);
  const std::vector<Incidence>& planes = mesh.incidences;
  Point normal{};
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    // The triangles of a polygon come together.
    const bool is_parallel = face > 0 && !planes.empty() && planes[face] == planes[face - 1];
    if (!is_parallel) normal = face_normal(mesh, face);
    writer.point(normal);
    for (std::size_t i = 0; i < 3; ++i) writer.point(mesh.vertices_mm[mesh.face(face)[i]]);
    writer.bytes(0, 2);
  }
  writer.finish();
}

}  // namespace discmc::host
