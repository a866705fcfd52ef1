#include "mesh_files/mesh_files.hpp"

#include <stdexcept>
#include <streambuf>

#include "command.hpp"
#include "hand_made.hpp"
#include "meshes/placing.hpp"
#include "text/base64.hpp"
#include "text/name_text.hpp"

namespace {

using namespace command_tests;
using namespace discmc::command;
using namespace hand_made;

// A stream that accepts this many bytes, then fails.
class Full : public std::streambuf {
 public:
  explicit Full(std::streamsize room) : room_(room) {}

 protected:
  std::streamsize xsputn(const char*, std::streamsize count) override {
    const std::streamsize written = std::min(count, room_);
    room_ -= written;
    return written;
  }
  int_type overflow(int_type) override { return traits_type::eof(); }

 private:
  std::streamsize room_;
};

// A stream that buffers everything, then fails to write.
class Stuck : public std::streambuf {
 protected:
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
  int sync() override { return -1; }
};

const Format mesh_formats[] = {Format::stl, Format::ply,      Format::obj,
                               Format::glb, Format::three_mf, Format::vtp};

Point rounded(const Point& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])};
}

void check_same_faces(const FileMesh& read, const FileMesh& mesh) {
  CHECK(read.corners == mesh.corners);
  CHECK(read.face_begin == mesh.face_begin);
}

void check_ply(const FileMesh& mesh) {
  std::ostringstream out;
  write_ply(mesh, out);
  const std::string file = out.str(), faces = std::to_string(mesh.face_count());
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment discmc, millimetres" +
      std::string(20 - faces.size(), ' ') + "\nelement vertex " +
      std::to_string(mesh.vertices_mm.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
      "\nproperty list uchar int vertex_indices\nend_header\n";
  REQUIRE(file.substr(0, header.size()) == header);
  const FileMesh read = mesh_of_ply(file);
  REQUIRE(read.vertices_mm.size() == mesh.vertices_mm.size());
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    CHECK(read.vertices_mm[i] == rounded(mesh.vertices_mm[i]));
  check_same_faces(read, mesh);
}

}  // namespace

TEST_CASE("an OBJ file reads back exactly") {
  FileMesh scaled = build_mesh(leaning_wall());
  for (Point& vertex : scaled.vertices_mm) vertex[0] = vertex[0] / 3 - 1;
  std::ostringstream out;
  write_obj(scaled, out);

  const FileMesh read = mesh_of_obj(out.str());
  CHECK(read.vertices_mm == scaled.vertices_mm);
  check_same_faces(read, scaled);
}

TEST_CASE("a PLY file reads back exactly, with a byte as the count of corners") {
  check_ply(build_mesh(box_with_hole({0.3, 0.3, -1.5})));
  check_ply(build_mesh(saw(255)));
}

TEST_CASE("a mesh written in parts has the same bytes, faces and edges as written whole") {
  const VolumePlacement mirroring{
      discmc::Space::ras, {10, -20, 30}, {{{0, 0.3, 0}, {0.3, 0.1, 0}, {0, 0, 1.5}}}};
  Surface surface = box_with_hole({0.3, 0.3, -1.5});
  for (int i = 0; i < 3000; ++i) surface.polygons.append(octahedron().polygons);
  surface.polygons.append(polygon({0, 0, 1}, {{{0, 1, 0}, {9, 0, 0}}}));  // encloses nothing
  for (const unsigned jobs : {1U, 3U})
    for (const bool is_placed : {false, true})
      for (const Faces faces : {Faces::triangles, Faces::polygons}) {
        const auto finish = [&](FileMesh& mesh) {
          if (is_placed) place(mesh, mirroring);
          resize(mesh, {MeshUnit::micrometre, 0.001});
          mesh.colour = Srgb{1, 2, 3};
        };
        FileMesh mesh = build_mesh(surface, {true, faces});
        finish(mesh);
        const MeshParts parts(surface, {true, faces, nullptr, 0.05, jobs}, true, finish);
        CHECK(parts.vertex_count() == mesh.vertices_mm.size());
        const auto check = [&](Format format, auto write) {
          std::ostringstream whole, of_parts;
          write_mesh(mesh, format, whole);
          const MeshTotals totals = write(parts, of_parts);
          CHECK(of_parts.str() == whole.str());
          CHECK(totals.faces == mesh.face_count());
          CHECK((totals.edge_sum == 0) == is_closed(mesh));
          CHECK(totals.left_out == mesh.left_out);
        };
        check(Format::ply, [](auto&... given) { return write_ply(given...); });
        if (faces == Faces::triangles)
          check(Format::stl, [](auto&... given) { return write_stl(given...); });
      }
}

TEST_CASE("PLY refuses polygons with more corners than a byte can count") {
  FileMesh mesh = build_mesh(saw(255));
  mesh.corners.push_back(0);
  ++mesh.face_begin.back();
  std::ostringstream out;
  CHECK_THROWS_AS(write_ply(mesh, out), std::invalid_argument);
  CHECK(out.str().empty());
}

