// discmc compare.

#include "command.hpp"

namespace {

using namespace command_tests;

// The three distances of each row by its name, "A to B, mm".
std::map<std::string, std::vector<double>> rows(const std::string& table) {
  std::map<std::string, std::vector<double>> result;
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);  // the names of the columns
  while (std::getline(lines, line)) {
    std::istringstream numbers(line.substr(22));
    std::vector<double>& row = result[line.substr(2, line.find("  ", 2) - 2)];
    for (double number; numbers >> number;) row.push_back(number);
  }
  return result;
}

// Two triangles at a height, as a mesh without further information.
std::string square(int height) {
  const std::string z = " " + std::to_string(height) + "\n";
  return "v 0 0" + z + "v 9 0" + z + "v 9 9" + z + "v 0 9" + z + "f 1 2 3\nf 1 3 4\n";
}

bool lacks_assimp(const Result& result) {
  const bool lacks = contains(result.error, "built without Assimp");
  if (lacks) MESSAGE("no Assimp: meshes are not compared");
  return lacks;
}

}  // namespace

TEST_CASE_FIXTURE(
    Workshop,
    "compare measures distances between a stream and its volume in millimetres and in voxels") {
  const auto ball = discmc::reference::ball({14, 14, 14}, {13, 13, 13}, 100);
  write("v.nrrd", ball, "spacings: 2 2 2\n");
  done("extract v.nrrd --iso 100 -q -o v.dmc");
  const auto distances = rows(done("compare v.dmc v.nrrd --iso 100"));
  REQUIRE(distances.size() == 4);
  for (const std::string way : {"A to B", "B to A"}) {
    const auto& in_mm = distances.at(way + ", mm");
    const auto& in_voxels = distances.at(way + ", voxels");
    REQUIRE(in_mm.size() == 3);
    REQUIRE(in_voxels.size() == 3);
    CHECK(in_mm[0] > 0);
    CHECK(in_mm[0] < in_mm[1]);
    CHECK(in_mm[1] <= in_mm[2]);
    CHECK(in_mm[2] < 1);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(in_mm[i] == doctest::Approx(2 * in_voxels[i]).epsilon(0.01));
  }
  for (const auto& [name, row] : rows(done("compare v.dmc v.dmc")))
    CHECK(row == std::vector<double>{0, 0, 0});
}

TEST_CASE_FIXTURE(Workshop, "compare measures distances between mesh files in millimetres") {
  write("low.obj", square(0));
  write("high.obj", square(3));
  const Result result = run("compare low.obj high.obj");
  if (lacks_assimp(result)) return;
  REQUIRE(result.code == 0);
  const auto distances = rows(result.out);
  REQUIRE(distances.size() == 2);
  for (const auto& [name, row] : distances) CHECK(row == std::vector<double>{3, 3, 3});
}

TEST_CASE_FIXTURE(Workshop, "compare reads meshes that discmc writes, unchanged") {
  const auto ball = discmc::reference::ball({9, 9, 9}, {8, 8, 8}, 40);
  write("v.nrrd", ball, "spacings: 1 1 2\n");
  done("extract v.nrrd --iso 100 -q -o v.dmc");
  for (const std::string name : {"v.ply", "v.obj", "v.stl", "v.glb", "v.3mf"}) {
    done("extract v.nrrd --iso 100 -q -o " + name);
    const Result result = run("compare " + name + " v.dmc");
    if (lacks_assimp(result)) return;
    REQUIRE(result.code == 0);
    for (const auto& [called, row] : rows(result.out)) CHECK(row == std::vector<double>{0, 0, 0});
  }
}

TEST_CASE_FIXTURE(Workshop, "inputs that cannot be compared are refused by name") {
  const auto ball = discmc::reference::ball({9, 9, 9}, {8, 8, 8}, 40);
  write("v.nrrd", ball);
  write("broken.obj", "v 0 0 0\nf 1 1");
  write("empty.stl", "");
  done("extract v.nrrd --iso 100 -q -o V.DMC");
  fails("compare V.DMC v.nrrd", 2, {"v.nrrd", "--iso"});
  fails("compare V.DMC v.nrrd --iso 300", 1, {"v.nrrd", "no voxel"});
  fails("compare V.DMC broken.obj", 1, {"broken.obj"});
  fails("compare V.DMC empty.stl", 1, {"empty.stl"});
  fails("compare V.DMC none.ply", 1, {"none.ply: there is no such file"});
  fails("compare V.DMC", 2, {"B"});
}

TEST_CASE_FIXTURE(
    Workshop, "a mesh without distances or in an unsupported format is refused before any output") {
  write("square.obj", square(0));
  write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  write("v.vtp", "<VTKFile type=\"PolyData\"/>");
  if (lacks_assimp(run("compare square.obj square.obj"))) return;
  for (const std::string inputs : {"square.obj line.obj", "line.obj square.obj"})
    fails("compare " + inputs, 1, {"line.obj: no triangle has an area", "give the mesh"});
  for (const std::string command : {"compare v.vtp square.obj", "render v.vtp -o v.png"})
    fails(command, 1, {"v.vtp", "export it as .ply or .stl"});
  for (const std::string command : {"info v.vtp", "decode v.vtp -o v.stl"})
    fails(command, 1, {"v.vtp: this is a mesh", ".stl, .ply"});
}

TEST_CASE_FIXTURE(Workshop, "a placed volume is compared at its position in space, like its mesh") {
  const auto ball = discmc::reference::ball({14, 14, 14}, {13, 13, 13}, 100);
  const auto distances_of = [&](const std::string& directions) {
    write("v.nrrd", ball,
          "space: left-posterior-superior\nspace directions: " + directions +
              "\nspace origin: (100,-50,7)\n");
    done("extract v.nrrd --iso 100 -q -o v.dmc");
    done("extract v.nrrd --iso 100 -q -o v.ply");
    return run("compare v.ply v.dmc");
  };
  const Result straight = distances_of("(2,0,0) (0,-2,0) (0,0,2)");
  if (lacks_assimp(straight)) return;
  CHECK(rows(straight.out).at("A to B, mm")[2] < 1e-3);
  CHECK(rows(straight.out).size() == 4);
  const Result turned = distances_of("(0,2,0) (-2,0,0) (0,0,2)");
  CHECK(rows(turned.out).at("B to A, mm")[2] < 1e-3);
  CHECK(rows(turned.out).size() == 2);
}
