// Meshes from files: every way in which the formats say the same, and what is no mesh.
#include "mesh_files/mesh_reader.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <sstream>
#include <stdexcept>

#include "hand_made.hpp"
#include "mesh_files/mesh_files.hpp"
#include "oracle/stream.hpp"
#include "volume_files.hpp"

namespace {

using namespace discmc::host;
using namespace hand_made;
using volume_files::Folder;

Mesh read(const Folder& folder, const std::string& name, const std::string& bytes) {
  return read_mesh(folder.write(name, bytes));
}

std::string written(void (*write)(const Mesh&, std::ostream&), const Mesh& mesh) {
  std::ostringstream out;
  write(mesh, out);
  return out.str();
}

void check_same(const Mesh& mesh, const Mesh& expected) {
  CHECK(mesh.vertices_mm == expected.vertices_mm);
  CHECK(mesh.corners == expected.corners);
  CHECK(mesh.face_begin == expected.face_begin);
  CHECK(mesh.polygons.size() == expected.face_count());
}

std::string refusal(const Folder& folder, const std::string& name, const std::string& bytes) {
  try {
    read(folder, name, bytes);
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    CHECK(text.find(name + ": ") != std::string::npos);
    CHECK(text.find("; ") != std::string::npos);  // the remedy
    return text;
  }
  FAIL("not refused: ", bytes);
  return {};
}

void check_refusal(const std::string& name, const std::string& bytes, const std::string& part) {
  const Folder folder;
  const std::string text = refusal(folder, name, bytes);
  INFO(text);
  CHECK(text.find(part) != std::string::npos);
}

// A tetrahedron's corner: three vertices, one of them with a normal of length 2, and a face.
const std::vector<Point> corner = {{0, 0, 0}, {1.5, 0, 0}, {0, -2, 0.25}};
const std::string corner_vertices = "0 0 0 0 0 2\n1.5 0 0 0 0 1\n0 -2 0.25 0 0 1\n";
const std::string ply_normals = "property float nx\nproperty float ny\nproperty float nz\n";
const std::string ply_position = "property float x\nproperty float y\nproperty float z\n";

std::string ply(const std::string& format, const std::string& vertex_properties,
                const std::string& list, const std::string& body, int faces = 1) {
  return "ply\nformat " + format + " 1.0\ncomment a corner\nelement vertex 3\n" +
         vertex_properties + "element face " + std::to_string(faces) + "\nproperty list " + list +
         "\nend_header\n" + body;
}

void check_corner(const Mesh& mesh) {
  CHECK(mesh.vertices_mm == corner);
  CHECK(mesh.corners == std::vector<std::uint32_t>{0, 1, 2});
  REQUIRE(mesh.face_count() == 1);
  CHECK(mesh.polygons == std::vector<std::uint32_t>{0});
}

template <typename Value>
std::string big_endian(std::initializer_list<Value> values) {
  std::string bytes;
  for (const Value value : values) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__) std::reverse(raw, raw + sizeof raw);
    bytes.append(raw, sizeof raw);
  }
  return bytes;
}

const std::string text_stl =
    "solid a corner\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1.5 0 0\n"
    "  vertex 0 -2e0 +0.25\n endloop\nendfacet\nendsolid a corner\n";

}  // namespace

TEST_CASE("what is written is read back, n-gons too") {
  const Folder folder;
  for (const Surface& surface : {octahedron(), box_with_hole(), leaning_wall(), saw()}) {
    const Mesh mesh = build_mesh(surface);
    check_same(read(folder, "m.obj", written(write_obj, mesh)), mesh);
    check_same(read(folder, "m.PLY", written(write_ply, mesh)), mesh);
    const Mesh triangles = build_mesh(surface, {true, Faces::triangles});
    const Mesh soup = read(folder, "m.stl", written(write_stl, triangles));
    REQUIRE(soup.corners.size() == triangles.corners.size());
    for (std::size_t i = 0; i < soup.corners.size(); ++i)
      CHECK(soup.vertices_mm[soup.corners[i]] == triangles.vertices_mm[triangles.corners[i]]);
  }
  const Mesh nothing = build_mesh({{1, 1, 1}, {}});
  CHECK(read(folder, "n.obj", written(write_obj, nothing)).face_count() == 0);
  CHECK(read(folder, "n.ply", written(write_ply, nothing)).face_count() == 0);
  CHECK(read(folder, "n.stl", written(write_stl, nothing)).face_count() == 0);
}

