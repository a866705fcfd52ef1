// Numbers that a text is, from its first character to its last.
#ifndef DISCMC_COMMAND_TEXT_NUMBER_TEXT_HPP
#define DISCMC_COMMAND_TEXT_NUMBER_TEXT_HPP

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

namespace discmc::command {

/// A decimal number, whatever the user's locale; "inf" and "nan", in any case, are such. Nothing
/// where the text is none, or beyond what double holds.
inline std::optional<double> decimal_number(std::string_view text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  if (has_plus) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? std::optional<double>(value) : std::nullopt;
}

/// The same, but for infinite ones and NaN.
inline std::optional<double> finite_number(std::string_view text) {
  const auto value = decimal_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Nothing where the text is no whole number, or one that the type does not hold.
template <class Whole>
std::optional<Whole> whole_number(std::string_view text, int base = 10) {
  Whole value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? std::optional<Whole>(value) : std::nullopt;
}

}  // namespace discmc::command

#endif
