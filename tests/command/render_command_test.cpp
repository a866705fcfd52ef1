// discmc render: streams, volumes, and conflicting options.
#include "command.hpp"

namespace {

using namespace command_tests;
using discmc::reference::ball;

const std::string raw_layout = " --dims 20,20,20 --type u8 --spacing 0.5,-1,2";
const std::string small = " --size 60,50";

// v.nrrd and v.raw contain the same volume, v.dmc its stream.
struct Volumes : Workshop {
  Volumes() {
    const BitVolume volume = ball({20, 20, 20}, {19, 19, 15}, 100);
    write("v.nrrd", volume, "space dimension: 3\nspace directions: (0.5,0,0) (0,-1,0) (0,0,2)\n");
    std::string samples;
    for (const std::uint8_t on : volume.on) samples += static_cast<char>(on != 0 ? 200 : 10);
    write("v.raw", samples);
    done("extract v.nrrd --iso 100 -o v.dmc");
  }
  std::string picture(const std::string& arguments) const {
    const std::string bytes = done("render " + arguments + small + " -o -");
    CHECK(bytes.substr(1, 3) == "PNG");
    return bytes;
  }
};

}  // namespace

TEST_CASE_FIXTURE(Volumes, "render draws a volume like its stream with normals") {
  done("extract v.nrrd --iso 100 --normals gradient -o normals.dmc");
  for (const std::string look : {"", " --shade smooth", " --shade smooth --edges", " --edges"}) {
    INFO(look);
    const std::string expected = picture("normals.dmc" + look);
    CHECK(picture("v.nrrd --iso 100" + look) == expected);
    CHECK(picture("v.raw --iso 100" + raw_layout + look) == expected);
  }
  CHECK(picture("v.nrrd --iso 100 --border open") != picture("v.dmc"));
  const std::string outlined = picture("v.dmc --edges");
  CHECK(picture("v.nrrd --iso 100 --memory 1500 --edges") == outlined);
  CHECK(picture("v.nrrd --iso 100 --capacities 20,0 --edges") == outlined);
}

TEST_CASE_FIXTURE(
    Volumes,
    "without a known extension, render reads a volume if --iso is given, otherwise a stream") {
  shell("cp v.raw samples; cp v.nrrd headed; cp v.dmc stream");
  const std::string expected = picture("v.dmc");
  CHECK(picture("samples --iso 100" + raw_layout) == expected);
  CHECK(picture("headed --iso 100") == expected);
  CHECK(picture("stream") == expected);
}

TEST_CASE_FIXTURE(Volumes, "render notes a picture that shows no part of the surface") {
  const std::string note = "p.png: no part of the surface is in the picture; change --at or --zoom";
  CHECK(contains(run("render v.dmc --at 900,0,0 --zoom 9 -o p.png").error, note));
  CHECK(!contains(run("render v.dmc -o p.png").error, note));
  CHECK(contains(run("render v.dmc --at 900,0,0 --zoom 9 -o -").error,
                 "standard output: no part of the surface"));
}

TEST_CASE_FIXTURE(Volumes,
                  "render --classic draws the classic Marching Cubes mesh, equally for a file and "
                  "its raw samples") {
  const std::string classic = picture("v.nrrd --iso 100 --classic");
  CHECK(classic != picture("v.nrrd --iso 100"));
  CHECK(classic != picture("v.nrrd --iso 100 --classic --shade smooth"));
  CHECK(classic != picture("v.nrrd --iso 150 --classic"));  // where samples cross
  CHECK(classic == picture("v.raw --iso 100 --classic" + raw_layout));
}

TEST_CASE_FIXTURE(Volumes,
                  "render draws no voxels above a range or label, in flat and smooth shading") {
  std::string one, both;
  for (int i = 0; i < 12 * 12 * 12; ++i) {
    const int x = i % 12, y = i / 12 % 12, z = i / 144;
    const bool is_in_box = y > 2 && y < 9 && z > 2 && z < 9;
    one += is_in_box && x > 1 && x < 6 ? '\3' : '\0';
    both += is_in_box && x > 7 && x < 10 ? '\5' : one.back();
  }
  write("one.raw", one);
  write("both.raw", both);
  const std::string layout = " --dims 12,12,12 --type u8";
  for (const std::string select : {" --label 3", " --range 1..4"})
    for (const std::string look : {"", " --shade smooth"})
      CHECK(picture("both.raw" + layout + select + look) ==
            picture("one.raw" + layout + select + look));
  fails("render one.raw --label 3 --classic -o v.png" + layout, 2, {"--classic", "--label"});
}

TEST_CASE_FIXTURE(Volumes, "render --zoom enlarges the picture, and --at selects the place shown") {
  const std::string whole = picture("v.dmc");
  CHECK(picture("v.dmc --zoom 1") == whole);
  const std::string near = picture("v.dmc --zoom 3");
  CHECK(near != whole);
  CHECK(picture("v.dmc --zoom 3 --at 7,-9,20") != near);
  fails("render v.dmc -o o.png --view 0,0,1 --at 0,0,1e6", 1, {"behind the viewer"});
}

