#include "mesh_formats.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "command.hpp"

namespace command_tests {
namespace {

using Json = nlohmann::json;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  return Taker(bytes, at).integer(4);
}

// ---- GLB ----

class Glb {
 public:
  explicit Glb(const std::string& bytes) {
    REQUIRE(bytes.substr(0, 4) == "glTF");
    CHECK(word(bytes, 4) == 2);
    CHECK(word(bytes, 8) == bytes.size());
    CHECK(bytes.size() % 4 == 0);
    const std::uint32_t json_size = word(bytes, 12);
    CHECK(bytes.substr(16, 4) == "JSON");
    json_ = Json::parse(bytes.substr(20, json_size));
    CHECK(json_["asset"]["version"] == "2.0");
    const std::size_t binary = 20 + json_size;
    if (binary == bytes.size()) return;
    CHECK(bytes.substr(binary + 4, 4) == std::string("BIN\0", 4));
    binary_ = bytes.substr(binary + 8);
    CHECK(word(bytes, binary) == binary_.size());
    CHECK(json_["buffers"][0]["byteLength"] == binary_.size());
  }

  const Json& json() const { return json_; }

  std::vector<Point> points(const Json& accessor_number) const {
    const Json& accessor = json_["accessors"].at(accessor_number.get<std::size_t>());
    CHECK(accessor["componentType"] == 5126);
    CHECK(accessor["type"] == "VEC3");
    Taker taker = bytes_of(accessor, 12);
    std::vector<Point> points(accessor["count"].get<std::size_t>());
    for (Point& point : points) point = taker.point();
    return points;
  }

  std::vector<std::uint32_t> integers(const Json& accessor_number) const {
    const Json& accessor = json_["accessors"].at(accessor_number.get<std::size_t>());
    CHECK(accessor["componentType"] == 5125);
    CHECK(accessor["type"] == "SCALAR");
    Taker taker = bytes_of(accessor, 4);
    std::vector<std::uint32_t> integers(accessor["count"].get<std::size_t>());
    for (std::uint32_t& integer : integers) integer = taker.integer(4);
    return integers;
  }

 private:
  Taker bytes_of(const Json& accessor, std::size_t size) const {
    const Json& view = json_["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    CHECK(view["byteLength"] == size * accessor["count"].get<std::size_t>());
    return Taker(binary_, view["byteOffset"].get<std::size_t>());
  }

  Json json_;
  std::string binary_;
};

void check_extent(const Json& accessor, const std::vector<Point>& points) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    CHECK(accessor["min"][axis] == (*low)[axis]);
    CHECK(accessor["max"][axis] == (*high)[axis]);
  }
}

// By a matrix, column by column as in the format.
Point transformed(const Json& matrix, const Point& point, double w) {
  Point result{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      result[row] += matrix[4 * column + row].get<double>() * (column < 3 ? point[column] : w);
  return result;
}

// From metres, y upwards, to millimetres, z upwards.
Point in_millimetres(const Point& metres) {
  return {1000 * metres[0], -1000 * metres[2], 1000 * metres[1]};
}

// ---- ZIP and XML ----

std::map<std::string, std::string> files_in(const std::string& zip) {
  std::map<std::string, std::string> files;
  const std::unique_ptr<archive, int (*)(archive*)> reader(archive_read_new(), archive_read_free);
  archive_read_support_format_zip(reader.get());
  REQUIRE(archive_read_open_memory(reader.get(), zip.data(), zip.size()) == ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(reader.get(), &entry) == ARCHIVE_OK) {
    std::string& file = files[archive_entry_pathname(entry)];
    char part[4096];
    la_ssize_t count = 0;
    while ((count = archive_read_data(reader.get(), part, sizeof part)) > 0)
      file.append(part, static_cast<std::size_t>(count));
    CHECK(count == 0);
  }
  CHECK(archive_read_has_encrypted_entries(reader.get()) <= 0);
  return files;
}

pugi::xml_document document_of(const std::string& xml) {
  pugi::xml_document document;
  REQUIRE(document.load_string(xml.c_str()));
  return document;
}

std::string decoded(const std::string& base64) {
  const std::string characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  REQUIRE(base64.size() % 4 == 0);
  std::string bytes;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < base64.size(); ++i) {
    const std::size_t place = characters.find(base64[i]);
    if (base64[i] != '=') REQUIRE(place != std::string::npos);
    bits = bits << 6 | (base64[i] == '=' ? 0 : static_cast<std::uint32_t>(place));
    if (i % 4 != 3) continue;
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(bits >> shift & 0xFF);
  }
  bytes.resize(bytes.size() -
               static_cast<std::size_t>(std::count(base64.begin(), base64.end(), '=')));
  return bytes;
}

