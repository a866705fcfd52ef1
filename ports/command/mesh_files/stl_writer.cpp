#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "mesh_files.hpp"
#include "mesh_parts.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

std::string stl_header(const FileMesh& mesh, std::uint64_t triangles) {
  if (triangles > 0xFFFFFFFFu)
    throw std::invalid_argument(
        "the mesh has too many triangles for STL; write .ply, or a part with --crop");
  std::string header = "binary STL, ";  // "solid" would mark a text file
  header += header_text(mesh);
  header.resize(80, ' ');
  for (int shift = 0; shift < 32; shift += 8)
    header += static_cast<char>(triangles >> shift & 0xFF);
  return header;
}

// Writes the triangles of a mesh or its parts.
class TriangleWriter {
 public:
  explicit TriangleWriter(const Point& spacing_mm) {
    for (Incidence i = 0; i < incidence_codes; ++i)
      put_floats(outward_normal(i, spacing_mm), normals_[i].data());
  }

  // Writes the normal, three corners, and two bytes of zero.
  void write(const FileMesh& mesh, std::size_t face, Writer& writer) const {
    char* place = writer.room_for(4 * point_bytes + 2);
    if (mesh.incidences.empty())
      put_floats(face_normal(mesh, face), place);
    else
      std::memcpy(place, normals_[mesh.incidences[face]].data(), point_bytes);
    place += point_bytes;
    const std::uint32_t* const corners = mesh.face(face);
    for (std::size_t i = 0; i < 3; ++i) place = put_floats(mesh.vertices_mm[corners[i]], place);
    place[0] = place[1] = 0;
  }

 private:
  static constexpr std::size_t point_bytes = 3 * sizeof(float);

  std::array<std::array<char, point_bytes>, incidence_codes> normals_;
};

}  // namespace

void write_stl(const FileMesh& mesh, std::ostream& out, unsigned jobs) {
  require_triangles(mesh, "STL");
  Writer writer(out);
  writer.text(stl_header(mesh, mesh.face_count()));
  const TriangleWriter triangles(mesh.spacing_mm);
  writer.items(jobs, mesh.face_count(),
               [&](Writer& part, std::size_t face) { triangles.write(mesh, face, part); });
  writer.finish();
}

MeshTotals write_stl(const MeshParts& parts, std::ostream& out) {
  const FileMesh frame = parts.bounds();
  Writer writer(out);
  writer.text(stl_header(frame, 0));
  const TriangleWriter triangles(frame.spacing_mm);
  const MeshTotals totals = write_faces(parts, &MeshParts::make_triangles, writer,
                                        [&](const FileMesh& mesh, std::size_t face, Writer& part) {
                                          triangles.write(mesh, face, part);
                                        });
  writer.finish_with_start(stl_header(frame, totals.faces));
  return totals;
}

}  // namespace discmc::command
