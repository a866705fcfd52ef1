#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_files.hpp"
#include "writer.hpp"
#include "zip_file.hpp"

namespace discmc::host {
namespace {

constexpr const char* content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* relationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

// #RRGGBB
std::string hexadecimal(const Srgb& colour) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "#";
  for (const std::uint8_t part : colour) {
    text += digits[part / 16U];
    text += digits[part % 16U];
  }
  return text;
}

void write_model(const Mesh& mesh, std::ostream& out) {
  Writer writer(out);
  writer.text(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Application\">discmc</metadata>\n<metadata name=\"Description\">");
  writer.text(header_text(mesh));
  writer.text("</metadata>\n<resources>\n");
  if (mesh.colour)
    writer.text("<basematerials id=\"2\">\n<base name=\"label\" displaycolor=\"" +
                hexadecimal(*mesh.colour) + "\"/>\n</basematerials>\n");
  writer.text("<object id=\"1\" type=\"model\"");
  if (mesh.colour) writer.text(" pid=\"2\" pindex=\"0\"");
  writer.text(">\n<mesh>\n<vertices>\n");
  for (const Point& vertex : mesh.vertices_mm) {
    const char* before[] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      writer.text(before[axis]);
      writer.decimal(vertex[axis]);
    }
    writer.text("\"/>\n");
  }
  writer.text("</vertices>\n<triangles>\n");
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const char* before[] = {"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
    for (std::size_t i = 0; i < 3; ++i) {
      writer.text(before[i]);
      writer.decimal(mesh.face(face)[i]);
    }
    writer.text("\"/>\n");
  }
  writer.text(
      "</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"1\"/>\n</build>\n"
      "</model>\n");
  writer.finish();
}

}  // namespace

void write_3mf(const Mesh& mesh, std::ostream& out) {
  require_triangles(mesh, "3MF");
  constexpr std::uint64_t vertex_line = 100, triangle_line = 70, the_rest = 1000;  // at most
  ZipFile zip(out,
              vertex_line * mesh.vertices_mm.size() + triangle_line * mesh.face_count() + the_rest);
  zip.add("[Content_Types].xml", [](std::ostream& part) { part << content_types; });
  zip.add("_rels/.rels", [](std::ostream& part) { part << relationships; });
  zip.add("3D/3dmodel.model", [&mesh](std::ostream& part) { write_model(mesh, part); });
  zip.finish();
  Writer(out).finish();
}

}  // namespace discmc::host
