// Formats values, and parses whole numbers. This is apart from number_text.hpp because the page's
// module parses no decimal numbers.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace discmc::command {

/// Returns nothing if the text is not a whole number in the range of the type.
template <class Whole>
std::optional<Whole> whole_number(std::string_view text, int base = 10) {
  Whole value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? std::optional<Whole>(value) : std::nullopt;
}

/// Formats the value in decimal, in at most 15 digits, without trailing zeros. A value of 32-bit
/// floating point has the digits of that type: 0.1, not 0.100000001490116.
std::string value_text(double value);

/// Formats 1234567 as 1,234,567.
inline std::string grouped(std::uint64_t value) {
  std::string digits = std::to_string(value);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

}  // namespace discmc::command
