// Numbers as text.
#include "text/number_text.hpp"

#include "test.hpp"

using discmc::command::decimal_number;
using discmc::command::finite_number;

TEST_CASE("a text is a decimal number only if it has no other characters") {
  const std::vector<std::pair<std::string, double>> numbers = {
      {"0", 0},  {"1", 1},       {"+1.5", 1.5}, {"-2e3", -2000}, {".5", 0.5},
      {"5.", 5}, {"1E-2", 0.01}, {"0.1", 0.1},  {"-0.0", 0}};
  for (const auto& each : numbers) {
    const auto& [text, number] = each;
    INFO(each.first);
    CHECK(decimal_number(text) == number);
    CHECK(finite_number(text) == number);
  }
  for (const std::string text :
       {"", "+", "-", "x", "1x", " 1", "1 ", "0x10", "1,5", "+-1", "++1", "e5", "1e400", "1..2"}) {
    INFO(text);
    CHECK_FALSE(decimal_number(text));
  }
}

TEST_CASE("infinite numbers and NaN are decimal numbers, and not finite") {
  for (const std::string text : {"inf", "-INF", "nan", "NaN", "-nan"}) {
    INFO(text);
    REQUIRE(decimal_number(text));
    CHECK_FALSE(std::isfinite(*decimal_number(text)));
    CHECK_FALSE(finite_number(text));
  }
}
