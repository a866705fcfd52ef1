// Thresholds without a surface, or with the whole volume on: the message has the actual values.
#include "command.hpp"

namespace {

using namespace command_tests;
using volume_files::nrrd;
using volume_files::text_nrrd;

// 60 values: -1000, -900 ... 4900.
const std::string ramp = [] {
  std::string samples;
  for (int i = 0; i < 60; ++i) samples += std::to_string(100 * i - 1000) + " ";
  return text_nrrd("short", "5 3 4", samples);
}();

const std::string values =
    ", and the values are -1000 to 4900; choose a threshold with discmc info";

struct Ramp : Workshop {
  Ramp() { write("v.nrrd", ramp); }
};

}  // namespace

TEST_CASE_FIXTURE(Ramp, "an empty surface is an error with the range of values") {
  write("none.nrrd", nrrd(volume_files::nrrd_u8) + "\n" + std::string(60, '\0'));
  write("other.stl", "before");
  const auto names = file_names();
  const std::pair<std::string, std::string> examples[] = {
      {"--iso 4901", "no voxel reaches 4901"},
      {"--iso 1e9 --surface interpolated", "no voxel reaches 1000000000"},
      {"--iso 5000 --normals gradient", "no voxel reaches 5000"},
      {"--label 33", "no voxel has label 33"},
      {"--range 101..199.5", "no voxel is in 101..199.5"},
      {"--range=..-1001", "no voxel is in ..-1001"},
      {"--iso=-1000 --border open",
       "every voxel reaches -1000, so a surface with --border open is empty"},
      {"--iso 4901 --median 3", "no voxel reaches 4901"},
      {"--label 100 --mask none.nrrd",
       "no voxel that has label 100 is left by --mask, or no voxel has that label"},
      {"--label 100 --median 3",
       "no voxel that has label 100 is left by --median, or no voxel has that label"},
      {"--iso=-1000 --border open --median 3",
       "after --median every voxel reaches -1000, so a surface with --border open is empty"},
  };
  for (const auto& [selection, reason] : examples)
    for (const std::string file : {"v.stl", "v.jsonl", "v.dmc", "other.stl"}) {
      const std::string arguments = "extract v.nrrd " + selection + " -o " + file;
      const Result result = run(arguments);
      INFO(arguments, "\n", result.error);
      if (result.code == 2) continue;  // conflicting options
      const bool is_label = selection.find("--label") != std::string::npos;
      const std::string more = is_label ? "; list the labels with discmc info" : values;
      check_failure(result, 1, {"v.nrrd: " + reason + more, "--allow-empty"});
    }
  CHECK(file_names() == names);
  CHECK(read("other.stl") == "before");
}

TEST_CASE_FIXTURE(Ramp, "an empty surface among several is reported, and no file is written") {
  for (const std::string file : {"'{name}.ply'", "v.dmc", "v.dmc --wire slices"})
    fails("extract v.nrrd --iso 100 --iso 7000 --iso 200 -o " + file, 1,
          {"no voxel reaches 7000" + values});
}

TEST_CASE_FIXTURE(Ramp, "removing every body as too small is reported as an empty surface") {
  const std::string extract = "extract v.nrrd --iso 100 --min-volume 100 -o v.stl";
  fails(extract, 1, {"no body is as large as --min-volume"});
  done(extract + " --allow-empty");
}

TEST_CASE_FIXTURE(Ramp, "an empty surface of a volume read from a pipe is a failure") {
  for (const std::string file : {"v.stl", "v.dmc"}) {
    const std::string extract = "cat v.nrrd | \"$discmc\" extract - -o " + file;
    check_failure(shell(extract + " --iso 7000"), 1,
                  {"standard input: no voxel reaches 7000" + values});
    check_failure(
        shell(extract + " --iso=-2000 --border open"), 1,
        {"standard input: every voxel reaches -2000, so a surface with --border open is empty"});
  }
  CHECK(file_names() == std::vector<std::string>{"v.nrrd"});
}

