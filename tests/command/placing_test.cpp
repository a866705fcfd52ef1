// Meshes have the positions of their volumes in the patient's space, for each kind of placement.
#include <discmc/placement.hpp>

#include "command.hpp"
#include "oracle/stream.hpp"

namespace {

using namespace command_tests;
using discmc::Space;
using discmc::meshing::dot;

using Vertices = std::vector<Point>;

// Volumes of NiBabel with one voxel, and the vertices of that voxel: placed/make.py. In RAS.
struct Placed {
  std::string name;
  double determinant;
  Vertices vertices;
};
const std::vector<Placed> placed = {{"sform.nii",
                                     -1.4,
                                     {{92.274649, -129.142605, -67.884442},
                                      {91.906070, -129.734767, -67.825326},
                                      {92.341362, -129.620183, -68.107977},
                                      {91.839357, -129.257188, -67.601791},
                                      {91.448690, -129.142927, -68.893001},
                                      {92.732029, -129.734445, -66.816767}}},
                                    {"qform.nii",
                                     -0.75,
                                     {{-33.333766, 15.513275, 695.800071},
                                      {-33.070495, 15.936247, 695.757846},
                                      {-33.045254, 15.611325, 695.620775},
                                      {-33.359007, 15.838197, 695.937142},
                                      {-32.341766, 15.304511, 696.933585},
                                      {-34.062495, 16.145011, 694.624332}}}};

Vertices in_lps(Vertices vertices) {
  for (Point& vertex : vertices) vertex = {-vertex[0], -vertex[1], vertex[2]};
  return vertices;
}

// In any order.
void check_vertices(const FileMesh& mesh, const Vertices& expected) {
  constexpr double rounding_mm = 1e-4;  // of 32 bits near 700
  REQUIRE(mesh.vertices_mm.size() == expected.size());
  for (const Point& vertex : expected)
    CHECK(std::any_of(mesh.vertices_mm.begin(), mesh.vertices_mm.end(), [&](const Point& found) {
      const Point apart = discmc::meshing::difference(found, vertex);
      return dot(apart, apart) < rounding_mm * rounding_mm;
    }));
}

// The volume of an octahedron between the ends of half axes, if it faces outwards.
void check_closed(const FileMesh& mesh, double determinant) {
  CHECK(check_mesh(mesh).is_closed());
  CHECK(volume_of(mesh) == doctest::Approx(std::fabs(determinant) / 6).epsilon(1e-3));
}

void copy_placed(const Workshop& workshop, const std::string& name) {
  workshop.write(name, contents(DISCMC_SOURCE_DIR "/tests/command/placed/" + name));
}

// The stream of one voxel with a spacing of 1 mm and a placement.
std::string stream_with(const discmc::Placement& placement) {
  discmc::test::Line line;
  discmc::Encoder encoder;
  const auto volume = discmc::reference::from_bits({1, 1, 1}, 1);
  discmc::reference::require_ok(
      discmc::test::begin_stream(encoder, discmc::test::header_of(volume), line.output()));
  std::uint8_t bytes[discmc::Placement::record_bytes];
  discmc::reference::require_ok(encoder.write_record(discmc::record_of(placement, bytes)));
  discmc::test::encode_all(encoder, discmc::test::events_of(volume));
  return std::string(line.bytes.begin(), line.bytes.end());
}

}  // namespace

TEST_CASE_FIXTURE(Workshop,
                  "a mesh of a placed NIfTI volume lies at the position that NiBabel computes") {
  for (const Placed& volume : placed) {
    copy_placed(*this, volume.name);
    for (const std::string name : {"v.obj", "v.ply", "v.stl"}) {
      INFO(volume.name, " as ", name);
      done("extract " + volume.name + " --iso 500 -q -o " + name);
      check_vertices(mesh_in(name), in_lps(volume.vertices));
      check_closed(mesh_in(name), volume.determinant);
      CHECK(contains(read(name).substr(0, 120), "SPACE=LPS"));
      done("extract " + volume.name + " --iso 500 --space ras -q -o " + name);
      check_vertices(mesh_in(name), volume.vertices);
      check_closed(mesh_in(name), volume.determinant);
      CHECK(contains(read(name).substr(0, 120), "SPACE=RAS"));
    }
  }
}

TEST_CASE_FIXTURE(
    Workshop,
    "streams of regions and of slices carry the placement to decoded meshes and streams") {
  for (const Placed& volume : placed)
    for (const std::string wire : {"regions", "slices"}) {
      INFO(volume.name, " by ", wire);
      copy_placed(*this, volume.name);
      done("extract " + volume.name + " --iso 500 --wire " + wire + " -o v.dmc");
      done("decode v.dmc -o again.dmc");
      for (const std::string stream : {"v.dmc", "again.dmc"}) {
        done("decode " + stream + " -o v.obj");
        check_vertices(mesh_in("v.obj"), in_lps(volume.vertices));
        check_closed(mesh_in("v.obj"), volume.determinant);
        done("decode " + stream + " --space ras -o v.obj");
        check_vertices(mesh_in("v.obj"), volume.vertices);
      }
    }
}

