#include <cstdint>
#include <stdexcept>

#include "mesh_files.hpp"
#include "writer.hpp"

namespace discmc::command {

void write_ply(const Mesh& mesh, std::ostream& out, unsigned jobs) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face_size(face) > max_face_corners)
      throw std::invalid_argument("a face of more corners than PLY counts in a byte");
  Writer writer(out);
  writer.text("ply\nformat binary_little_endian 1.0\ncomment ");
  writer.text(header_text(mesh));
  writer.text("\nelement vertex ");
  writer.decimal(mesh.vertices_mm.size());
  writer.text("\nproperty float x\nproperty float y\nproperty float z");
  if (!mesh.normals.empty())
    writer.text("\nproperty float nx\nproperty float ny\nproperty float nz");
  if (mesh.colour) writer.text("\nproperty uchar red\nproperty uchar green\nproperty uchar blue");
  writer.text("\nelement face ");
  writer.decimal(mesh.face_count());
  writer.text("\nproperty list uchar int vertex_indices\nend_header\n");
  writer.items(jobs, mesh.vertices_mm.size(), [&mesh](Writer& part, std::size_t vertex) {
    part.point(mesh.vertices_mm[vertex]);
    if (!mesh.normals.empty()) part.point(mesh.normals[vertex]);
    if (mesh.colour)
      for (const std::uint8_t value : *mesh.colour) part.bytes(value, 1);
  });
  writer.items(jobs, mesh.face_count(), [&mesh](Writer& part, std::size_t face) {
    part.bytes(mesh.face_size(face), 1);
    for (std::size_t i = 0; i < mesh.face_size(face); ++i) part.bytes(mesh.face(face)[i], 4);
  });
  writer.finish();
}

}  // namespace discmc::command
