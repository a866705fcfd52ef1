// Build files with a list of sources list all of them. The others use all files of the folders.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "project_text.hpp"

namespace {

const std::filesystem::path project = DISCMC_SOURCE_DIR;

using Names = std::set<std::string>;

Names sources_in_lib() {
  Names names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(project / "lib"))
    if (entry.path().extension() == ".cpp")
      names.insert(entry.path().lexically_relative(project / "lib").generic_string());
  return names;
}

// The sources that a file names, after `prefix`.
Names sources_named_in(const std::string& file, const std::string& prefix) {
  const std::string all = discmc::test::text_of(file);
  const std::regex source(prefix + R"((discmc/[a-z0-9_/]+\.cpp))");
  Names names;
  for (std::sregex_iterator found(all.begin(), all.end(), source), end; found != end; ++found)
    names.insert((*found)[1].str());
  return names;
}

}  // namespace

TEST_CASE("CMake and Meson compile exactly the source files of the library") {
  const Names sources = sources_in_lib();
  CHECK(sources.size() > 40);
  CHECK(sources_named_in("lib/CMakeLists.txt", "\\n  ") == sources);
  CHECK(sources_named_in("meson.build", "'lib/") == sources);
}
