#include "numbered_name.hpp"

#include <algorithm>

namespace discmc::command {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

NumberedName::NumberedName(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (auto at = name.begin();;) {
    const auto first = std::find_if(at, name.end(), is_digit);
    texts.emplace_back(at, first);
    if (first == name.end()) return;
    at = std::find_if_not(first, name.end(), is_digit);
    digits.emplace_back(first, at);
    numbers.emplace_back(std::find_if(first, at, [](char c) { return c != '0'; }), at);
  }
}

}  // namespace discmc::command
