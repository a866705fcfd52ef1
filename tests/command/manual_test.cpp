// The manual page that discmc writes.
#include "cli/help/outline.hpp"

#include "command.hpp"

namespace {

using namespace command_tests;

// The names of options, from the lines of a help that begin with them.
std::vector<std::string> options_of(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("  -", 0) != 0) continue;
    std::istringstream words(line);
    for (std::string word; words >> word && word[0] == '-';)
      names.push_back(word.substr(0, word.find(',')));
  }
  return names;
}

std::vector<std::string> commands_of(const std::string& help) {
  const std::string title = "\nCommands:\n";
  std::vector<std::string> names;
  std::istringstream lines(help.substr(help.find(title) + title.size()));
  for (std::string line; std::getline(lines, line) && !line.empty();)
    if (line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

// An option in a page of troff: bold, with dashes instead of hyphens.
std::string bold(const std::string& text) {
  std::string troff = "\\fB";
  for (const char letter : text) troff += letter == '-' ? "\\-" : std::string(1, letter);
  return troff + "\\fR";
}

std::string section_of(const std::string& page, const std::string& command) {
  const std::size_t start = page.find(".SS discmc " + command + " ");
  REQUIRE(start != std::string::npos);
  return page.substr(start, page.find("\n.S", start) - start);
}

}  // namespace

TEST_CASE_FIXTURE(Workshop, "the manual has every option of the help in its command's section") {
  const std::string page = done("manual");
  const std::string help = done("--help");
  const std::vector<std::string> commands = commands_of(help);
  CHECK(commands.size() >= 6);
  for (const std::string& command : commands) {
    const std::string section = section_of(page, command);
    const std::vector<std::string> options = options_of(done(command + " --help"));
    CHECK(options.size() >= 2);
    for (const std::string& option : options) {
      INFO(command, " ", option);
      CHECK(contains(section, bold(option)));
    }
  }
  for (const std::string& option : options_of(help)) CHECK(contains(page, bold(option)));
}

TEST_CASE("the manual contains values, defaults, examples and exit codes") {
  const std::string page = Workshop().done("manual");
  for (const char* part :
       {"\\fIISO\\fR", "\\fBclosed\\fR|\\fBopen\\fR", "(default: closed)", "\n.SH EXIT STATUS\n",
        "\n.SH EXAMPLES\n", "3 done but the stream was incomplete",
        "\n  discmc extract head.nii.gz \\-\\-iso 300"}) {
    INFO(part);
    CHECK(contains(page, part));
  }
}

TEST_CASE("texts of the command line are escaped for troff in the manual") {
  const auto line = [](const std::string& description) {
    discmc::command::CommandOutline program{"it", description, {}, {}, {}, "", ""};
    program.groups = {{"Options", {{{"-o"}, "", {}, description, false, false}}}};
    const std::string page = discmc::command::manual(program, "1");
    CHECK(contains(page, "\n.SH NAME\nit \\- "));
    const std::string start = "\n.TP\n\\fB\\-o\\fR\n";
    REQUIRE(contains(page, start));
    const std::size_t begin = page.find(start) + start.size();
    return page.substr(begin, page.find('\n', begin) - begin);
  };
  CHECK(line(".dmc files") == "\\&.dmc files");
  CHECK(line("'tis a file") == "\\&'tis a file");
  CHECK(line("a .dmc file") == "a .dmc file");
  CHECK(line("C:\\volumes") == "C:\\evolumes");
  CHECK(line("--iso") == "\\-\\-iso");
}

TEST_CASE_FIXTURE(Workshop, "man and mandoc accept the manual page without a warning") {
  if (has_program("man")) {
    const Result shown = shell("\"$discmc\" manual | man -l --warnings -");
    CHECK(shown.code == 0);
    CHECK(contains(shown.out, "discmc render [OPTIONS] -o FILE INPUT"));
    CHECK(shown.error.empty());
  }
  if (has_program("mandoc")) {
    const Result checked = shell("\"$discmc\" manual | mandoc -T lint -W warning");
    std::istringstream lines(checked.out);
    for (std::string line; std::getline(lines, line);) {
      INFO(line);
      CHECK(contains(line, "missing date"));  // no date, so that builds are reproducible
    }
  }
}
