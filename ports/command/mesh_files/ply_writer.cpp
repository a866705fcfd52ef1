#include <cstdint>
#include <stdexcept>
#include <string>

#include "float_precision.hpp"
#include "mesh_files.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

void require_fit(const FileMesh& mesh) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face_size(face) > max_face_corners)
      throw std::invalid_argument(
          "a face has more corners than a byte of PLY counts; write triangles");
  constexpr std::size_t most = 0x7FFFFFFF;  // numbers have a sign, as in the files of others
  if (mesh.vertices_mm.size() > most)
    throw std::invalid_argument(
        "the mesh has too many vertices for PLY; write .vtp, or a part with --crop");
}

}  // namespace

void write_ply(const FileMesh& mesh, std::ostream& out, unsigned jobs) {
  require_fit(mesh);
  const bool takes_floats = suits_floats(mesh);
  const std::string property = takes_floats ? "\nproperty float " : "\nproperty double ";
  Writer writer(out);
  writer.text("ply\nformat binary_little_endian 1.0\ncomment ");
  writer.text(header_text(mesh));
  writer.text("\nelement vertex ");
  writer.decimal(mesh.vertices_mm.size());
  for (const char* axis : {"x", "y", "z"}) writer.text(property + axis);
  if (!mesh.normals.empty())
    writer.text("\nproperty float nx\nproperty float ny\nproperty float nz");
  if (mesh.colour) writer.text("\nproperty uchar red\nproperty uchar green\nproperty uchar blue");
  writer.text("\nelement face ");
  writer.decimal(mesh.face_count());
  writer.text("\nproperty list uchar int vertex_indices\nend_header\n");
  writer.items(jobs, mesh.vertices_mm.size(), [&](Writer& part, std::size_t vertex) {
    if (takes_floats)
      part.floats(mesh.vertices_mm[vertex]);
    else
      part.doubles(mesh.vertices_mm[vertex]);
    if (!mesh.normals.empty()) part.floats(mesh.normals[vertex]);
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
