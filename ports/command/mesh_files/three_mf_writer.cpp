#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_files.hpp"
#include "text/name_text.hpp"
#include "writer.hpp"
#include "zip_file.hpp"

namespace discmc::command {
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

// In the words of the format.
const char* unit_name(MeshUnit unit) {
  switch (unit) {
    case MeshUnit::millimetre:
      break;
    case MeshUnit::micrometre:
      return "micron";
    case MeshUnit::metre:
      return "meter";
    case MeshUnit::inch:
      return "inch";
  }
  return "millimeter";
}

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

// The names and colours of all meshes that have a colour.
void write_materials(const Meshes& meshes, const std::string& id, Writer& writer) {
  writer.text("<basematerials id=\"" + id + "\">\n");
  for (const FileMesh* mesh : meshes)
    if (mesh->colour)
      writer.text("<base name=\"" + (mesh->name.empty() ? "label" : xml_attribute(mesh->name)) +
                  "\" displaycolor=\"" + hexadecimal(*mesh->colour) + "\"/>\n");
  writer.text("</basematerials>\n");
}

void write_object(const FileMesh& mesh, const std::string& attributes, Writer& writer) {
  writer.text("<object" + attributes + ">\n<mesh>\n<vertices>\n");
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
  writer.text("</triangles>\n</mesh>\n</object>\n");
}

// Objects are numbered from 1 on; the materials come after them.
void write_model(const Meshes& meshes, std::ostream& out) {
  Writer writer(out);
  writer.text(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"");
  writer.text(unit_name(meshes.empty() ? MeshUnit::millimetre : meshes[0]->unit));
  writer.text(
      "\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Application\">discmc</metadata>\n<metadata name=\"Description\">");
  writer.text(meshes.empty() ? header_text({}) : header_text(*meshes[0]));
  writer.text("</metadata>\n<resources>\n");
  const std::string materials = std::to_string(meshes.size() + 1);
  if (std::any_of(meshes.begin(), meshes.end(),
                  [](const FileMesh* mesh) { return !!mesh->colour; }))
    write_materials(meshes, materials, writer);
  std::size_t number = 0, material = 0;
  std::string items;
  for (const FileMesh* mesh : meshes) {
    const std::string id = std::to_string(++number);
    std::string attributes = " id=\"" + id + "\" type=\"model\"";
    if (!mesh->name.empty()) attributes += " name=\"" + xml_attribute(mesh->name) + "\"";
    if (mesh->colour)
      attributes += " pid=\"" + materials + "\" pindex=\"" + std::to_string(material++) + "\"";
    write_object(*mesh, attributes, writer);
    items += "<item objectid=\"" + id + "\"/>\n";
  }
  writer.text("</resources>\n<build>\n" + items + "</build>\n</model>\n");
  writer.finish();
}

}  // namespace

void write_3mf(const Meshes& meshes, std::ostream& out) {
  constexpr std::uint64_t vertex_line = 100, triangle_line = 70, the_rest = 1000;  // at most
  constexpr std::uint64_t letter = 12;  // of a name, in both places, escaped
  std::uint64_t bytes = the_rest;
  const Meshes seen = with_faces(meshes);  // the format allows no object without triangles
  for (const FileMesh* mesh : seen) {
    require_triangles(*mesh, "3MF");
    bytes += vertex_line * mesh->vertices_mm.size() + triangle_line * mesh->face_count() +
             letter * mesh->name.size() + the_rest;
  }
  ZipFile zip(out, bytes);
  zip.add("[Content_Types].xml", [](std::ostream& part) { part << content_types; });
  zip.add("_rels/.rels", [](std::ostream& part) { part << relationships; });
  zip.add("3D/3dmodel.model", [&seen](std::ostream& part) { write_model(seen, part); });
  zip.finish();
  Writer(out).finish();
}

}  // namespace discmc::command
