// The messages of discmc for invalid command lines.
#include "command.hpp"

namespace {

using namespace command_tests;

// Arguments, and the complete message.
void check_said(const std::string& arguments, const std::string& said) {
  const Result result = Workshop().run(arguments);
  INFO(arguments);
  CHECK(result.code == 2);
  CHECK(result.out.empty());
  CHECK(result.error == said);
}

}  // namespace

TEST_CASE("a command that is misspelt is answered with the nearest one") {
  const std::string end = "?\nSee discmc --help.\n";
  check_said("extrct v.nrrd", "discmc: 'extrct' is not a command; did you mean extract" + end);
  check_said("dceode v.dmc", "discmc: 'dceode' is not a command; did you mean decode" + end);
  check_said("infos v.dmc", "discmc: 'infos' is not a command; did you mean info" + end);
  check_said("reader v.dmc", "discmc: 'reader' is not a command; did you mean render" + end);
}

TEST_CASE("an unknown command without a similar one is answered with the list of commands") {
  const std::string all = "give one of extract, view, info, render";
  CHECK(contains(Workshop().run("frobnicate v.nrrd").error,
                 "discmc: 'frobnicate' is not a command; " + all));
  CHECK(contains(Workshop().run("").error, "discmc: no command is given; " + all));
}

TEST_CASE_FIXTURE(Workshop,
                  "a file in place of a command is answered with what to write, which works") {
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
             "discmc: 'a scan.nrrd' is not a command; write discmc extract FILE --iso auto -o "
             "surface.stl, or discmc info FILE\nSee discmc --help.\n");
}

TEST_CASE("an option that is misspelt is answered with the nearest one of its command") {
  const std::string end = "?\nSee discmc extract --help.\n";
  const std::string spacing =
      "discmc: '--spacng' is not an option of extract; did you mean --spacing" + end;
  check_said("extract v.raw --iso 5 --spacng 1,1,1", spacing);
  check_said("extract --spacng=1,1,1 v.raw", spacing);
  check_said(
      "extract --no-confroming v.raw",
      "discmc: '--no-confroming' is not an option of extract; did you mean --no-conforming" + end);
  check_said("extract -borders v.raw",
             "discmc: '-borders' is not an option of extract; did you mean --border" + end);
  check_said("extract --conformity v.raw",
             "discmc: '--conformity' is not an option of extract; did you mean --conforming" + end);
  check_said("--verson",
             "discmc: '--verson' is not an option of discmc; did you mean --version?\n"
             "See discmc --help.\n");
}

TEST_CASE("other programs' names for the threshold are answered with --iso") {
  for (const std::string option : {"--threshold", "--isovalue", "-threshold"})
    check_said("extract v.nrrd " + option + " 300",
               "discmc: '" + option +
                   "' is not an option of extract; did you mean --iso?\n"
                   "See discmc extract --help.\n");
  check_said(
      "info v.nrrd --threshold 300",
      "discmc: '--threshold' is not an option of info; leave it out\nSee discmc info --help.\n");
}

TEST_CASE("other programs' names for smoothing are answered with the option of the command") {
  check_said("extract v.nrrd --iso 5 --smoothing",
             "discmc: '--smoothing' is not an option of extract; did you mean --smooth auto?\n"
             "See discmc extract --help.\n");
  check_said("render v.nrrd --smooth",
             "discmc: '--smooth' is not an option of render; did you mean --shade smooth?\n"
             "See discmc render --help.\n");
  check_said("decode v.dmc --smoothing=3",
             "discmc: '--smoothing' is not an option of decode; did you mean --normals surface?\n"
             "See discmc decode --help.\n");
}

TEST_CASE("an unknown option without a similar one is answered without a guess") {
  check_said("info v.dmc --zoom 5",
             "discmc: '--zoom' is not an option of info; leave it out\nSee discmc info --help.\n");
  check_said("--iso 5 extract v.nrrd",
             "discmc: '--iso' is not an option of discmc; give options of a command after its "
             "name\nSee discmc extract --help.\n");
}

TEST_CASE("a missing or invalid value is answered with the expected form") {
  CHECK(contains(Workshop().run("extract v.raw --dims 1,2").error,
                 "--dims: invalid value '1,2'; expected X,Y,Z\n"));
  CHECK(contains(Workshop().run("extract v.raw --dims a,b,c").error,
                 "--dims: invalid value 'a,b,c'; expected X,Y,Z\n"));
  CHECK(contains(Workshop().run("render v.dmc -o v.png --size 480x400").error,
                 "--size: invalid value '480x400'; expected W,H, each 1 to 8192\n"));
  CHECK(contains(Workshop().run("extract v.raw --scan").error,
                 "--scan: the value is missing; expected N\n"));
  CHECK(contains(Workshop().run("extract v.raw --iso much").error,
                 "invalid value 'much'; expected a finite number, auto, otsu, bone or skin\n"));
  CHECK(contains(Workshop().run("extract v.raw --iso 5x").error,
                 "invalid value '5x'; expected a finite number, auto, otsu, bone or skin\n"));
}

TEST_CASE("unexpected and missing arguments are reported by name") {
  check_said("info a.dmc b.dmc",
             "discmc: 'b.dmc' is an unexpected argument; leave it out\nSee discmc info --help.\n");
  check_said("extract v.nrrd out.stl",
             "discmc: 'out.stl' is an unexpected argument; name the output with -o out.stl\nSee "
             "discmc extract --help.\n");
  check_said(
      "extract v.nrrd out.stl --iso 5 -o v.stl",
      "discmc: 'out.stl' is an unexpected argument; leave it out\nSee discmc extract --help.\n");
  CHECK(contains(Workshop().run("extract v.nrrd -o v.stl").error,
                 "discmc: --iso: no threshold is given; add --iso auto, --iso ISO, "));
  check_said(
      "extract --border -o v.dmc v.nrrd --iso 5",
      "discmc: --border: invalid value '-o'; expected closed|open\nSee discmc extract --help.\n");
  check_said(
      "info --",
      "discmc: INPUT is missing; write discmc info [OPTIONS] INPUT\nSee discmc info --help.\n");
  check_said(
      "compare a.stl",
      "discmc: B is missing; write discmc compare [OPTIONS] A B\nSee discmc compare --help.\n");
  check_said("render v.dmc",
             "discmc: --output is missing; write discmc render [OPTIONS] -o FILE INPUT\n"
             "See discmc render --help.\n");
}
