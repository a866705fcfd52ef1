// Progress of the command, on a terminal and elsewhere.
#include "cli/progress.hpp"

#include "command.hpp"

namespace {

using namespace command_tests;
using discmc::command::progress_text;
using discmc::reference::box;

const std::string clear_line = "\r\033[K";

// Runs the command on a terminal. Returns the output there, or nothing without a terminal.
std::string on_terminal(const Workshop& workshop, const std::string& arguments) {
  const Result result = workshop.shell(
      "command -v script >found || exit 0\n"
      "script -qec \"$discmc " +
      arguments + "\" /dev/null");
  CHECK(result.code == 0);
  return result.out;
}

// Whether the phases were shown in this order, each on a cleared line.
void check_phases(const std::string& sent, const std::vector<std::string>& phases) {
  INFO(sent);
  std::size_t at = 0;
  for (const std::string& phase : phases) {
    INFO(phase);
    at = sent.find(clear_line + phase, at);
    REQUIRE(at != std::string::npos);
    REQUIRE(sent.find(clear_line, at + 1) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("progress is printed as a percentage, or as a count if the total is unknown") {
  CHECK(progress_text("extracting", 0, 113) == "extracting 0 %");
  CHECK(progress_text("extracting", 51, 113) == "extracting 45 %");
  CHECK(progress_text("extracting", 113, 113) == "extracting 100 %");
  CHECK(progress_text("row", 51, 0) == "row 51");
  CHECK(progress_text("writing", 0, 0) == "writing");
}

TEST_CASE_FIXTURE(Workshop,
                  "on a terminal, progress shows the phases of the job and then clears its line") {
  write("v.nrrd", box({4, 4, 4}, {1, 1, 1}, {2, 2, 2}));
  const std::string extracted = on_terminal(*this, "extract v.nrrd --iso 100 -o v.obj");
  if (extracted.empty()) return;  // no program that makes a terminal
  check_phases(extracted, {"extracting 0 %", "triangulating", "writing"});
  CHECK(contains(extracted, clear_line + "v.obj: "));
  check_phases(on_terminal(*this, "extract v.nrrd --iso 100 --normals gradient -o v.ply"),
               {"extracting 0 %", "triangulating", "normals 0 %", "writing"});

  // The triangles are written as they are made.
  check_phases(on_terminal(*this, "extract v.nrrd --iso 100 -o v.ply"),
               {"extracting 0 %", "writing"});

  const std::string streamed = on_terminal(*this, "extract v.nrrd --iso 100 -o v.dmc");
  check_phases(streamed, {"extracting 0 %"});
  CHECK(contains(streamed, clear_line + "v.dmc: "));
  check_phases(on_terminal(*this, "decode v.dmc -o v.obj"),
               {"reading 0 %", "triangulating", "writing"});
  check_phases(on_terminal(*this, "render v.dmc -o v.png"), {"reading 0 %", "drawing"});
  check_phases(on_terminal(*this, "compare v.dmc v.nrrd --iso 100"),
               {"reading 0 %", "triangulating", "extracting 0 %", "measuring A to B 0 %",
                "measuring B to A 0 %"});
}

TEST_CASE_FIXTURE(Workshop, "without a terminal, no progress is shown") {
  write("v.nrrd", box({4, 4, 4}, {1, 1, 1}, {2, 2, 2}));
  CHECK(run("extract v.nrrd --iso 100 -o v.ply").error.empty());
}
