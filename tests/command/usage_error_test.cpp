// The messages of discmc for invalid command lines.
#include "command.hpp"

namespace {

using namespace command_tests;
using volume_files::replaced_all;

void check_said(const std::string& arguments, const std::string& said,
                const std::string& command = {}) {
  const Result result = Workshop().run(arguments);
  INFO(arguments);
  CHECK(result.code == 2);
  CHECK(result.out.empty());
  CHECK(result.error ==
        "discmc: " + said + "\nSee discmc " + (command.empty() ? "" : command + " ") + "--help.\n");
}

}  // namespace

TEST_CASE("a misspelt command is answered with the nearest command") {
  const std::string none = "' is not a command; did you mean ";
  check_said("extrct v.nrrd", "'extrct" + none + "extract?");
  check_said("dceode v.dmc", "'dceode" + none + "decode?");
  check_said("infos v.dmc", "'infos" + none + "info?");
  check_said("reader v.dmc", "'reader" + none + "render?");
}

TEST_CASE("an unknown command without a similar command is answered with the list of commands") {
  const std::string all = "give one of extract, view, info, render";
  CHECK(contains(Workshop().run("frobnicate v.nrrd").error,
                 "discmc: 'frobnicate' is not a command; " + all));
  CHECK(contains(Workshop().run("").error, "discmc: no command is given; " + all));
}

TEST_CASE_FIXTURE(Workshop, "a file in place of a command is answered with working commands") {
  write("scan.nrrd", discmc::reference::box({6, 5, 4}, {1, 1, 1}, {4, 3, 2}));
  // The text from `before` to a comma or the end of the line.
  const auto advice = [&](const std::string& arguments, const std::string& before) {
    const Result result = run(arguments);
    INFO(result.error);
    CHECK(result.code == 2);
    const std::size_t begin = result.error.find(before + "discmc ");
    REQUIRE(begin != std::string::npos);
    const std::size_t first = begin + before.size() + std::string("discmc ").size();
    return result.error.substr(first, result.error.find_first_of(",\n", first) - first);
  };
  done(advice("scan.nrrd", "write "));
  CHECK(!read("surface.stl").empty());
  done(advice("./scan.nrrd --iso 5", "or "));
  done("extract scan.nrrd --iso 100 -q -o scan.dmc");
  done(advice("scan.dmc", "write ") + " --faces triangles");
  done(advice("scan.dmc", "or "));
  done(advice("surface.stl", "write ") + " scan.nrrd --iso auto");
  check_said("'a scan.nrrd'",
             "'a scan.nrrd' is not a command; write discmc extract FILE --iso auto -o surface.stl, "
             "or discmc info FILE");
}

TEST_CASE("a misspelt option is answered with the nearest option of the command") {
  const std::pair<std::string, std::string> cases[] = {
      {"extract v.raw --iso 5 --spacng 1,1,1", "'--spacng' ... --spacing"},
      {"extract --spacng=1,1,1 v.raw", "'--spacng' ... --spacing"},
      {"extract --no-confroming v.raw", "'--no-confroming' ... --no-conforming"},
      {"extract -borders v.raw", "'-borders' ... --border"},
      {"extract --conformity v.raw", "'--conformity' ... --conforming"}};
  for (const auto& [arguments, said] : cases)
    check_said(arguments,
               replaced_all(said, "...", "is not an option of extract; did you mean") + "?",
               "extract");
  check_said("--verson", "'--verson' is not an option of discmc; did you mean --version?");
}

TEST_CASE("other programs' names for the threshold are answered with --iso") {
  for (const std::string option : {"--threshold", "--isovalue", "-threshold"})
    check_said("extract v.nrrd " + option + " 300",
               "'" + option + "' is not an option of extract; did you mean --iso?", "extract");
  check_said("info v.nrrd --threshold 300", "'--threshold' is not an option of info; leave it out",
             "info");
}

TEST_CASE("other programs' names for smoothing are answered with the option of the command") {
  check_said("extract v.nrrd --iso 5 --smoothing",
             "'--smoothing' is not an option of extract; did you mean --smooth auto?", "extract");
  check_said("render v.nrrd --smooth",
             "'--smooth' is not an option of render; did you mean --shade smooth?", "render");
  check_said("decode v.dmc --smoothing=3",
             "'--smoothing' is not an option of decode; did you mean --normals surface?", "decode");
}

TEST_CASE("an unknown option without a similar option is reported without a suggestion") {
  check_said("info v.dmc --zoom 5", "'--zoom' is not an option of info; leave it out", "info");
  check_said("--iso 5 extract v.nrrd",
             "'--iso' is not an option of discmc; give options of a command after its name",
             "extract");
}

TEST_CASE("a missing or invalid value is answered with the expected form") {
  const std::string number = "; expected a finite number, auto, otsu, bone or skin\n";
  const std::pair<std::string, std::string> cases[] = {
      {"extract v.raw --dims 1,2", "--dims: invalid value '1,2'; expected X,Y,Z\n"},
      {"extract v.raw --dims a,b,c", "--dims: invalid value 'a,b,c'; expected X,Y,Z\n"},
      {"render v.dmc -o v.png --size 480x400",
       "--size: invalid value '480x400'; expected W,H, each 1 to 8192\n"},
      {"extract v.raw --scan", "--scan: the value is missing; expected N\n"},
      {"extract v.raw --iso much", "invalid value 'much'" + number},
      {"extract v.raw --iso 5x", "invalid value '5x'" + number}};
  for (const auto& [arguments, part] : cases)
    CHECK(contains(Workshop().run(arguments).error, part));
}

TEST_CASE("unexpected and missing arguments are reported by name") {
  check_said("info a.dmc b.dmc", "'b.dmc' is an unexpected argument; leave it out", "info");
  check_said("extract v.nrrd out.stl",
             "'out.stl' is an unexpected argument; name the output with -o out.stl", "extract");
  check_said("extract v.nrrd out.stl --iso 5 -o v.stl",
             "'out.stl' is an unexpected argument; leave it out", "extract");
  CHECK(contains(Workshop().run("extract v.nrrd -o v.stl").error,
                 "discmc: --iso: no threshold is given; add --iso auto, --iso ISO, "));
  check_said("extract --border -o v.dmc v.nrrd --iso 5",
             "--border: invalid value '-o'; expected closed|open", "extract");
  check_said("info --", "INPUT is missing; write discmc info [OPTIONS] INPUT", "info");
  check_said("compare a.stl", "B is missing; write discmc compare [OPTIONS] A B", "compare");
  check_said("render v.dmc", "--output is missing; write discmc render [OPTIONS] -o FILE INPUT",
             "render");
}