// The type of an array with this name.
std::string type_of(const pugi::xml_node& parent, const char* name) {
  return parent.find_child_by_attribute("DataArray", "Name", name).attribute("type").value();
}

// The values of the array with this name, without the checked number of bytes before them.
std::string array_of(const pugi::xml_node& parent, const char* name) {
  const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
  CHECK(array.attribute("format").value() == std::string("binary"));
  const std::string bytes = decoded(array.text().get());
  REQUIRE(bytes.size() >= 8);
  CHECK(word(bytes, 0) == bytes.size() - 8);
  CHECK(word(bytes, 4) == 0);
  return bytes.substr(8);
}

std::vector<Point> points_of(const pugi::xml_node& parent, const char* name) {
  const std::string bytes = array_of(parent, name);
  const bool has_doubles = type_of(parent, name) == "Float64";
  if (!has_doubles) CHECK(type_of(parent, name) == "Float32");
  std::vector<Point> points(bytes.size() / (has_doubles ? 24 : 12));
  Taker taker(bytes);
  for (Point& point : points) point = has_doubles ? taker.point_of_doubles() : taker.point();
  CHECK(taker.at_end());
  return points;
}

std::vector<std::uint32_t> integers_of(const pugi::xml_node& parent, const char* name) {
  CHECK(type_of(parent, name) == "Int64");
  const std::string bytes = array_of(parent, name);
  std::vector<std::uint32_t> integers;
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    integers.push_back(word(bytes, at));
    CHECK(word(bytes, at + 4) == 0);
  }
  return integers;
}

// The same value at every point.
discmc::command::Srgb colour_of(const pugi::xml_node& parent, const char* name) {
  CHECK(type_of(parent, name) == "UInt8");
  const std::string bytes = array_of(parent, name);
  REQUIRE(bytes.size() >= 3);
  for (std::size_t at = 3; at < bytes.size(); ++at) CHECK(bytes[at] == bytes[at - 3]);
  return {static_cast<std::uint8_t>(bytes[0]), static_cast<std::uint8_t>(bytes[1]),
          static_cast<std::uint8_t>(bytes[2])};
}

discmc::command::MeshUnit unit_of(const std::string& name) {
  using discmc::command::MeshUnit;
  const std::map<std::string, MeshUnit> units = {{"micron", MeshUnit::micrometre},
                                                 {"millimeter", MeshUnit::millimetre},
                                                 {"meter", MeshUnit::metre},
                                                 {"inch", MeshUnit::inch}};
  REQUIRE(units.count(name) == 1);
  return units.at(name);
}

// From linear light, as in the format.
discmc::command::Srgb srgb_of(const Json& factor) {
  discmc::command::Srgb colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const double light = factor.at(i).get<double>();
    const double part =
        light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    colour[i] = static_cast<std::uint8_t>(std::lround(255 * part));
  }
  return colour;
}

FileMesh mesh_of_node(const Glb& glb, const Json& node) {
  const Json& json = glb.json();
  FileMesh mesh;
  mesh.name = node.value("name", "");
  const Json& parts = json["meshes"].at(node["mesh"].get<std::size_t>());
  CHECK(parts.value("name", "") == mesh.name);
  const Json& primitive = parts["primitives"].at(0);
  const Json& material = json["materials"].at(primitive["material"].get<std::size_t>());
  mesh.colour = srgb_of(material["pbrMetallicRoughness"]["baseColorFactor"]);
  const Json& attributes = primitive["attributes"];
  const std::vector<Point> positions = glb.points(attributes["POSITION"]);
  check_extent(json["accessors"].at(attributes["POSITION"].get<std::size_t>()), positions);
  for (const Point& position : positions)
    mesh.vertices_mm.push_back(in_millimetres(transformed(node["matrix"], position, 1)));
  if (attributes.contains("NORMAL"))
    for (const Point& normal : glb.points(attributes["NORMAL"]))
      mesh.normals.push_back(in_millimetres(transformed(node["matrix"], normal, 0)));
  const std::vector<std::uint32_t> corners = glb.integers(primitive["indices"]);
  CHECK(corners.size() % 3 == 0);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    add_face(mesh, {corners[i], corners[i + 1], corners[i + 2]});
  return mesh;
}

