// All places that name the version name the same one.
#include <discmc/version.h>

#include <discmc/version.h>
#include <regex>

#include "project_text.hpp"
#include "test.hpp"

namespace {

using discmc::test::text_of;

// Returns the first version in a file after the given text.
std::string version_after(const std::string& text, const std::string& path) {
  std::smatch found;
  const std::string all = text_of(path);
  std::regex_search(all, found, std::regex(text + R"((\d+\.\d+\.\d+))"));
  return found.empty() ? path + " names no version" : found[1].str();
}

}  // namespace

TEST_CASE("the version consists of major, minor and patch, in the library and the headers") {
  const std::string version = DISCMC_VERSION_STRING;
  CHECK(version == std::to_string(DISCMC_VERSION_MAJOR) + "." +
                       std::to_string(DISCMC_VERSION_MINOR) + "." +
                       std::to_string(DISCMC_VERSION_PATCH));
  CHECK(version == discmc::version());
}

TEST_CASE("all files of the project contain the same version") {
  const std::string version = DISCMC_VERSION_STRING;
  CHECK(version_after("project\\(discmc\\s+VERSION ", "CMakeLists.txt") == version);
  CHECK(version_after("project\\(discmc\\s+VERSION ", "packaging/CMakeLists.txt") == version);
  if (text_of("CHANGELOG.md").find("\n## [Unreleased]\n") == std::string::npos)
    CHECK(version_after("\n## \\[", "CHANGELOG.md") == version);
  CHECK(version_after("discmc-", "docs/packaging.md") == version);
  CHECK(version_after("project\\(discmc\\s+VERSION ", "packaging/CMakeLists.txt") == version);
  CHECK(version_after("version: '", "meson.build") == version);
  CHECK(version_after("\nversion = \"", "ports/python/pyproject.toml") == version);
  CHECK(version_after("name = \"discmc\",\\s+version = \"", "MODULE.bazel") == version);
  CHECK(version_after("\"version\": \"", "library.json") == version);
  CHECK(version_after("version: \"", "idf_component.yml") == version);
  CHECK(version_after("\"version\": \"", "packaging/vcpkg/discmc/vcpkg.json") == version);
}