TEST_CASE("an STL file reads back, with unit normals that look outside") {
  for (const double z : {3.0, -3.0}) {
    const FileMesh mesh = build_mesh(octahedron({1, 2, z}), {true, Faces::triangles});
    std::ostringstream out;
    write_stl(mesh, out);
    const std::string file = out.str();
    REQUIRE(file.size() == 80 + 4 + 50 * mesh.face_count());
    CHECK(file.substr(0, 5) != "solid");
    Taker bytes(file, 80);
    CHECK(bytes.integer(4) == mesh.face_count());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      const Point normal = bytes.point();
      std::array<Point, 3> corner;
      for (Point& point : corner) point = bytes.point();
      CHECK(bytes.integer(2) == 0);
      // The octahedron is around the origin, so the right-hand rule can be tested.
      const Point area = cross(difference(corner[1], corner[0]), difference(corner[2], corner[0]));
      CHECK(dot(area, normal) > 0);
      CHECK(dot(corner[0], normal) ==
            doctest::Approx(1 / std::sqrt(1 / 0.25 + 1 / 1.0 + 1 / 2.25)));
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(corner[i] == rounded(mesh.vertices_mm[mesh.face(face)[i]]));
    }
    CHECK(bytes.at_end());
  }
}

TEST_CASE("every format but STL keeps vertices far from the origin separate and in place") {
  FileMesh mesh = build_mesh(pitted_block({{0, 0}, {2, 2}}), {true, Faces::triangles});
  place(mesh, {discmc::Space::lps, {5e6, -7e6, 6e6}, {{{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}}});
  mesh.spacing_mm = {0.1, 0.1, 0.1};
  for (const std::string name : {"v.obj", "v.3mf", "v.ply", "v.vtp", "v.glb"}) {
    INFO(name);
    std::ostringstream out;
    write_mesh(mesh, format_of(name), out);
    const FileMesh read = mesh_of(name, out.str());
    CHECK(read.corners == mesh.corners);
    if (name != "v.glb") CHECK(read.vertices_mm == mesh.vertices_mm);
    REQUIRE(read.vertices_mm.size() == mesh.vertices_mm.size());
    for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(std::fabs(read.vertices_mm[i][axis] - mesh.vertices_mm[i][axis]) < 1e-4);
  }
  std::ostringstream out;
  write_stl(mesh, out);
  const FileMesh read = mesh_of("v.stl", out.str());
  CHECK(read.vertices_mm.size() == count_float_places(mesh));
  CHECK(read.vertices_mm.size() < mesh.vertices_mm.size());
}

TEST_CASE("meshes of one GLB file keep positions far from each other") {
  FileMesh near = build_mesh(octahedron(), {true, Faces::triangles}), far = near;
  for (Point& vertex : far.vertices_mm) vertex[1] += 1e8;
  std::ostringstream out;
  write_glb({&near, &far}, out);
  const std::vector<FileMesh> read = meshes_of_glb(out.str());
  REQUIRE(read.size() == 2);
  const Point& last = read[1].vertices_mm.back();
  CHECK(last[1] == doctest::Approx(far.vertices_mm.back()[1]).epsilon(1e-12));
}

TEST_CASE("32-bit float coordinates suffice if their steps are small against the voxels") {
  FileMesh mesh = build_mesh(octahedron(), {true, Faces::triangles});
  mesh.spacing_mm = {-1, 2, 3};
  for (const float distance : {1.0F, 1000.0F, 32767.9F, 32768.0F, 1e6F}) {
    mesh.vertices_mm[0] = {0, -static_cast<double>(distance), 0};
    CHECK(float_step_mm(mesh) ==
          static_cast<double>(std::nextafter(distance, 2 * distance) - distance));
    CHECK(suits_floats(mesh) == (distance < 32768));
  }
  for (Point& vertex : mesh.vertices_mm) vertex[0] += 1e6;
  mesh.vertices_mm[0] = mesh.vertices_mm[1];
  CHECK(!suits_floats(mesh));
  CHECK(suits_floats(mesh, mesh.vertices_mm[0]));
  const FileMesh nothing;
  CHECK(suits_floats(nothing));
  CHECK(count_float_places(nothing) == 0);
}

TEST_CASE("mesh formats without polygons refuse faces other than triangles") {
  for (const Format format : mesh_formats) {
    if (traits_of(format).holds_polygons) continue;
    std::ostringstream out;
    CHECK_THROWS_AS(write_mesh(build_mesh(leaning_wall()), format, out), std::invalid_argument);
    CHECK(out.str().empty());
  }
  std::ostringstream out;
  for (const Format format : {Format::stream, Format::jsonl})
    CHECK_THROWS_AS(write_mesh(build_mesh(octahedron()), format, out), std::invalid_argument);
}

TEST_CASE("a vertex without a normal gets a default normal in GLB") {
  FileMesh mesh = build_mesh(octahedron(), {true, Faces::triangles});
  mesh.normals.assign(mesh.vertices_mm.size(), {1, 0, 0});
  mesh.normals[3] = {};
  std::ostringstream out;
  write_glb({&mesh}, out);
  const FileMesh read = mesh_of_glb(out.str());
  REQUIRE(read.normals.size() == mesh.normals.size());
  for (std::size_t i = 0; i < read.normals.size(); ++i)
    CHECK(read.normals[i][i == 3 ? 2 : 0] == doctest::Approx(1));
}

TEST_CASE("mesh formats with colours keep the colour of a mesh") {
  FileMesh mesh = build_mesh(octahedron(), {true, Faces::triangles});
  for (const std::string name : {"v.glb", "v.3mf", "v.ply", "v.vtp"}) {
    INFO(name);
    for (const Srgb& colour : {Srgb{0, 9, 10}, Srgb{255, 128, 160}}) {
      mesh.colour = colour;
      std::ostringstream out;
      write_mesh(mesh, format_of(name), out);
      const FileMesh read = mesh_of(name, out.str());
      CHECK(read.colour == colour);
      CHECK(read.face_count() == mesh.face_count());
    }
  }
}

TEST_CASE("mesh files have coordinates in the given scale and unit, and name the unit") {
  const FileMesh mesh = build_mesh(octahedron({1, 2, 3}), {true, Faces::triangles});
  struct Expected {
    MeshSize size;
    double factor;
    std::string name;
  };
  for (const auto& [size, factor, name] :
       {Expected{{}, 1, "millimetres"}, Expected{{MeshUnit::micrometre, 1}, 1000, "micrometres"},
        Expected{{MeshUnit::metre, 2}, 0.002, "metres"},
        Expected{{MeshUnit::inch, 0.5}, 0.5 / 25.4, "inches"}})
    for (const std::string file : {"v.stl", "v.ply", "v.obj", "v.3mf", "v.vtp"}) {
      FileMesh resized = mesh;
      resize(resized, size);
      std::ostringstream out;
      write_mesh(resized, format_of(file), out);
      const FileMesh read = mesh_of(file, out.str());
      CHECK(volume_of(read) == doctest::Approx(factor * factor * factor * volume_of(mesh)));
      if (file == "v.3mf")
        CHECK(read.unit == size.unit);
      else
        CHECK(out.str().find("discmc, " + name) != std::string::npos);
    }
}

TEST_CASE("base64 output conforms to RFC 4648 for bytes in portions of any size") {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"},
                                                         {"\xff\xfe\xfb", "//77"}};
  for (const auto& [bytes, expected] : vectors)
    for (const bool at_once : {true, false}) {
      std::ostringstream out;
      Base64 base64(out);
      std::ostream in(&base64);
      const std::string text = bytes;
      if (at_once) in << text;
      if (!at_once)
        for (const char byte : text) in.write(&byte, 1);
      base64.finish();
      CHECK(out.str() == expected);
    }
}

