#include <cstdint>
#include <string>

#include "file_mesh.hpp"
#include "mesh_files.hpp"
#include "text/base64.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

// write: sends this many bytes to a Writer.
template <class Write>
void write_array(const std::string& attributes, std::uint64_t bytes, std::ostream& out,
                 const Write& write) {
  out << "<DataArray " << attributes << " format=\"binary\">";
  Base64 base64(out);
  std::ostream encoded(&base64);
  Writer writer(encoded);
  writer.bytes(bytes, 8);
  write(writer);
  writer.finish();
  base64.finish();
  out << "</DataArray>\n";
}

// bits: of a coordinate, 32 or 64.
void write_points(const std::string& name, int bits, const std::vector<Point>& points,
                  std::ostream& out) {
  const std::string attributes =
      "type=\"Float" + std::to_string(bits) + "\" NumberOfComponents=\"3\" Name=\"" + name + "\"";
  write_array(attributes, static_cast<std::uint64_t>(3 * bits / 8) * points.size(), out,
              [&points, bits](Writer& writer) {
                for (const Point& point : points)
                  bits == 32 ? writer.floats(point) : writer.doubles(point);
              });
}

// Every point has the same colour, because VTK draws such values without a colour table.
void write_colour(const Srgb& colour, std::size_t points, std::ostream& out) {
  write_array("type=\"UInt8\" NumberOfComponents=\"3\" Name=\"Colors\"", 3 * points, out,
              [&](Writer& writer) {
                for (std::size_t i = 0; i < points; ++i)
                  for (const std::uint8_t part : colour) writer.bytes(part, 1);
              });
}

void write_point_data(const FileMesh& mesh, std::ostream& out) {
  if (mesh.normals.empty() && !mesh.colour) return;
  out << "<PointData" << (mesh.normals.empty() ? "" : " Normals=\"Normals\"")
      << (mesh.colour ? " Scalars=\"Colors\"" : "") << ">\n";
  if (!mesh.normals.empty()) write_points("Normals", 32, mesh.normals, out);
  if (mesh.colour) write_colour(*mesh.colour, mesh.vertices_mm.size(), out);
  out << "</PointData>\n";
}

// Returns the space in the form that 3D Slicer reads: a string as its characters and a zero.
const char* field_data(Space space) {
  switch (space) {
    case Space::scanner:
      break;
    case Space::lps:
      return "<FieldData>\n<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
             "format=\"ascii\">76 80 83 0</Array>\n</FieldData>\n";
    case Space::ras:
      return "<FieldData>\n<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
             "format=\"ascii\">82 65 83 0</Array>\n</FieldData>\n";
  }
  return "";
}

}  // namespace

// The arrays have the types that VTK itself writes, because some readers support no others.
void write_vtp(const FileMesh& mesh, std::ostream& out) {
  out << "<?xml version=\"1.0\"?>\n<!-- " << header_text(mesh)
      << " -->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PolyData>\n"
      << field_data(mesh.space) << "<Piece NumberOfPoints=\"" << mesh.vertices_mm.size()
      << "\" NumberOfPolys=\"" << mesh.face_count() << "\">\n";
  write_point_data(mesh, out);
  out << "<Points>\n";
  write_points("Points", suits_floats(mesh) ? 32 : 64, mesh.vertices_mm, out);
  out << "</Points>\n<Polys>\n";
  write_array("type=\"Int64\" Name=\"connectivity\"", 8 * mesh.corners.size(), out,
              [&mesh](Writer& writer) {
                for (const std::uint32_t corner : mesh.corners) writer.bytes(corner, 8);
              });
  write_array("type=\"Int64\" Name=\"offsets\"", 8 * mesh.face_count(), out,
              [&mesh](Writer& writer) {
                for (std::size_t face = 0; face < mesh.face_count(); ++face)
                  writer.bytes(mesh.face_begin[face + 1], 8);
              });
  out << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  Writer(out).finish();
}

}  // namespace discmc::command
