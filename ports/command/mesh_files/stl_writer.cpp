#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh_files.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

// One per incidence.
std::array<Point, incidence_codes> plane_normals(const Point& spacing_mm) {
  std::array<Point, incidence_codes> normals;
  for (Incidence i = 0; i < incidence_codes; ++i) normals[i] = outward_normal(i, spacing_mm);
  return normals;
}

}  // namespace

void write_stl(const FileMesh& mesh, std::ostream& out, unsigned jobs) {
  require_triangles(mesh, "STL");
  if (mesh.face_count() > 0xFFFFFFFFu)
    throw std::invalid_argument(
        "the mesh has too many triangles for STL; write .ply, or a part with --crop");
  Writer writer(out);
  std::string header = "binary STL, ";  // "solid" would announce text
  header += header_text(mesh);
  header.resize(80, ' ');
  writer.text(header);
  writer.bytes(mesh.face_count(), 4);
  const bool has_planes = !mesh.incidences.empty();
  const auto normals = plane_normals(mesh.spacing_mm);
  writer.items(jobs, mesh.face_count(), [&](Writer& part, std::size_t face) {
    part.floats(has_planes ? normals[mesh.incidences[face]] : face_normal(mesh, face));
    for (std::size_t i = 0; i < 3; ++i) part.floats(mesh.vertices_mm[mesh.face(face)[i]]);
    part.bytes(0, 2);
  });
  writer.finish();
}

}  // namespace discmc::command
