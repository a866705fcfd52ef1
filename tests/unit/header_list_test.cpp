// docs/README.md, docs/statuses.md and discmc.hpp list everything, and the folders of the library
// include only the folders that they need.
#include <filesystem>
#include <regex>
#include <sstream>

#include "project_text.hpp"
#include "test.hpp"

namespace fs = std::filesystem;

namespace {

const fs::path library = fs::path(DISCMC_SOURCE_DIR) / "lib";

using discmc::test::text_of;

// Returns a header, and all headers of this library that it includes.
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

TEST_CASE("docs/README.md lists every user header and every folder of the library") {
  const std::string map = text_of(fs::path(DISCMC_SOURCE_DIR) / "docs/README.md");
  size_t headers = 0, rooms = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(library / "discmc")) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    if (entry.is_directory()) {
      CHECK(map.find("| `" + name + "/` |") != std::string::npos);
      ++rooms;
    } else if (entry.path().extension() == ".hpp" && name != "discmc.hpp") {
      CHECK(map.find("[" + name + "]") != std::string::npos);
      ++headers;
    }
  }
  CHECK(headers > 20);
  CHECK(rooms > 5);
}

// Returns the folders that the files of a folder include, also through headers of lib/discmc
// itself.
const std::map<std::string, std::set<std::string>> reached_folders = {
    {"base", {}},
    {"c", {"base", "front", "geometry", "join", "slices", "stream", "trace"}},
    {"flash", {"base", "stream"}},
    {"front", {"base", "trace"}},
    {"geometry", {"base"}},
    {"join", {"base", "geometry"}},
    {"slices", {"base", "geometry", "stream", "trace"}},
    {"stream", {"base"}},
    {"trace", {"base", "geometry"}},
};

TEST_CASE("a folder of the library includes headers of exactly its listed folders") {
  std::map<std::string, std::set<std::string>> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(library / "discmc")) {
    const std::string folder = entry.path().parent_path().filename().string();
    if (!entry.is_regular_file() || folder == "discmc") continue;
    std::set<std::string>& folders = found[folder];
    for (const std::string& name : included_by(fs::relative(entry.path(), library).string())) {
      const std::string other = fs::path(name).parent_path().filename().string();
      if (other != folder && other != "discmc") folders.insert(other);
    }
  }
  CHECK(found == reached_folders);
}

TEST_CASE("the page of statuses lists every status of C++ and C with a remedy") {
  const std::string page = text_of(fs::path(DISCMC_SOURCE_DIR) / "docs/statuses.md");
  const auto check_all = [&page](const std::string& header, const std::string& first,
                                 const std::string& name) {
    const std::string text = text_of(library / header);
    const size_t begin = text.find(first), end = text.find("};", begin);
    REQUIRE(begin != std::string::npos);
    const std::regex line("\\n  (" + name + "),?\\s");
    size_t count = 0;
    for (std::sregex_iterator found(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                    text.begin() + static_cast<std::ptrdiff_t>(end), line);
         found != std::sregex_iterator(); ++found, ++count) {
      CAPTURE((*found)[1].str());
      CHECK(page.find("`" + (*found)[1].str() + "`") != std::string::npos);
    }
    return count;
  };
  CHECK(check_all("discmc/status.hpp", "enum class Status", "[a-z_]+") > 15);
  CHECK(check_all("discmc/discmc.h", "typedef uint8_t discmc_status", "DISCMC_[A-Z_]+") > 15);
}

TEST_CASE("discmc.hpp includes all user headers") {
  const std::set<std::string> included = included_by("discmc/discmc.hpp");
  for (const fs::directory_entry& entry : fs::directory_iterator(library / "discmc")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".hpp") continue;
    CAPTURE(name);
    CHECK(included.count("discmc/" + name) == 1);
  }
}
