#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "file_mesh.hpp"
#include "mesh_files.hpp"
#include "text/name_text.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

// Constants of glTF.
constexpr std::uint32_t magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr int floats = 5126, unsigned_integers = 5125, vertex_buffer = 34962, index_buffer = 34963;

constexpr Point plaster = {0.85, 0.82, 0.75};

std::string decimals(const Point& point) {
  return decimal(point[0]) + "," + decimal(point[1]) + "," + decimal(point[2]);
}

// Returns a matrix by columns, as glTF requires. It converts millimetres with z upwards, relative
// to an origin, to metres with y upwards.
std::string matrix_from(const Point& origin) {
  constexpr double metres = 0.001;
  const Point moved = {metres * origin[0], metres * origin[2], metres * (0 - origin[1])};
  return "[0.001,0,0,0,0,0,-0.001,0,0,0.001,0,0," + decimals(moved) + ",1]";
}

// Converts to linear light, which glTF uses.
Point linear(const Srgb& colour) {
  Point light;
  std::transform(colour.begin(), colour.end(), light.begin(),
                 [](std::uint8_t part) { return decoded_light(part / 255.0); });
  return light;
}

// Returns a member of a JSON object that has further members, or an empty string if the mesh has no
// name.
std::string name_member(const FileMesh& mesh) {
  return mesh.name.empty() ? "" : "\"name\":" + json_string(mesh.name) + ",";
}

// The material is visible from both sides, because a surface may be open.
std::string material(const FileMesh& mesh) {
  const Point colour = mesh.colour ? linear(*mesh.colour) : plaster;
  return "{" + name_member(mesh) +
         R"("doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[)" + decimals(colour) +
         R"(,1],"metallicFactor":0,"roughnessFactor":0.8}})";
}

// Returns the "min" and "max" of the written positions, which glTF requires.
std::string extent_of(const std::vector<Point>& points, const Point& origin) {
  Point low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const Point& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double written = static_cast<double>(static_cast<float>(point[axis] - origin[axis]));
      low[axis] = std::min(low[axis], written);
      high[axis] = std::max(high[axis], written);
    }
  return ",\"min\":[" + decimals(low) + "],\"max\":[" + decimals(high) + "]";
}

// The arrays of the binary chunk, and their description in JSON.
class Arrays {
 public:
  // Returns the index of the array.
  std::string add(int type, const char* shape, std::uint64_t count, std::uint64_t bytes, int target,
                  const std::string& more = {}) {
    std::string number = std::to_string(count_++);
    const char* comma = number == "0" ? "" : ",";
    accessors_ += comma + ("{\"bufferView\":" + number + ",\"componentType\":") +
                  std::to_string(type) + ",\"count\":" + std::to_string(count) + ",\"type\":\"" +
                  shape + "\"" + more + "}";
    views_ += comma + ("{\"buffer\":0,\"byteOffset\":" + std::to_string(bytes_)) +
              ",\"byteLength\":" + std::to_string(bytes) + ",\"target\":" + std::to_string(target) +
              "}";
    bytes_ += bytes;
    return number;
  }

  std::uint64_t bytes() const { return bytes_; }
  std::string json() const {
    return "\"accessors\":[" + accessors_ + "],\"bufferViews\":[" + views_ +
           "],\"buffers\":[{\"byteLength\":" + std::to_string(bytes_) + "}]";
  }

 private:
  int count_ = 0;
  std::uint64_t bytes_ = 0;
  std::string accessors_, views_;
};

std::string primitive(const FileMesh& mesh, const Point& origin, const std::string& material_number,
                      Arrays& arrays) {
  const std::uint64_t vertices = mesh.vertices_mm.size(), corners = mesh.corners.size();
  std::string attributes =
      "\"POSITION\":" + arrays.add(floats, "VEC3", vertices, 12 * vertices, vertex_buffer,
                                   extent_of(mesh.vertices_mm, origin));
  if (!mesh.normals.empty())
    attributes +=
        ",\"NORMAL\":" + arrays.add(floats, "VEC3", vertices, 12 * vertices, vertex_buffer);
  const std::string indices =
      arrays.add(unsigned_integers, "SCALAR", corners, 4 * corners, index_buffer);
  return "{\"attributes\":{" + attributes + "},\"indices\":" + indices +
         ",\"material\":" + material_number + "}";
}

// meshes: each has faces.
std::string describe(const Meshes& meshes, const Point& origin, Arrays& arrays) {
  std::string json = R"({"asset":{"version":"2.0","generator":"discmc"},"scene":0,"scenes":[{)";
  if (meshes.empty()) return json + "}]}";
  std::string numbers, nodes, descriptions, materials;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const FileMesh& mesh = *meshes[i];
    const std::string comma = i == 0 ? "" : ",";
    const std::string number = std::to_string(i);
    numbers += comma + number;
    nodes += comma + "{" + name_member(mesh) + "\"mesh\":" + number +
             ",\"matrix\":" + matrix_from(origin) + "}";
    descriptions += comma + "{" + name_member(mesh) + "\"extras\":{\"comment\":\"";
    descriptions += header_text(mesh);
    descriptions += "\"},\"primitives\":[" + primitive(mesh, origin, number, arrays) + "]}";
    materials += comma + material(mesh);
  }
  return json + "\"nodes\":[" + numbers + "]}],\"nodes\":[" + nodes + "],\"meshes\":[" +
         descriptions + "],\"materials\":[" + materials + "]," + arrays.json() + "}";
}

void write_arrays(const FileMesh& mesh, const Point& origin, Writer& writer) {
  for (const Point& vertex : mesh.vertices_mm) writer.floats(difference(vertex, origin));
  // glTF also requires a normal for every vertex.
  for (const Point& normal : mesh.normals)
    writer.floats(normal == Point{} ? Point{0, 0, 1} : normal);
  for (const std::uint32_t corner : mesh.corners) writer.bytes(corner, 4);
}

}  // namespace

Point glb_origin(const Meshes& meshes) {
  if (std::all_of(meshes.begin(), meshes.end(),
                  [](const FileMesh* mesh) { return suits_floats(*mesh); }))
    return {};
  return meshes[0]->vertices_mm[0];
}

void write_glb(const Meshes& meshes, std::ostream& out) {
  const Meshes nonempty = with_faces(meshes);  // glTF allows no empty arrays
  for (const FileMesh* mesh : nonempty) require_triangles(*mesh, "GLB");
  Arrays arrays;
  const Point origin = glb_origin(nonempty);
  std::string json = describe(nonempty, origin, arrays);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::uint64_t binary = arrays.bytes() > 0 ? 8 + arrays.bytes() : 0;
  const std::uint64_t total = 12 + 8 + json.size() + binary;
  if (total > 0xFFFFFFFFu)
    throw std::invalid_argument("a GLB file holds at most 4 GiB; write .ply or .stl");
  Writer writer(out);
  writer.bytes(magic, 4);
  writer.bytes(2, 4);
  writer.bytes(total, 4);
  writer.bytes(json.size(), 4);
  writer.bytes(json_chunk, 4);
  writer.text(json);
  if (binary > 0) {
    writer.bytes(arrays.bytes(), 4);
    writer.bytes(binary_chunk, 4);
    for (const FileMesh* mesh : nonempty) write_arrays(*mesh, origin, writer);
  }
  writer.finish();
}

}  // namespace discmc::command