TEST_CASE_FIXTURE(Ramp, "a surface equal to the box of the volume is written with a note") {
  write("four.nrrd", nrrd(volume_files::nrrd_u8) + "\n" + std::string(60, '\4'));
  for (const std::string file : {"v.stl", "v.dmc", "v.dmc --wire slices", "v.png"}) {
    INFO(file);
    const std::string command = file == "v.png" ? "render" : "extract";
    const auto error_of = [&](const std::string& arguments) {
      const Result result = run(command + " " + arguments + " -o " + file);
      CHECK(result.code == 0);
      return result.error;
    };
    const std::string box = ", so the surface is the box of the volume";
    CHECK(contains(error_of("v.nrrd --iso=-1000"),
                   "v.nrrd: every voxel reaches -1000" + box + values));
    CHECK(contains(error_of("four.nrrd --label 4"), "every voxel has label 4" + box));
    CHECK(error_of("v.nrrd --iso=-999").empty());
  }
  check_parts(shell("cat v.nrrd | \"$discmc\" extract - --iso=-2000 -o v.stl"), 0,
              {"standard input: every voxel reaches -2000"});
}

TEST_CASE_FIXTURE(Workshop,
                  "a volume that --median or infinite values turn on completely is reported") {
  const auto write_floats = [&](const std::string& name, const std::string& sample, int hole) {
    std::string samples;
    for (int i = 0; i < 60; ++i) samples += (i == hole ? "0" : sample) + " ";
    write(name, text_nrrd("float", "5 3 4", samples));
  };
  write_floats("hole.nrrd", "7", 22);
  write_floats("inf.nrrd", "inf", -1);
  write_floats("mixed.nrrd", "inf", 22);
  std::string mostly_off = "inf ";
  for (int i = 0; i < 59; ++i) mostly_off += "0 ";
  write("one.nrrd", text_nrrd("float", "5 3 4", mostly_off));
  const std::string open = ", so a surface with --border open is empty, and ";
  const std::pair<std::string, std::string> examples[] = {
      {"hole.nrrd --median 3 --border open", "after --median every voxel reaches 5" + open},
      {"inf.nrrd --border open", "every voxel reaches 5" + open},
      {"mixed.nrrd --median 3 --border open", "after --median every voxel reaches 5" + open},
      {"one.nrrd --median 3", "no voxel that reaches 5 is left by --median"},
  };
  for (const std::string command : {"extract", "render"})
    for (const auto& [arguments, reason] : examples)
      fails(command + " " + arguments + " --iso 5 -o v." + (command == "extract" ? "stl" : "png"),
            1, {reason});
  fails("render inf.nrrd --classic --border open --iso 5 -o v.png", 1,
        {"inf.nrrd: every voxel reaches 5" + open});
  for (const std::string command : {"extract hole.nrrd -q -o v.stl", "render hole.nrrd -o v.png"})
    CHECK(contains(run(command + " --iso 5 --median 3 ").error,
                   "hole.nrrd: after --median every voxel reaches 5, so the surface is the box"));
}

TEST_CASE_FIXTURE(Workshop,
                  "the message for a volume of only NaN samples states that no value is finite") {
  write("v.nrrd", text_nrrd("float", "2 1 2", "nan nan nan nan"));
  fails("extract v.nrrd --iso 3 -o v.stl", 1, {"no voxel reaches 3, and no value is finite; "});
}

TEST_CASE_FIXTURE(Ramp, "pictures and distances of empty surfaces are refused") {
  done("extract v.nrrd --iso 100 -q -o v.dmc");
  for (const std::string look : {"", " --classic", " --shade smooth"})
    fails("render v.nrrd --iso 7000 -o v.png" + look, 1,
          {"v.nrrd: no voxel reaches 7000" + values});
  fails("compare v.dmc v.nrrd --iso 7000", 1, {"v.nrrd: no voxel reaches 7000" + values});
  CHECK(file_names() == std::vector<std::string>{"v.dmc", "v.nrrd"});
}

TEST_CASE_FIXTURE(Ramp, "a stream without polygons is decoded and drawn with a note") {
  done("extract v.nrrd --iso 7000 --allow-empty -q -o v.dmc");
  for (const std::string command : {"decode v.dmc -o v.stl", "render v.dmc -o v.png"}) {
    const auto empty = run(command);
    CHECK(empty.code == 0);
    CHECK(empty.error ==
          "discmc: v.dmc: the stream holds no polygon; extract it with another threshold\n");
  }
}

TEST_CASE_FIXTURE(Workshop,
                  "messages about a volume narrowed to 16 bits print the values of the file") {
  write("v.nrrd", text_nrrd("float", "2 1 2", "0.25 0.5 nan -8"));
  for (const std::string file : {"v.ply", "v.dmc"})
    fails("extract v.nrrd --iso 3 --normals gradient -o " + file, 1,
          {"no voxel reaches 3, and the values are -8 to 0.5;"});
}
