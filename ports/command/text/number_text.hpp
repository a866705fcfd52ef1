// Numbers that a text is, from its first character to its last.
#ifndef DISCMC_COMMAND_TEXT_NUMBER_TEXT_HPP
#define DISCMC_COMMAND_TEXT_NUMBER_TEXT_HPP

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace discmc::command {

/// Nothing where the text is no number, an infinite one, or beyond what double holds.
inline std::optional<double> finite_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_number = !text.empty() && *end == '\0' && std::isfinite(value);
  return is_number ? std::optional<double>(value) : std::nullopt;
}

/// Nothing where the text is no whole number, or one that the type does not hold.
template <class Whole>
std::optional<Whole> whole_number(std::string_view text, int base = 10) {
  Whole value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? std::optional<Whole>(value) : std::nullopt;
}

/// The number in six digits at most, for people.
inline std::string short_number(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

}  // namespace discmc::command

#endif
