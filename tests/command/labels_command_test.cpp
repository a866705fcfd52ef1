// discmc extract --labels all, and tables of labels.
#include <doctest/doctest.h>

#include <string>

#include "command.hpp"

namespace {

using command_tests::check_failure;
using command_tests::contains;
using command_tests::mesh_of_ply;
using command_tests::Workshop;

const std::string extract = "extract v.raw --dims 4,2,3 --type u8 --spacing 1,1,1 ";

// A body of 1, one of 2 in two places, and a voxel of 9.
const std::string volume("\1\1\0\2\1\1\0\0\1\1\0\0\0\0\0\0\0\0\x9\2\0\0\0\2", 24);

}  // namespace

TEST_CASE("all labels are as many meshes, as if each were asked for alone") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  REQUIRE(workshop.shell("mkdir out").code == 0);
  const std::string told = workshop.done(extract + "--labels all -o 'out/{name}.stl'");
  for (const std::string label : {"1", "2", "9"}) {
    CHECK(contains(told, "  out/" + label + ".stl\n"));
    workshop.done(extract + "--label " + label + " -o alone.stl");
    CHECK(workshop.read("out/" + label + ".stl") == workshop.read("alone.stl"));
  }
  CHECK(workshop.shell("ls out").out == "1.stl\n2.stl\n9.stl\n");
  CHECK(contains(told, "       2             3"));
  CHECK(workshop.done(extract + "--labels all -q -o '{name}.stl'").empty());
}

TEST_CASE("a table names the meshes of labels") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  workshop.write("table.txt", "0 Background 0 0 0\n1 bone 1 2 3\n2 skin 4 5 6\n9 bone 7 8 9\n");
  workshop.done(extract + "--labels all --label-table table.txt -o '{name}.ply'");
  workshop.done(extract +
                "--label 9 --label 7 --allow-empty --label-table table.txt -o 'one-{name}.ply'");
  CHECK(workshop.read("bone-9.ply") == workshop.read("one-bone.ply"));
  CHECK_FALSE(workshop.read("one-7.ply").empty());
  CHECK(mesh_of_ply(workshop.read("bone.ply")).colour == discmc::command::Srgb{1, 2, 3});
  CHECK(mesh_of_ply(workshop.read("skin.ply")).colour == discmc::command::Srgb{4, 5, 6});
}

TEST_CASE("segments of 3D Slicer name the meshes of labels where no table is given") {
  const Workshop workshop;
  workshop.write("v.seg.nrrd",
                 "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 2 3\nencoding: raw\n"
                 "Segment0_Color:=0.5 1 0\nSegment0_ID:=a\nSegment0_LabelValue:=2\n"
                 "Segment0_Name:=left lung/top\nSegment10_LabelValue:=1\nSegment10_Name:=bone\n"
                 "Segment10_Color:=1 2 3\nSegmentation_MasterRepresentation:=Binary labelmap\n"
                 "Segment1_LabelValue:=none\nSegment1_Name:=lost\n\n" +
                     volume);
  workshop.done("extract v.seg.nrrd --labels all -o '{name}.ply'");
  const auto colour = [&](const std::string& name) {
    return mesh_of_ply(workshop.read(name)).colour;
  };
  CHECK(colour("left lung_top.ply") == discmc::command::Srgb{128, 255, 0});
  CHECK_FALSE(workshop.read("bone.ply").empty());
  CHECK(colour("bone.ply") == colour("9.ply"));
  workshop.write("table.txt", "1 tibia 1 2 3\n");
  workshop.done("extract v.seg.nrrd --labels all --label-table table.txt -o 'own-{name}.ply'");
  CHECK_FALSE(workshop.read("own-tibia.ply").empty());
  CHECK_FALSE(workshop.read("own-2.ply").empty());
}

TEST_CASE("a label of several segments has the name of its layer, or none where that is open") {
  const Workshop workshop;
  const std::string keys =
      "Segment0_Layer:=0\nSegment0_Name:=Bone\nSegment0_LabelValue:=1\n"
      "Segment1_Layer:=1\nSegment1_Name:=Skin\nSegment1_LabelValue:=1\n"
      "Segment2_Layer:=0\nSegment2_Name:=Teeth\nSegment2_LabelValue:=2\n\n";
  const std::string head = "NRRD0005\ntype: uchar\nencoding: raw\n";
  workshop.write("layers.seg.nrrd",
                 head + "dimension: 4\nsizes: 4 2 3 2\n" + keys + volume + volume);
  const auto layer = [&](const std::string& number) {
    return workshop.done("extract layers.seg.nrrd --labels all --frame " + number + " -o 'layer" +
                         number + "-{name}.stl'");
  };
  CHECK(contains(layer("0"), "layer0-Bone.stl"));
  CHECK(contains(layer("1"), "layer1-Skin.stl"));
  workshop.write("one.seg.nrrd", head + "dimension: 3\nsizes: 4 2 3\n" + keys + volume);
  const auto one = workshop.run("extract one.seg.nrrd --labels all -o 'one-{name}.stl'");
  CHECK(contains(one.out, "one-1.stl"));
  CHECK(contains(one.out, "one-Teeth.stl"));
  CHECK(contains(one.error, "left without a name: 1, such as label 1 of 'Bone' and 'Skin'"));
}

