#include <cstdint>
#include <stdexcept>
#include <string>

#include "file_mesh.hpp"
#include "mesh_files.hpp"
#include "mesh_parts.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

void require_fit(std::size_t vertices) {
  constexpr std::size_t max_number = 0x7FFFFFFF;  // many readers use signed numbers
  if (vertices > max_number)
    throw std::invalid_argument(
        "the mesh has too many vertices for PLY; write .vtp, or a part with --crop");
}

void require_short_faces(const FileMesh& mesh) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face_size(face) > max_face_corners)
      throw std::invalid_argument(
          "a face has more corners than a byte of PLY counts; write triangles");
}

// The header has a fixed length, because MeshParts counts its faces last.
std::string ply_header(const FileMesh& mesh, bool uses_floats, std::size_t vertices,
                       std::uint64_t faces) {
  constexpr std::size_t max_digits = 20;
  const std::string property = uses_floats ? "\nproperty float " : "\nproperty double ";
  const std::string count = decimal(faces);
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment " + header_text(mesh) +
                       std::string(max_digits - count.size(), ' ') + "\nelement vertex " +
                       decimal(vertices);
  for (const char* axis : {"x", "y", "z"}) header += property + axis;
  if (!mesh.normals.empty()) header += "\nproperty float nx\nproperty float ny\nproperty float nz";
  if (mesh.colour) header += "\nproperty uchar red\nproperty uchar green\nproperty uchar blue";
  header += "\nelement face " + count;
  return header + "\nproperty list uchar int vertex_indices\nend_header\n";
}

void write_ply_vertex(const FileMesh& mesh, std::size_t vertex, bool uses_floats, Writer& writer) {
  if (uses_floats)
    writer.floats(mesh.vertices_mm[vertex]);
  else
    writer.doubles(mesh.vertices_mm[vertex]);
  if (!mesh.normals.empty()) writer.floats(mesh.normals[vertex]);
  if (mesh.colour)
    for (const std::uint8_t value : *mesh.colour) writer.bytes(value, 1);
}

void write_ply_face(const FileMesh& mesh, std::size_t face, Writer& writer) {
  const std::size_t count = mesh.face_size(face);
  writer.bytes(count, 1);
  for (std::size_t i = 0; i < count; ++i) writer.bytes(mesh.face(face)[i], 4);
}

}  // namespace

void write_ply(const FileMesh& mesh, std::ostream& out, unsigned jobs) {
  require_short_faces(mesh);
  require_fit(mesh.vertices_mm.size());
  const bool uses_floats = suits_floats(mesh);
  Writer writer(out);
  writer.text(ply_header(mesh, uses_floats, mesh.vertices_mm.size(), mesh.face_count()));
  writer.items(jobs, mesh.vertices_mm.size(), [&](Writer& part, std::size_t vertex) {
    write_ply_vertex(mesh, vertex, uses_floats, part);
  });
  writer.items(jobs, mesh.face_count(),
               [&mesh](Writer& part, std::size_t face) { write_ply_face(mesh, face, part); });
  writer.finish();
}

MeshTotals write_ply(const MeshParts& parts, std::ostream& out) {
  const std::size_t vertices = parts.vertex_count();
  require_fit(vertices);
  const FileMesh frame = parts.bounds();
  Writer writer(out);
  writer.text(ply_header(frame, true, vertices, 0));
  writer.parts<FileMesh>(
      parts.jobs(), parts.vertex_part_count(),
      [&](Writer& part, std::size_t number, FileMesh& mesh) {
        parts.make_vertices(number, mesh);
        for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
          write_ply_vertex(mesh, i, true, part);
      },
      [](const FileMesh&) {});
  const MeshTotals totals = write_faces(parts, &MeshParts::make_faces, writer, write_ply_face);
  writer.finish_with_start(ply_header(frame, true, vertices, totals.faces));
  return totals;
}

}  // namespace discmc::command
