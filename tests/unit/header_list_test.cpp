// What discmc.hpp says of the headers, of which it is the list.
#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "project_text.hpp"

namespace fs = std::filesystem;

namespace {

const fs::path library = fs::path(DISCMC_SOURCE_DIR) / "lib";

using discmc::test::text_of;

// The headers of this library that one of them includes, by whatever way, and itself.
std::set<std::string> included_by(const std::string& header) {
  const std::string include = "#include <";
  std::set<std::string> all = {header};
  for (std::vector<std::string> left = {header}; !left.empty();) {
    std::istringstream lines(text_of(library / left.back()));
    left.pop_back();
    for (std::string line; std::getline(lines, line);) {
      if (line.compare(0, include.size() + 7, include + "discmc/") != 0) continue;
      const std::string name = line.substr(include.size(), line.find('>') - include.size());
      if (all.insert(name).second) left.push_back(name);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("the list of headers has all of them") {
  const std::string list = text_of(library / "discmc/discmc.hpp");
  size_t headers = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(library / "discmc")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".hpp" || name == "discmc.hpp") continue;
    CAPTURE(name);
    CHECK(list.find(" " + name) != std::string::npos);
    ++headers;
  }
  CHECK(headers > 50);
}

TEST_CASE("discmc.hpp includes the whole interface but that of hosts") {
  const std::set<std::string> included = included_by("discmc/discmc.hpp");
  const std::set<std::string> not_included = {"learning_extractor.hpp"};
  for (const fs::directory_entry& entry : fs::directory_iterator(library / "discmc")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".hpp") continue;
    CAPTURE(name);
    CHECK(included.count("discmc/" + name) == 1 - not_included.count(name));
  }
}
