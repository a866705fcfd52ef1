// Numbers that a text is, from its first character to its last.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "text/value_text.hpp"
#include "text/words.hpp"

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

/// The same, with blanks around it, and with a comma for the point as some write it.
inline std::optional<double> decimal(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  return finite_number(trimmed(text));
}

/// The number in six digits at most, for people.
inline std::string short_number(double value) {
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end};
}

}  // namespace discmc::command
