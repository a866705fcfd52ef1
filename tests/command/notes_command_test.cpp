// Commands print the notes of the reader of a volume.
#include "command.hpp"
#include "pages/page.hpp"

namespace {

using namespace command_tests;
using discmc::reference::ball;

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++count;
  return count;
}

const std::string no_spacing = "v.nrrd: no spacing given, 1 mm assumed\n";

}  // namespace

TEST_CASE_FIXTURE(Workshop, "every command that reads a volume prints its notes, each once") {
  write("v.nrrd", ball({20, 20, 20}, {19, 19, 19}, 81), "");
  done("extract v.nrrd --iso 100 -q -o v.dmc");
  std::vector<std::string> commands = {
      "extract v.nrrd --iso otsu --normals gradient -q -o v.ply",
      "extract v.nrrd --iso 100 -q -o w.dmc",
      "extract v.nrrd --labels all -q -o '{name}.stl'",
      "decode v.dmc --normals gradient --volume v.nrrd -o v.ply",
      "render v.nrrd --iso auto --shade smooth -o v.png",
      "compare v.dmc v.nrrd --iso 100",
      "tune v.nrrd --iso 100 --wire slices",
  };
  if (!discmc::command::page_template().empty())
    commands.emplace_back("view v.nrrd --no-open -o v.html");
  for (const std::string& command : commands) {
    const Result result = run(command);
    INFO(command, "\n", result.error);
    CHECK(result.code == 0);
    CHECK(count_of("discmc: " + no_spacing, result.error) == 1);
  }
  CHECK(count_of("note no spacing given", done("info v.nrrd")) == 1);
}

TEST_CASE_FIXTURE(Workshop, "extract prints the notes of a mask") {
  const auto body = ball({20, 20, 20}, {19, 19, 19}, 81);
  write("v.nrrd", body);
  write("m.nrrd", body, "");
  CHECK(contains(run("extract v.nrrd --mask m.nrrd --iso 100 -q -o v.stl").error,
                 "discmc: m.nrrd: no spacing given, 1 mm assumed\n"));
}

TEST_CASE_FIXTURE(Workshop, "extract reports bytes behind the last slice") {
  write("v.nrrd", ball({20, 20, 20}, {19, 19, 19}, 81));
  write("w.nrrd.gz", volume_files::gzip(read("v.nrrd") + "behind"));
  const std::string behind = "more bytes after the samples are left out";
  CHECK(contains(run("extract w.nrrd.gz --iso 100 -q -o w.stl").error,
                 "discmc: w.nrrd.gz: " + behind));
  CHECK(contains(done("info w.nrrd.gz"), "note " + behind));
}