TEST_CASE("a file of a format that holds several has all meshes, with their names and colours") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  workshop.write("table.txt", "1 a<&\xC3\xA4\xFF 1 2 3\n2 skin 4 5 6\n9 skin 7 8 9\n");
  const std::string options = " --label-table table.txt ";
  workshop.done(extract + "--labels all -o '{name}.ply'");
  const auto meshes_in = [&](const std::string& file) {
    const std::string bytes = workshop.read(file);
    return contains(file, ".glb") ? command_tests::meshes_of_glb(bytes)
                                  : command_tests::meshes_of_3mf(bytes);
  };
  for (const std::string file : {"all.glb", "all.3mf"}) {
    INFO(file);
    const std::string told = workshop.done(extract + "--labels all" + options + "-o " + file);
    CHECK(contains(told, "  skin\n"));
    CHECK(contains(told, file + ": "));
    const auto all = meshes_in(file);
    REQUIRE(all.size() == 3);
    const std::string labels[] = {"1", "2", "9"};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto alone = mesh_of_ply(workshop.read(labels[i] + ".ply"));
      CHECK(all[i].corners == alone.corners);
      REQUIRE(all[i].vertices_mm.size() == alone.vertices_mm.size());
      for (std::size_t v = 0; v < alone.vertices_mm.size(); ++v)
        for (std::size_t axis = 0; axis < 3; ++axis)
          CHECK(all[i].vertices_mm[v][axis] == doctest::Approx(alone.vertices_mm[v][axis]));
    }
    CHECK(all[0].name == "a<&\xC3\xA4\xEF\xBF\xBD");
    CHECK(all[2].name == "skin");
    CHECK(all[0].colour == discmc::command::Srgb{1, 2, 3});
    CHECK(all[2].colour == discmc::command::Srgb{7, 8, 9});

    workshop.done(extract + "--label 2 --label 9 -o " + file);
    const auto two = meshes_in(file);
    REQUIRE(two.size() == 2);
    CHECK(two[0].name == "2");
    CHECK(two[1].corners == all[2].corners);

    const auto result = workshop.run(extract + "--labels all --median 3 -q -o " + file);
    CHECK(contains(result.error, "label 9 has no surface left, so it is not in " + file));
    CHECK(meshes_in(file).size() == 1);
    check_failure(workshop.run(extract + "--labels all -q --min-volume 99 -o no" + file), 1,
                  {"no label has a surface left, so no" + file + " is not written"});
    CHECK(workshop.read("no" + file).empty());
  }
  for (const std::string file : {"all.stl", "all.ply", "all.obj", "all.vtp", "all.jsonl"})
    check_failure(workshop.run(extract + "--label 2 --label 9 -o " + file), 2,
                  {"--output", "{name}", ".glb or .3mf"});
}

TEST_CASE("a label without a surface is told, and has no file unless that is allowed") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  for (const std::string cleaning : {"--median 3", "--min-volume 4"}) {
    INFO(cleaning);
    const auto result = workshop.run(extract + "--labels all " + cleaning + " -q -o '{name}.stl'");
    CHECK(result.code == 0);
    CHECK(contains(result.error, "label 9 has no surface left, so 9.stl is not written"));
    CHECK(workshop.read("9.stl").empty());
  }
  workshop.done(extract + "--labels all --median 3 --allow-empty -q -o '{name}.stl'");
  CHECK_FALSE(workshop.read("9.stl").empty());
}

TEST_CASE("objects without triangles are in no file that holds several") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  for (const std::string file : {"all.glb", "all.3mf"}) {
    INFO(file);
    workshop.done(extract + "--labels all --min-volume 1 --allow-empty -q -o " + file);
    const std::string bytes = workshop.read(file);
    const auto left = file == "all.glb" ? command_tests::meshes_of_glb(bytes)
                                        : command_tests::meshes_of_3mf(bytes);
    REQUIRE(left.size() == 1);
    CHECK(left[0].name == "1");
  }
}

