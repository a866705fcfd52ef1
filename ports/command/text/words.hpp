// Splits the text of headers into lines, words and letters.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace discmc::command {

/// Removes and returns the first line, without its line feed and carriage return; nothing at the
/// end.
std::optional<std::string_view> next_line(std::string_view& text);

/// Returns the text without blanks at either end.
std::string_view trimmed(std::string_view text);

/// Returns the text in lower case (ASCII letters only).
std::string lower(std::string_view text);

/// Returns the words between blanks.
std::vector<std::string_view> words(std::string_view text);

/// Whether a byte of text is a control character of ASCII.
constexpr bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// Returns the text with underscores for control characters.
inline std::string without_control(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control, '_');
  return text;
}

}  // namespace discmc::command
