#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh_files.hpp"
#include "meshes/measures.hpp"
#include "text/name_text.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

// A key and its number, if there is one.
using Field = std::pair<std::string, std::optional<std::string>>;

void add_point(std::vector<Field>& fields, const std::string& key, const std::optional<Point>& at) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.emplace_back(key + "_" + "xyz"[axis] + "_mm",
                        at ? std::optional(decimal((*at)[axis])) : std::nullopt);
}

std::vector<Field> fields_of(const FileMesh& mesh) {
  const Measures measures = measures_of(mesh);
  const auto enclosed = [&](auto member) -> std::optional<std::string> {
    if (!measures.enclosed) return std::nullopt;
    return decimal((*measures.enclosed).*member);
  };
  std::vector<Field> fields = {{"volume_mm3", enclosed(&Enclosed::volume_mm3)},
                               {"area_mm2", decimal(measures.area_mm2)},
                               {"bodies", enclosed(&Enclosed::bodies)},
                               {"cavities", enclosed(&Enclosed::cavities)}};
  const bool has_extent = mesh.face_count() > 0;
  add_point(fields, "min", has_extent ? std::optional(measures.min_mm) : std::nullopt);
  add_point(fields, "max", has_extent ? std::optional(measures.max_mm) : std::nullopt);
  add_point(
      fields, "centre",
      has_extent && measures.enclosed ? std::optional(measures.enclosed->centre_mm) : std::nullopt);
  fields.emplace_back("voxels",
                      mesh.voxels ? std::optional(std::to_string(*mesh.voxels)) : std::nullopt);
  return fields;
}

// Quotes the text if CSV requires this.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

void write_csv(const Meshes& meshes, std::ostream& out) {
  Writer writer(out);
  writer.text("name");
  for (const auto& [key, number] : fields_of({})) writer.text("," + key);
  writer.text("\n");
  for (const FileMesh* mesh : meshes) {
    writer.text(csv_text(mesh->name));
    for (const auto& [key, number] : fields_of(*mesh)) writer.text("," + number.value_or(""));
    writer.text("\n");
  }
  writer.finish();
}

void write_json(const Meshes& meshes, std::ostream& out) {
  Writer writer(out);
  std::string separator = "[\n";
  for (const FileMesh* mesh : meshes) {
    writer.text(separator + " {\"name\": " + json_string(mesh->name));
    for (const auto& [key, number] : fields_of(*mesh))
      writer.text(", \"" + key + "\": " + number.value_or("null"));
    writer.text("}");
    separator = ",\n";
  }
  writer.text(meshes.empty() ? "[]\n" : "\n]\n");
  writer.finish();
}

}  // namespace discmc::command
