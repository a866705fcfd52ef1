#include <cstdint>

#include "mesh_files.hpp"
#include "writer.hpp"

namespace discmc::host {
namespace {

// A line of OBJ.
void write_point(const char* key, const Point& point, Writer& writer) {
  writer.text(key);
  for (const double coordinate : point) {
    writer.text(" ");
    writer.decimal(coordinate);
  }
  writer.text("\n");
}

}  // namespace

void write_obj(const Mesh& mesh, std::ostream& out) {
  Writer writer(out);
  writer.text("# ");
  writer.text(header_text(mesh));
  writer.text("\n");
  for (const Point& vertex : mesh.vertices_mm) write_point("v", vertex, writer);
  for (const Point& normal : mesh.normals) write_point("vn", normal, writer);
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    writer.text("f");
    for (std::size_t i = 0; i < mesh.face_size(face); ++i) {
      const std::uint64_t number = std::uint64_t{mesh.face(face)[i]} + 1;
      writer.text(" ");
      writer.decimal(number);
      if (mesh.normals.empty()) continue;
      writer.text("//");
      writer.decimal(number);
    }
    writer.text("\n");
  }
  writer.finish();
}

}  // namespace discmc::host
