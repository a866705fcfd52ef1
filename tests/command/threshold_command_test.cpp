// Thresholds that the command chooses.
#include "command.hpp"

namespace {

using namespace command_tests;

// Ten voxels per row: air, tissue, bone.
std::string head(const std::string& values) {
  std::string samples;
  for (int row = 0; row < 9; ++row) samples += values;
  return volume_files::text_nrrd("short", "5 3 3", samples);
}

const std::string ct = head("-1000 -1000 40 50 900 ");
const std::string mri = head("0 10 40 500 600 ");

struct Head : Workshop {
  Head() { write("ct.nrrd", ct); }
};

}  // namespace

TEST_CASE_FIXTURE(Head, "a named threshold gives the same mesh as its number, and is reported") {
  write("mri.nrrd", mri);
  const std::array<std::string, 4> examples[] = {
      {"ct", "bone", "300", "300"},         {"ct", "skin", "-300", "-300"},
      {"ct", "auto", "300", "300 (bone)"},  {"ct", "otsu", "-500", "-500"},
      {"mri", "auto", "300", "300 (otsu)"}, {"mri", "otsu", "300", "300"},
  };
  for (const auto& [volume, name, iso, reported] : examples) {
    const std::string file = volume + ".nrrd";
    const Result result = run("extract " + file + " --iso " + name + " -q -o named.ply");
    INFO(result.error);
    CHECK(result.code == 0);
    CHECK(result.error == "discmc: " + file + ": --iso " + name + ": " + reported + "\n");
    done("extract " + file + " --iso=" + iso + " -q -o number.ply");
    CHECK(read("named.ply") == read("number.ply"));
  }
}

TEST_CASE_FIXTURE(Workshop, "padding excluded from Otsu's threshold is reported") {
  write("ct.nrrd", head("-2000 -2000 -1000 40 900 "));
  const Result otsu = run("extract ct.nrrd --iso otsu -q -o v.stl");
  CHECK(otsu.error ==
        "discmc: ct.nrrd: --iso otsu: -500, without the -2000 outside the scanned circle\n");
  CHECK(contains(done("info ct.nrrd"),
                 "otsu: divides the values into two groups, without the "
                 "padding -2000\n"));
  CHECK(contains(run("extract ct.nrrd --iso auto -q -o v.stl").error, "--iso auto: 300 (bone)\n"));
}

TEST_CASE_FIXTURE(Head, "named thresholds can be combined with numbers, and name their meshes") {
  done("extract ct.nrrd --iso bone --iso 45 --iso auto -o '{name}.stl'");
  CHECK(file_names() == std::vector<std::string>{"45.stl", "auto.stl", "bone.stl", "ct.nrrd"});
  CHECK(read("auto.stl") == read("bone.stl"));
  CHECK(read("45.stl") != read("bone.stl"));
}

TEST_CASE_FIXTURE(Head, "extract to streams, render and compare accept named thresholds") {
  done("extract ct.nrrd --iso skin -q -o skin.dmc");
  CHECK(info_of("skin.dmc")["threshold"] == "-300");
  done("render ct.nrrd --iso skin --size 40,40 -o named.png");
  done("render ct.nrrd --iso=-300 --size 40,40 -o number.png");
  CHECK(read("named.png") == read("number.png"));
  done("extract ct.nrrd --iso auto --surface interpolated --normals gradient -o v.ply");
  CHECK(done("compare skin.dmc ct.nrrd --iso skin") == done("compare skin.dmc ct.nrrd --iso=-300"));
}

TEST_CASE_FIXTURE(Head, "a named threshold is refused if the volume does not determine its value") {
  write("mri.nrrd", mri);
  write("flat.nrrd", head("7 7 7 7 7 "));
  const auto names = file_names();
  const std::string mesh = " -o v.stl";
  fails("extract mri.nrrd --iso bone" + mesh, 1,
        {"mri.nrrd: --iso bone needs Hounsfield units, and the values are 0 to 600; "});
  fails("extract flat.nrrd --iso auto" + mesh, 1, {"flat.nrrd: all values are 7, "});
  fails("extract ct.nrrd --iso bones" + mesh, 2,
        {"invalid value 'bones'; expected a finite number, auto, otsu, bone or skin"});
  for (const std::string name : {"auto", "otsu", "bone", "skin"})
    check_failure(shell("cat ct.nrrd | \"$discmc\" extract - --iso " + name + mesh), 1,
                  {"standard input: --iso " + name + " reads the volume twice",
                   "can be read only once; store it in a file"});
  CHECK(file_names() == names);
}

TEST_CASE_FIXTURE(Workshop,
                  "CT from DICOM is treated as Hounsfield units for any part of the body") {
  const std::string series = DISCMC_SOURCE_DIR "/tests/command/volumes/dicom/u8.dcm";
  if (run("info " + series).code != 0) return;  // if built without DICOM
  check_parts(run("extract " + series + " --iso skin --allow-empty -o v.stl"), 0,
              {"--iso skin: -300\n"});
  // No value reaches bone.
  CHECK(contains(run("extract " + series + " --iso auto -o v.stl").error, " (otsu)\n"));
  CHECK_FALSE(contains(done("info " + series), "bone"));
}
