// The programs of the README are examples that the tests compile and run.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "project_text.hpp"

namespace {

using discmc::test::text_of;

std::vector<std::string> blocks_of(const std::string& markdown, const std::string& language) {
  const std::string fence = "```" + language + "\n";
  std::vector<std::string> blocks;
  for (size_t begin = markdown.find(fence); begin != std::string::npos;
       begin = markdown.find(fence, begin)) {
    begin += fence.size();
    blocks.push_back(markdown.substr(begin, markdown.find("\n```", begin) + 1 - begin));
  }
  return blocks;
}

}  // namespace

TEST_CASE(
    "the README's mesh.cpp and firmware.cpp equal the examples and have at most 10 and 40 lines") {
  const std::vector<std::string> programs = blocks_of(text_of("README.md"), "cpp");
  REQUIRE(programs.size() == 2);
  CHECK(programs[0] == text_of("examples/mesh.cpp"));
  CHECK(std::count(programs[0].begin(), programs[0].end(), '\n') <= 11);
  CHECK(programs[1] == text_of("examples/firmware.cpp"));
  CHECK(std::count(programs[1].begin(), programs[1].end(), '\n') <= 40);
}