TEST_CASE("every mesh writer reports an output stream that fails, early or late") {
  const Surface surface = pitted_block({{0, 0}, {2, 2}});
  const FileMesh mesh = build_mesh(surface, {true, Faces::triangles});
  for (const std::streamsize room : {0, 1, 300}) {
    auto check_writer = [room](auto write) {
      Full full(room);
      std::ostream out(&full);
      CHECK_THROWS_AS(write(out), std::runtime_error);
      Stuck stuck;
      std::ostream late(&stuck);
      CHECK_THROWS_AS(write(late), std::runtime_error);
    };
    for (const Format format : mesh_formats)
      check_writer([&](std::ostream& out) { write_mesh(mesh, format, out); });
    check_writer([&](std::ostream& out) { write_jsonl(surface, out); });
  }
}

TEST_CASE("names of any bytes are written as valid text in JSON and XML") {
  CHECK(json_string("a\"b\\c\n\x7F") == "\"a\\\"b\\\\c\\u000a\\u007f\"");
  CHECK(xml_attribute("<a & \"b\">\t") == "&lt;a &amp; &quot;b&quot;&gt;\xEF\xBF\xBD");
  const std::string whole = "\xC3\xA4 \xE2\x82\xAC \xF0\x9D\x84\x9E";
  CHECK(xml_attribute(whole) == whole);
  CHECK(json_string(whole) == "\"" + whole + "\"");
  // Truncated; a continuation byte alone; too long; a surrogate; an invalid character; beyond the
  // last one; bytes that begin no character.
  for (const std::string bytes :
       {"\xC3", "\xA4", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xEF\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF8\x90\x80\x80", "\xFC\x90\x80\x80", "\xFF", "\xE2\x82"}) {
    std::string replaced;
    for (std::size_t i = 0; i < bytes.size(); ++i) replaced += "\xEF\xBF\xBD";
    CHECK(xml_attribute("<" + bytes + "x") == "&lt;" + replaced + "x");
    CHECK(xml_attribute(bytes) == replaced);
  }
}

TEST_CASE("a mesh file larger than the writer's buffer is written completely") {
  Surface surface{{2, 2, 2}, {}};
  for (int z = 0; z < 6000; z += 2)
    surface.polygons.append(polygon({1, 1, 1}, {{{1, 0, z}, {0, 1, z}, {0, 0, z + 1}}}));
  std::ostringstream out;
  write_stl(build_mesh(surface, {true, Faces::triangles}), out);
  CHECK(out.str().size() == 84 + 50 * 3000);
}
