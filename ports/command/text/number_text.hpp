// Parses texts that are numbers from the first character to the last.
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

/// Parses a decimal number in any locale, including "inf" and "nan" in any case. Returns nothing
/// for other text, and for numbers beyond the range of double.
inline std::optional<double> decimal_number(std::string_view text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  if (has_plus) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? std::optional<double>(value) : std::nullopt;
}

/// Likewise refuses infinite numbers and NaN.
inline std::optional<double> finite_number(std::string_view text) {
  const auto value = decimal_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Likewise accepts blanks around the number and a decimal comma.
inline std::optional<double> decimal(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  return finite_number(trimmed(text));
}

/// Formats the number in at most six digits.
inline std::string short_number(double value) {
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end};
}

}  // namespace discmc::command