TEST_CASE("PLY files in text and of either byte order say the same") {
  const Folder folder;
  const std::string all = ply_position + ply_normals;
  const Mesh text = read(
      folder, "m.ply", ply("ascii", all, "uchar int vertex_indices", corner_vertices + "3 0 1 2"));
  check_corner(text);
  CHECK(text.normals == std::vector<Point>(3, Point{0, 0, 1}));
  const std::string big = big_endian<float>({0, 0, 0, 1.5F, 0, 0, 0, -2, 0.25F}) +
                          big_endian<std::uint16_t>({3}) + big_endian<std::int16_t>({0, 1, 2});
  const Mesh binary = read(
      folder, "m.ply", ply("binary_big_endian", ply_position, "ushort short vertex_index", big));
  check_corner(binary);
  CHECK(binary.normals.empty());
}

TEST_CASE("what a PLY file holds besides is passed over") {
  const Folder folder;
  const std::string text =
      "ply\r\nformat ascii 1.0\r\nelement nothing 99999999999\r\nelement material 2\r\n"
      "property list uchar double weights\r\nproperty char c\r\nelement vertex 3\r\n"
      "property uchar red\r\nproperty double z\r\nproperty double y\r\nproperty double x\r\n"
      "element face 2\r\nproperty list uchar float texcoord\r\nproperty int flags\r\n"
      "property list uchar uint vertex_indices\r\nend_header\r\n"
      "2 0.5 1e-3 7\r\n0 -1\r\n255 0 0 0\r\n0 0 0 1.5\r\n9 0.25 -2 0\r\n"
      "4 1 2 3 4 0 3 0 1 2\r\n0 0 2 0 1\r\n";
  check_corner(read(folder, "m.ply", text));  // the second face has two corners
}

TEST_CASE("an OBJ file may name vertices in four ways, from either end") {
  const Folder folder;
  const std::string vertices = "# a corner\nv 0 0 0 1\nv 1.5 0 0\nv 0 -2 0.25\nvt 0 0\n";
  for (const std::string face : {"f 1 2 3", "f 1/1 2/1 3/1", "f -3 -2 -1", "g a\ns 1\nf 1/1 2 -1"})
    check_corner(read(folder, "m.obj", vertices + face + "\n"));
  check_corner(read(folder, "m.obj", "f 1 2 3\n" + vertices));
  const std::string normals = "vn 0 0 3\nvn 1 0 0\n";
  for (const std::string face : {"f 1//1 2//1 3//2", "f 1/1/1 2/1/1 3/1/-1"}) {
    const Mesh mesh = read(folder, "m.obj", vertices + normals + face);
    check_corner(mesh);
    CHECK(mesh.normals == std::vector<Point>{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}});
  }
}

TEST_CASE("a vertex with several normals becomes several vertices") {
  const Folder folder;
  const Mesh mesh = read(folder, "m.obj",
                         "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 0 1 0\n"
                         "f 1//1 2//1 3//1\nf 1//2 4//2 2//2\nf 1//1 3//1 4\n");
  CHECK(mesh.vertices_mm.size() == 3 + 3 + 1);
  REQUIRE(mesh.normals.size() == mesh.vertices_mm.size());
  CHECK(mesh.vertices_mm[mesh.face(1)[0]] == Point{0, 0, 0});
  CHECK(mesh.normals[mesh.face(0)[0]] == Point{0, 0, 1});
  CHECK(mesh.normals[mesh.face(1)[0]] == Point{0, 1, 0});
  CHECK(mesh.face(2)[0] == mesh.face(0)[0]);
  CHECK(mesh.normals[mesh.face(2)[2]] == Point{});  // has none
}

TEST_CASE("STL files in text are read, and binary ones that begin as text does") {
  const Folder folder;
  check_corner(read(folder, "m.stl", text_stl));
  const Mesh triangles = build_mesh(octahedron(), {true, Faces::triangles});
  std::string binary = written(write_stl, triangles);
  binary.replace(0, 6, "solid ");
  CHECK(read(folder, "m.STL", binary).face_count() == 8);
}