TEST_CASE_FIXTURE(Volumes, "wrong usage of render is reported, and no picture is written") {
  const std::pair<std::string, std::string> wrong[] = {
      {"v.nrrd", "v.nrrd: a volume needs a threshold; give --iso"},
      {"v.raw" + raw_layout, "give --iso"},
      {"v.dmc --iso 100", "--iso: applies to volumes, and v.dmc is a stream"},
      {"v.dmc --memory 64K", "--memory: applies to volumes"},
      {"v.dmc --capacities 9,9", "--capacities: applies to volumes"},
      {"v.dmc --border open", "--border: applies to volumes"},
      {"v.dmc --classic", "--classic: applies to volumes"},
      {"v.nrrd --iso 100 --classic --memory 1M", "--memory"},
      {"v.nrrd --iso 100 --classic --capacities 9,9", "--capacities"},
      {"v.raw --iso 100 --dims 20,20,20", "--type"},
      {"v.nrrd --iso much", "much"},
      {"v.dmc --shade phong", "phong"},
      {"v.dmc --shade", "--shade"},
      {"v.dmc --zoom 0", "--zoom"},
      {"v.dmc --zoom 1001", "--zoom"},
      {"v.dmc --zoom nan", "--zoom"},
      {"v.dmc --view 0,0,0", "--view"},
      {"v.dmc --size 0,5", "--size"},
      {"v.dmc --size 5,8193", "--size"},
      {"v.dmc --at 1,2", "--at"},
      {"v.dmc --at 1,2,nan", "nan"}};
  for (const auto& [input, part] : wrong) fails("render " + input + " -o o.png", 2, {part});
  for (const std::string braces : {"{name}", "{n}", "{}"})
    for (const std::string command : {"render v.nrrd --iso 100 -o 'a", "decode v.dmc -o 'a"})
      fails(command + braces + (command[0] == 'r' ? ".png'" : ".stl'"), 2,
            {"--output: ", braces + " is no placeholder here"});
}

TEST_CASE_FIXTURE(Volumes,
                  "render draws a mesh file written by extract like the surface of its stream") {
  if (contains(run("compare v.dmc none.stl").error, "without Assimp")) return;
  const std::string expected = picture("v.dmc");
  for (const std::string name : {"v.stl", "v.ply", "v.obj"}) {
    INFO(name);
    done("extract v.nrrd --iso 100 --space voxel -o " + name);
    CHECK(picture(name) == expected);
    CHECK(picture(name + " --edges") != expected);
    CHECK(picture(name + " --shade smooth") != expected);
  }
  for (const std::string option : {"--iso 100", "--largest 1", "--scan 1", "--crop 1..2,..,.."})
    fails("render v.stl " + option + " -o v.png", 2, {"v.stl is a mesh"});
}

TEST_CASE_FIXTURE(Volumes, "render --labels draws each label in its own colour") {
  const std::string both = picture("v.nrrd --labels all");
  CHECK(picture("v.nrrd --labels 10,200") == both);
  CHECK(picture("v.nrrd --labels 200") != picture("v.nrrd --label 200"));
  CHECK(picture("v.nrrd --labels 200 --shade smooth --edges") != both);
  fails("render v.nrrd --labels 7 -o v.png", 1, {"no voxel has label 7"});
  fails("render v.dmc --labels all -o v.png", 2, {"is a stream"});
}

TEST_CASE_FIXTURE(Volumes, "render --label-table names and colours the labels") {
  write("t.txt", "10 air 0 0 255\n200 bone 255 0 0\n");
  const std::string table = " --label-table t.txt";
  const std::string named = picture("v.nrrd --labels bone" + table);
  CHECK(picture("v.nrrd --labels 200" + table) == named);
  CHECK(picture("v.nrrd --labels 200") != named);
  CHECK(picture("v.nrrd --label bone" + table) == picture("v.nrrd --label 200"));
  fails("render v.nrrd --iso 100 -o v.png" + table, 2,
        {"--label-table", "add --label N or --labels all"});
}

TEST_CASE_FIXTURE(Volumes, "render draws a mesh file in its own colours") {
  if (contains(run("compare v.dmc none.stl").error, "without Assimp")) return;
  const std::string both = picture("v.nrrd --labels all");
  for (const std::string format : {"glb", "3mf"}) {
    INFO(format);
    done("extract v.nrrd --labels all --space voxel -q -o v." + format);
    CHECK(picture("v." + format) == both);
  }
  const std::string one = picture("v.nrrd --labels 200");
  for (const std::string format : {"glb", "3mf", "obj", "ply"}) {
    INFO(format);
    done("extract v.nrrd --labels 200 --space voxel -q -o '{name}." + format + "'");
    CHECK(picture("200." + format) == one);
  }
}

TEST_CASE_FIXTURE(Volumes, "render refuses a mesh on standard input with the remedy") {
  done("extract v.nrrd --iso 100 -o v.stl");
  for (const std::string command : {"render - -o v.png", "view - -o v.html"}) {
    check_failure(
        shell("\"$discmc\" " + command + " < v.stl"), 1,
        {"discmc: standard input: there is no header", "a mesh is read from a file only: save it"});
  }
}