FileMesh mesh_of_object(const pugi::xml_node& resources, const pugi::xml_node& object) {
  FileMesh mesh;
  mesh.name = object.attribute("name").value();
  if (const pugi::xml_attribute group = object.attribute("pid")) {
    auto base =
        resources.find_child_by_attribute("basematerials", "id", group.value()).first_child();
    for (unsigned left = object.attribute("pindex").as_uint(); left > 0; --left)
      base = base.next_sibling();
    const std::string colour = base.attribute("displaycolor").value();
    REQUIRE(colour.size() == 7);
    mesh.colour.emplace();
    for (std::size_t i = 0; i < 3; ++i)
      (*mesh.colour)[i] =
          static_cast<std::uint8_t>(std::stoul(colour.substr(1 + 2 * i, 2), nullptr, 16));
  }
  for (const auto& vertex : object.child("mesh").child("vertices"))
    mesh.vertices_mm.push_back({vertex.attribute("x").as_double(),
                                vertex.attribute("y").as_double(),
                                vertex.attribute("z").as_double()});
  for (const auto& triangle : object.child("mesh").child("triangles"))
    add_face(mesh, {triangle.attribute("v1").as_uint(), triangle.attribute("v2").as_uint(),
                    triangle.attribute("v3").as_uint()});
  return mesh;
}

// An empty surface has none.
FileMesh only_mesh(const std::vector<FileMesh>& meshes) {
  CHECK(meshes.size() <= 1);
  return meshes.empty() ? FileMesh{} : meshes[0];
}

}  // namespace

std::vector<FileMesh> meshes_of_glb(const std::string& bytes) {
  const Glb glb(bytes);
  const Json& json = glb.json();
  const Json& scene = json["scenes"].at(json["scene"].get<std::size_t>());
  std::vector<FileMesh> meshes;
  for (const Json& number : scene.value("nodes", Json::array()))
    meshes.push_back(mesh_of_node(glb, json["nodes"].at(number.get<std::size_t>())));
  return meshes;
}

FileMesh mesh_of_glb(const std::string& bytes) {
  return only_mesh(meshes_of_glb(bytes));
}

std::vector<FileMesh> meshes_of_3mf(const std::string& bytes) {
  CHECK(Taker(bytes, 4).integer(2) <= 20);  // the release of ZIP that a reader must support: 2.0
  const auto files = files_in(bytes);
  REQUIRE(files.count("[Content_Types].xml") == 1);
  REQUIRE(files.count("_rels/.rels") == 1);
  const auto relationships = document_of(files.at("_rels/.rels"));
  const std::string target =
      relationships.child("Relationships").child("Relationship").attribute("Target").value();
  REQUIRE(files.count(target.substr(1)) == 1);
  const auto types = document_of(files.at("[Content_Types].xml"));
  for (const char* extension : {"rels", "model"})
    CHECK(types.child("Types").find_child_by_attribute("Default", "Extension", extension));

  const auto document = document_of(files.at(target.substr(1)));
  const pugi::xml_node model = document.child("model");
  const pugi::xml_node resources = model.child("resources");
  std::vector<FileMesh> meshes;
  for (const auto& item : model.child("build")) {
    const pugi::xml_node object =
        resources.find_child_by_attribute("object", "id", item.attribute("objectid").value());
    REQUIRE(object);
    meshes.push_back(mesh_of_object(resources, object));
    meshes.back().unit = unit_of(model.attribute("unit").value());
  }
  return meshes;
}

FileMesh mesh_of_3mf(const std::string& bytes) {
  return only_mesh(meshes_of_3mf(bytes));
}

FileMesh mesh_of_vtp(const std::string& bytes) {
  const auto document = document_of(bytes);
  const pugi::xml_node file = document.child("VTKFile");
  CHECK(file.attribute("type").value() == std::string("PolyData"));
  CHECK(file.attribute("byte_order").value() == std::string("LittleEndian"));
  CHECK(file.attribute("header_type").value() == std::string("UInt64"));
  const pugi::xml_node piece = file.child("PolyData").child("Piece");
  FileMesh mesh;
  mesh.vertices_mm = points_of(piece.child("Points"), "Points");
  CHECK(piece.attribute("NumberOfPoints").as_uint() == mesh.vertices_mm.size());
  const pugi::xml_node data = piece.child("PointData");
  if (data.attribute("Normals")) mesh.normals = points_of(data, data.attribute("Normals").value());
  if (data.attribute("Scalars")) mesh.colour = colour_of(data, data.attribute("Scalars").value());
  const auto connectivity = integers_of(piece.child("Polys"), "connectivity");
  std::uint32_t begin = 0;
  for (const std::uint32_t end : integers_of(piece.child("Polys"), "offsets")) {
    REQUIRE(begin <= end);
    REQUIRE(end <= connectivity.size());
    add_face(mesh, {connectivity.begin() + begin, connectivity.begin() + end});
    begin = end;
  }
  CHECK(begin == connectivity.size());
  CHECK(piece.attribute("NumberOfPolys").as_uint() == mesh.face_count());
  return mesh;
}

}  // namespace command_tests