TEST_CASE("what is no mesh is refused by its name, with the fault and a remedy") {
  const Folder folder;
  const auto missing = folder.path() / "none.ply";
  CHECK_THROWS_WITH_AS(read_mesh(missing), doctest::Contains("none.ply: cannot be read"),
                       std::runtime_error);
  std::filesystem::create_directory(folder.path() / "f.stl");
  CHECK_THROWS_WITH_AS(read_mesh(folder.path() / "f.stl"), doctest::Contains("cannot be read"),
                       std::runtime_error);

  const std::string list = "uchar int vertex_indices";
  const auto text = [&list](const std::string& body) {
    return ply("ascii", ply_position, list, body);
  };
  check_refusal("m.ply", "", "its first line is not \"ply\"");
  check_refusal("m.ply", "ply\nformat ascii 1.0\n", "does not end");
  check_refusal("m.ply", "ply\nformat ebcdic 1.0\nend_header\n", "'format ebcdic 1.0'");
  check_refusal("m.ply", "ply\nelement vertex -1\nend_header\n", "'element vertex -1'");
  check_refusal("m.ply", "ply\nproperty float x\nend_header\n", "'property float x'");
  check_refusal("m.ply", "ply\nelement v 1\nproperty half x\nend_header\n", "'property half x'");
  check_refusal("m.ply", "ply\nformat ascii 1.0\nend_header\n", "without faces");
  check_refusal("m.ply", ply("ascii", "property float x\n", list, "1 2 3 3 0 1 2"),
                "without x, y and z");
  check_refusal("m.ply", text("0 0 0 1 0 0 0 1 0 3 0 1"), "ends before");
  check_refusal("m.ply", text("0 0 0 1 0 zero 0 1 0 3 0 1 2"), "'zero' is no number");
  check_refusal("m.ply", text("0 0 0 1 0 nan 0 1 0 3 0 1 2"), "vertex 2 has a coordinate");
  check_refusal("m.ply", text("0 0 0 1 0 2e30 0 1 0 3 0 1 2"), "vertex 2 has a coordinate");
  check_refusal("m.ply", text("0 0 0 1 0 0 0 1 0 3 0 1 3"), "vertex 4, and there are 3");
  check_refusal("m.ply", text("0 0 0 1 0 0 0 1 0 3 0 1 -1"), "and there are 3");

  check_refusal("m.obj", "v 0 0\n", "line 1: v has not three numbers");
  check_refusal("m.obj", "v 0 0 0\nf 1 x 1\n", "line 2: 'x'");
  check_refusal("m.obj", "v 0 0 0\nf 0 1 1\n", "line 2: '0'");
  check_refusal("m.obj", "v 0 0 0\nf 1 -2 1\n", "line 2: '-2'");
  check_refusal("m.obj", "v 0 0 0\nf 1 1 2\n", "vertex 2, and there are 1");
  check_refusal("m.obj", "v 0 0 inf\nf 1 1 1\n", "no number");

  check_refusal("m.stl", "", "too short");
  check_refusal("m.stl", std::string(100, 'x'), "bytes, and this one 100");
  check_refusal("m.stl", text_stl.substr(0, text_stl.size() - 20), "endsolid");
  check_refusal("m.stl", "solid\nvertex 1 2\n", "'vertex 1 2'");
  check_refusal("m.stl", "solid\nvertex 0 0 0\nendloop\nendsolid\n", "a facet of 1 corners");
}

TEST_CASE("a file that promises more than it has is refused before anything is reserved for it") {
  check_refusal("m.ply",
                ply("binary_little_endian", ply_position, "uint int vertex_indices",
                    std::string(36, '\0') + "\xFF\xFF\xFF\xFF"),
                "ends before");
  check_refusal("m.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\n" +
                    ply_position + "end_header\n",
                "ends before");
  check_refusal("m.stl", std::string(80, ' ') + "\xFF\xFF\xFF\xFF", "bytes, and this one 84");
}

TEST_CASE("damaged files end in a mesh or in a refusal") {
  const Mesh mesh = build_mesh(leaning_wall());
  const Mesh triangles = build_mesh(leaning_wall(), {true, Faces::triangles});
  const std::string text = ply("ascii", ply_position + ply_normals, "uchar int vertex_indices",
                               corner_vertices + "3 0 1 2");
  const std::pair<std::string, std::string> files[] = {{"m.ply", written(write_ply, mesh)},
                                                       {"m.ply", text},
                                                       {"m.obj", written(write_obj, mesh)},
                                                       {"m.stl", written(write_stl, triangles)},
                                                       {"m.stl", text_stl}};
  const Folder folder;
  discmc::test::Chance chance(7);
  int meshes = 0, refusals = 0;
  for (const auto& [name, whole] : files)
    for (int round = 0; round < 200; ++round) {
      std::string damaged = whole;
      const auto place = [&] { return chance.below(static_cast<std::uint32_t>(damaged.size())); };
      if (round % 4 == 0) damaged.resize(place());
      for (int i = 0; i < round % 4; ++i) damaged[place()] = static_cast<char>(chance.byte());
      try {
        const Mesh read_back = read(folder, name, damaged);
        for (const std::uint32_t number : read_back.corners)
          REQUIRE(number < read_back.vertices_mm.size());
        CHECK(read_back.polygons.size() == read_back.face_count());
        CHECK((read_back.normals.empty() ||
               read_back.normals.size() == read_back.vertices_mm.size()));
        ++meshes;
      } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find(name + ": ") != std::string::npos);
        ++refusals;
      }
    }
  CHECK(meshes > 100);
  CHECK(refusals > 100);
}
