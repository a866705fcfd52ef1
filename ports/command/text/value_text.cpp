#include "value_text.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace discmc::command {
namespace {

bool is_short_and_whole(double value) {
  constexpr double max_whole = 1e15;
  return std::fabs(value) < max_whole && value == std::floor(value);
}

std::string in_digits(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

bool is_of_32_bits(double value) {
  return std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max()) &&
         static_cast<double>(static_cast<float>(value)) == value;
}

}  // namespace

std::string value_text(double value) {
  if (is_short_and_whole(value)) return in_digits(value, std::numeric_limits<double>::digits10);
  if (is_of_32_bits(value))
    for (int digits = 7; digits <= std::numeric_limits<float>::max_digits10; ++digits) {
      std::string text = in_digits(value, digits);
      if (static_cast<double>(std::strtof(text.c_str(), nullptr)) == value) return text;
    }
  return in_digits(value, std::numeric_limits<double>::digits10);
}

}  // namespace discmc::command
