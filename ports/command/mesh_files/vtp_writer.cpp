#include <cstdint>
#include <string>

#include "mesh_files.hpp"
#include "text/base64.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

// write: gives a Writer so many bytes.
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

// attributes: what sets them apart from other points.
void write_points(const std::string& attributes, const std::vector<Point>& points,
                  std::ostream& out) {
  write_array("type=\"Float32\" NumberOfComponents=\"3\" " + attributes, 12 * points.size(), out,
              [&points](Writer& writer) {
                for (const Point& point : points) writer.point(point);
              });
}

// The frame as 3D Slicer reads it: a string, told by its characters and a zero.
const char* field_data(Frame frame) {
  switch (frame) {
    case Frame::none:
      break;
    case Frame::lps:
      return "<FieldData>\n<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
             "format=\"ascii\">76 80 83 0</Array>\n</FieldData>\n";
    case Frame::ras:
      return "<FieldData>\n<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
             "format=\"ascii\">82 65 83 0</Array>\n</FieldData>\n";
  }
  return "";
}

}  // namespace

// The types of the arrays are those that VTK itself writes: some readers know no others.
void write_vtp(const Mesh& mesh, std::ostream& out) {
  out << "<?xml version=\"1.0\"?>\n<!-- " << header_text(mesh)
      << " -->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PolyData>\n"
      << field_data(mesh.frame) << "<Piece NumberOfPoints=\"" << mesh.vertices_mm.size()
      << "\" NumberOfPolys=\"" << mesh.face_count() << "\">\n";
  if (!mesh.normals.empty()) {
    out << "<PointData Normals=\"Normals\">\n";
    write_points("Name=\"Normals\"", mesh.normals, out);
    out << "</PointData>\n";
  }
  out << "<Points>\n";
  write_points("Name=\"Points\"", mesh.vertices_mm, out);
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
