// The output of discmc --help.
#include "command.hpp"

namespace {

using namespace command_tests;

const std::vector<std::string> commands = {"extract", "decode", "info", "render", "compare"};

std::string help_of(const std::string& command) {
  return Workshop().done(command + " --help");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("help lists all commands, and help of a command lists its options under headings") {
  const std::string all = Workshop().done("--help");
  for (const std::string& command : commands) CHECK(contains(all, "\n  " + command + "  "));
  const std::string extract = help_of("extract");
  std::size_t at = 0;
  for (const char* part :
       {"\nUsage: discmc extract [OPTIONS] VOLUME\n", "\nOptions:\n", "\n  -o, --output FILE  ",
        "\nVolume:\n", "\n  --big-endian  ", "\n  --spacing X,Y,Z  ", "\nSurface:\n",
        "\n  --border closed|open  ", "\nMesh:\n", "\n  --conforming, --no-conforming\n",
        "\nStream:\n", "\n  --scan N  "}) {
    INFO(part);
    at = extract.find(part, at);
    CHECK(at != std::string::npos);
  }
}

TEST_CASE("the command help prints the same text as --help") {
  CHECK(Workshop().done("help") == Workshop().done("--help"));
  CHECK(Workshop().done("help extract") == help_of("extract"));
}

TEST_CASE("help prints defaults and required options") {
  const std::string extract = help_of("extract");
  CHECK(contains(extract, "(default: closed)"));
  CHECK(contains(extract, "(default: 0)"));
  CHECK(contains(help_of("render"), "(default: 1024,1024)"));
  CHECK(contains(help_of("info"), "--scan"));
  CHECK(!contains(help_of("info"), "(required)"));
  CHECK(contains(help_of("decode"), "standard output (required)"));
}

TEST_CASE("help fits a terminal of 80 columns") {
  for (const std::string& command : commands)
    for (const std::string& line : lines_of(help_of(command))) {
      INFO(line);
      CHECK(line.size() <= 80);
      CHECK((line.empty() || line.back() != ' '));
    }
}

TEST_CASE_FIXTURE(Workshop, "every example in the help is a valid command line") {
  for (const std::string& command : commands) {
    std::size_t examples = 0;
    for (const std::string& line : lines_of(help_of(command))) {
      const std::string start = "  discmc ";
      if (line.rfind(start, 0) != 0) continue;
      ++examples;
      const Result result = run(line.substr(start.size()));
      INFO(line, "\n", result.error);
      CHECK(result.code == 1);  // the files are not there
    }
    CHECK(examples > 0);
  }
}