TEST_CASE_FIXTURE(
    Workshop, "every surface of a stream with several surfaces has the placement of the volume") {
  for (const std::string wire : {"regions", "slices"}) {
    INFO(wire);
    copy_placed(*this, placed[0].name);
    done("extract sform.nii --iso 400 --iso 500 --wire " + wire + " -o v.dmc");
    for (const std::string channel : {"0", "1"}) {
      done("decode v.dmc --stream-channel " + channel + " -o v.obj");
      check_vertices(mesh_in("v.obj"), in_lps(placed[0].vertices));
    }
  }
}

TEST_CASE_FIXTURE(Workshop, "with --space voxel, mesh vertices are at index times spacing") {
  write("v.nrrd", discmc::reference::from_bits({1, 1, 1}, 1),
        "space: LPS\nspace origin: (10,20,30)\n"
        "space directions: (0,2,0) (-3,0,0) (0,0,4)\n");
  const Vertices at_voxels = {{-1, 0, 0},  {1, 0, 0},  {0, -1.5, 0},
                              {0, 1.5, 0}, {0, 0, -2}, {0, 0, 2}};
  Vertices in_space;
  for (const Point& v : at_voxels) in_space.push_back({10 - v[1], 20 + v[0], 30 + v[2]});
  done("extract v.nrrd --iso 100 --space voxel -o v.ply");
  check_vertices(mesh_in("v.ply"), at_voxels);
  CHECK_FALSE(contains(read("v.ply"), "SPACE"));
  for (const std::string name : {"v.ply", "v.3mf", "v.glb", "v.vtp"}) {
    done("extract v.nrrd --iso 100 -o " + name);
    check_vertices(mesh_in(name), in_space);
  }
  // How VTK writes LPS.
  CHECK(contains(read("v.vtp"),
                 "Name=\"SPACE\" NumberOfTuples=\"1\" "
                 "format=\"ascii\">76 80 83 0<"));
  done("extract v.nrrd --iso 100 -o v.dmc");
  done("decode v.dmc --space voxel -o v.ply");
  check_vertices(mesh_in("v.ply"), at_voxels);
}

TEST_CASE_FIXTURE(Workshop,
                  "a volume in scanner space keeps its placement, and --space is refused") {
  write("v.nrrd", discmc::reference::from_bits({1, 1, 1}, 1),
        "space dimension: 3\nspace origin: (10,20,30)\n"
        "space directions: (2,0,0) (0,2,0) (0,0,2)\n");
  done("extract v.nrrd --iso 100 -o v.ply");
  check_vertices(
      mesh_in("v.ply"),
      {{9, 20, 30}, {11, 20, 30}, {10, 19, 30}, {10, 21, 30}, {10, 20, 29}, {10, 20, 31}});
  CHECK_FALSE(contains(read("v.ply"), "SPACE"));
  done("extract v.nrrd --iso 100 -o v.dmc");
  for (const std::string command : {"extract v.nrrd --iso 100", "decode v.dmc"})
    fails(command + " --space lps -o v.ply", 1, {"has no patient orientation; leave out --space"});
  for (const std::string output : {"v2.dmc", "v.jsonl"})
    CHECK(run("extract v.nrrd --iso 100 --space voxel -o " + output).code == 2);
}

TEST_CASE_FIXTURE(Workshop, "info prints the placement") {
  write("v.nrrd", discmc::reference::from_bits({1, 1, 1}, 1),
        "space: LAS\nspace origin: (10,-20.125,30)\n"
        "space directions: (0,2,0) (-3,0,0) (0,0,0.4)\n");
  done("extract v.nrrd --iso 100 -o v.dmc");
  auto info = info_of("v.dmc");
  CHECK(info["space"] == "ras");
  CHECK(info["origin"] == "-10 -20.125 30");
  CHECK(info["axis_x"] == "0 2 0");
  CHECK(info["axis_y"] == "3 0 0");
  CHECK(info["axis_z"] == "0 0 0.4");
  write("v.nrrd", discmc::reference::from_bits({1, 1, 1}, 1), "spacings: 0.5 -2 3\n");
  done("extract v.nrrd --iso 100 -o v.dmc");
  info = info_of("v.dmc");
  CHECK(info["space"] == "voxel");
  CHECK(info["origin"] == "0 0 0");
  CHECK(info["axis_y"] == "0 -2 0");
  CHECK(info.count("record") == 0);
}

TEST_CASE_FIXTURE(Workshop, "faces look outside if the placement of a stream mirrors its axes") {
  discmc::Placement placement;
  placement.space = Space::lps;
  placement.axes_nm[0][1] = placement.axes_nm[1][0] = placement.axes_nm[2][2] = 1000000;
  placement.origin_nm[2] = 5000000;
  write("v.dmc", stream_with(placement));
  done("decode v.dmc --normals surface -o v.obj");
  const FileMesh mesh = mesh_in("v.obj");
  check_closed(mesh, -1);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    CHECK(dot(mesh.normals[i], discmc::meshing::difference(mesh.vertices_mm[i], {0, 0, 5})) ==
          doctest::Approx(0.5));
}

TEST_CASE_FIXTURE(Workshop, "a degenerate placement in a stream is ignored with a note") {
  write("v.dmc", stream_with({}));
  check_parts(run("decode v.dmc -o v.obj"), 0, {"v.dmc: the placement in the stream is ignored"});
  check_vertices(mesh_in("v.obj"),
                 {{-0.5, 0, 0}, {0.5, 0, 0}, {0, -0.5, 0}, {0, 0.5, 0}, {0, 0, -0.5}, {0, 0, 0.5}});
}
