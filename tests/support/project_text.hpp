// Files of the project as text, for tests of their contents.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace discmc::test {

/// path: within the project, or absolute.
inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(std::filesystem::path(DISCMC_SOURCE_DIR) / path);
  REQUIRE_MESSAGE(file.is_open(), path.string());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace discmc::test
