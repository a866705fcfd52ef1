// The pages of docs/ for owners of volumes agree with the command: messages, formats, keys of info.
#include <regex>

#include "cli/commands.hpp"
#include "command.hpp"
#include "mesh_files/file_format.hpp"
#include "project_text.hpp"
#include "volumes/format_list.hpp"

namespace {

using namespace command_tests;
using discmc::test::text_of;

namespace fs = std::filesystem;

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator each(text.begin(), text.end(), expression), end; each != end; ++each)
    found.push_back((*each)[1]);
  return found;
}

/// The lines from a heading to the next one of its level.
std::string section_of(const std::string& page, const std::string& heading) {
  const size_t begin = page.find("\n" + heading + "\n");
  REQUIRE(begin != std::string::npos);
  const std::string level = heading.substr(0, heading.find(' ') + 1);
  return page.substr(begin, page.find("\n" + level, begin + 1) - begin);
}

/// The sources of the command, with adjacent literals joined.
std::string sources() {
  std::string all;
  for (const char* const port : {"ports/command", "ports/mesh"})
    for (const auto& file : fs::recursive_directory_iterator(fs::path(DISCMC_SOURCE_DIR) / port))
      if (file.path().extension() == ".cpp" || file.path().extension() == ".hpp")
        all += text_of(file.path());
  return std::regex_replace(all, std::regex("\"\\s*\n\\s*\""), "");
}

/// The constant words of a message, between its placeholders.
std::vector<std::string> fixed_words(const std::string& message) {
  const std::string marked = std::regex_replace(message, std::regex("…"), "\n");
  return matches(marked, "[ ;,:]*([^\n]*[^\n ;,:])");
}

}  // namespace

TEST_CASE("every message that the guide explains occurs in the command") {
  const std::string all = sources();
  const auto messages = matches(text_of("docs/troubleshooting.md"), "\n\\| `([^`]+)` \\|");
  CHECK(messages.size() > 40);
  for (const std::string& message : messages)
    for (const std::string& words : fixed_words(message)) {
      INFO(message);
      INFO(words);
      CHECK(contains(all, words));
    }
}

TEST_CASE("the guide's tables contain only supported volume formats and all mesh formats") {
  const std::string page = text_of("docs/formats.md");
  const auto names = matches(section_of(page, "## Volumes"), "\n\\| [^|]+ \\| (\\.[^|]+) \\|");
  CHECK(names.size() > 15);
  for (const std::string& row : names)
    for (const std::string& ending : matches(row, "(\\.[a-z0-9]+)")) {
      INFO(ending);
      if (ending == ".mat") continue;  // recognised by its first bytes
      const auto* const format = discmc::command::format_of_name("a" + ending);
      REQUIRE(format != nullptr);
      CHECK(discmc::command::is_read(*format));
    }
  const std::string meshes = section_of(page, "## Meshes");
  for (const std::string& ending : matches(discmc::command::extensions(), "(\\.[a-z0-9]+)"))
    CHECK(contains(meshes, "| `" + ending + "` |"));
}

TEST_CASE_FIXTURE(Workshop, "the guide names every key of info, and every exit code") {
  const std::string page = text_of("docs/command.md");
  write("v.nrrd", discmc::reference::ball({20, 20, 20}, {19, 19, 15}, 100));
  done("extract v.nrrd --iso 100 -o v.dmc");
  for (const std::string input : {"v.nrrd", "v.dmc"})
    for (const auto& each : info_of(input)) {
      const std::string& key = each.first;
      if (key.rfind("percentile_", 0) == 0) continue;  // given as a range
      INFO(input, " ", key);
      CHECK(contains(section_of(page, "### Keys of `info`"), "`" + key + "`"));
    }
  using namespace discmc::command;
  for (const int code : {exit_ok, exit_failure, exit_usage, exit_incomplete})
    CHECK(contains(page, "\n| " + std::to_string(code) + " | "));
}
