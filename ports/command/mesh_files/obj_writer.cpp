#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_files.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

void write_point(const char* key, const Point& point, Writer& writer) {
  writer.text(key);
  for (const double coordinate : point) {
    writer.text(" ");
    writer.decimal(coordinate);
  }
  writer.text("\n");
}

void write_face(const FileMesh& mesh, std::size_t face, Writer& writer) {
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

constexpr std::string_view material_name = "surface";

}  // namespace

void write_obj(const FileMesh& mesh, std::ostream& out, unsigned jobs,
               const std::string& material_file) {
  Writer writer(out);
  writer.text("# ");
  writer.text(header_text(mesh));
  writer.text("\n");
  if (!material_file.empty()) {
    writer.text("mtllib " + material_file + "\nusemtl ");
    writer.text(material_name);
    writer.text("\n");
  }
  const auto write_points = [&](const char* key, const std::vector<Point>& points) {
    writer.items(jobs, points.size(), [key, &points](Writer& part, std::size_t point) {
      write_point(key, points[point], part);
    });
  };
  write_points("v", mesh.vertices_mm);
  write_points("vn", mesh.normals);
  writer.items(jobs, mesh.face_count(),
               [&mesh](Writer& part, std::size_t face) { write_face(mesh, face, part); });
  writer.finish();
}

void write_mtl(const Srgb& colour, std::ostream& out) {
  Writer writer(out);
  writer.text("newmtl ");
  writer.text(material_name);
  writer.text("\nKd");
  for (const std::uint8_t part : colour) {
    writer.text(" ");
    writer.decimal(part / 255.0);
  }
  writer.text("\n");
  writer.finish();
}

}  // namespace discmc::command