TEST_CASE("what a choice takes from a label is said with its name") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  workshop.write("table.txt", "1 bone 1 2 3\n2 skin 4 5 6\n");
  const std::string named = extract + "--label-table table.txt -q -o v.glb --largest 1 ";
  CHECK(workshop.run(named + "--labels all").error ==
        "discmc: v.raw: label 2 (skin): 1 of 2 bodies and cavities kept\n");
  CHECK(workshop.run(named + "--label 1 --label 2").error ==
        "discmc: v.raw: skin: 1 of 2 bodies and cavities kept\n");
}

TEST_CASE("control characters of names are not printed") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  workshop.write("table.txt", "1 \x1b[31mred 1 2 3\n2 bell\a 4 5 6\n");
  for (const std::string labels : {"--labels all", "--label 1 --label 2"})
    for (const std::string file : {"v.glb", "v.3mf", "'{name}.stl'"}) {
      const auto result =
          workshop.run(extract + labels + " --label-table table.txt --largest 1 -o " + file);
      CHECK(contains(result.out, "_[31mred"));
      CHECK(contains(result.error, "bell_"));
      for (const std::string control : {"\x1b", "\a"})
        CHECK_FALSE(contains(result.out + result.error, control));
    }
}

TEST_CASE("names too long for a file are cut, and stay apart") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  std::string whole;
  for (int i = 0; i < 50; ++i) whole += "\xC3\xA4";
  const std::string name = whole + whole + whole;  // 300 bytes
  workshop.write("table.txt",
                 "1 " + name + "1 1 2 3\n2 " + name + "2 4 5 6\n9 x" + name + " 1 1 1\n");
  workshop.done(extract + "--labels all --label-table table.txt -q -o 'v-{name}.stl'");
  for (const std::string& file : {whole, whole + "-2", "x" + whole.substr(2)}) {
    INFO(file);
    CHECK_FALSE(workshop.read("v-" + file + ".stl").empty());
  }
}

TEST_CASE("labels that cannot be written are refused before any work") {
  const Workshop workshop;
  workshop.write("v.raw", volume);
  workshop.write("table.txt", "no table\n");
  workshop.write("nothing.raw", std::string(24, '\0'));
  workshop.write("half.raw", std::string(96, '\x3f'));  // 0.747...
  std::string nan;
  for (int i = 0; i < 24; ++i) nan += std::string("\0\0\xc0\x7f", 4);
  workshop.write("nan.raw", nan);
  workshop.write("nothing.nrrd",
                 "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 2 3\nencoding: raw\n\n" +
                     std::string(24, '\0'));
  const auto names = workshop.names();
  const std::string all = extract + "--labels all ";
  check_failure(workshop.run(all + "-o v.stl"), 2, {"--labels", "{name}", ".glb or .3mf"});
  check_failure(workshop.run(all + "-o '{name}.dmc'"), 2, {"--labels", "4 surfaces", "meshes"});
  check_failure(workshop.run(all + "--iso 1 -o '{name}.stl'"), 2, {"--labels", "--iso"});
  check_failure(workshop.run(all + "--memory 1M -o '{name}.stl'"), 2, {"--labels", "--memory"});
  check_failure(workshop.run(all + "--normals gradient -o '{name}.ply'"), 2, {"--normals"});
  check_failure(workshop.run(all + "--surface interpolated -o '{name}.ply'"), 2, {"--surface"});
  check_failure(workshop.run(extract + "--labels 1 -o '{name}.stl'"), 2, {"all"});
  check_failure(workshop.run(all + "--label-table table.txt -o '{name}.stl'"), 1,
                {"table.txt", "line 1"});
  check_failure(workshop.run(extract + "--label 1 --label-table table.txt -o v.dmc"), 2,
                {"--label-table"});
  check_failure(workshop.run(extract + "--iso 1 --label-table table.txt -o v.stl"), 2,
                {"--label-table", "--label N"});
  check_failure(workshop.run(all + "-o '{name}/v.stl'"), 1, {"{name}", "not of folders"});
  check_failure(workshop.run(all + "-o 'none/{name}.stl'"), 1, {"none", "no such folder"});
  check_failure(
      workshop.run("extract nothing.raw --dims 4,2,3 --type u8 --labels all -o '{name}.stl'"), 1,
      {"nothing.raw", "no label", "--allow-empty"});
  check_failure(workshop.run(all + "--mask nothing.nrrd -o '{name}.stl'"), 1,
                {"v.raw: it holds no label that --mask leaves; --allow-empty"});
  check_failure(workshop.run("extract nan.raw --dims 4,2,3 --type f32 --labels all -o v.glb"), 1,
                {"nan.raw: it holds no label, every voxel is 0 or not a number"});
  check_failure(
      workshop.run("extract half.raw --dims 4,2,3 --type f32 --labels all -o '{name}.stl'"), 1,
      {"half.raw", "slice 0", "whole numbers"});
  CHECK(workshop.names() == names);
}
