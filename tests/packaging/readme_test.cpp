// The first program of the README is the example that the tests compile and run.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "project_text.hpp"

namespace {

using discmc::test::text_of;

std::string first_block(const std::string& markdown, const std::string& language) {
  const std::string fence = "```" + language + "\n";
  const size_t begin = markdown.find(fence);
  REQUIRE(begin != std::string::npos);
  const size_t end = markdown.find("\n```", begin);
  REQUIRE(end != std::string::npos);
  return markdown.substr(begin + fence.size(), end + 1 - begin - fence.size());
}

}  // namespace

TEST_CASE("the README's program is examples/firmware.cpp, in at most 40 lines") {
  const std::string program = first_block(text_of("README.md"), "cpp");
  CHECK(program == text_of("examples/firmware.cpp"));
  CHECK(std::count(program.begin(), program.end(), '\n') <= 40);
}
