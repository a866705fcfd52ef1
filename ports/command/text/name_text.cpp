#include "name_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "words.hpp"

namespace discmc::command {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

// Returns 0 for a byte that begins no character.
std::size_t length_by_first_byte(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC0 || first >= 0xF8) return 0;
  if (first >= 0xF0) return 4;
  return first >= 0xE0 ? 3 : 2;
}

// Returns the length of the first character, or 0 if the text does not begin with a valid one.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = length_by_first_byte(first);
  if (length <= 1) return length;
  if (length > text.size()) return 0;
  std::uint32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0U) != 0x80) return 0;
    code = code << 6 | (next & 0x3FU);
  }
  constexpr std::uint32_t min_code[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  const bool is_none = (code & 0xFFFEU) == 0xFFFE;
  return code < min_code[length] || code > 0x10FFFF || is_surrogate || is_none ? 0 : length;
}

// add: called with each valid character, and with U+FFFD for each invalid byte.
template <class Add>
void for_each_character(std::string_view text, Add add) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    add(length > 0 ? text.substr(0, length) : replacement);
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
}

std::string unicode_escape(char control) {
  constexpr const char* digits = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(control);
  return std::string("\\u00") + digits[code >> 4U] + digits[code & 0xFU];
}

std::string_view xml_escape(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return {};
  }
}

}  // namespace

std::string json_string(std::string_view name) {
  std::string text = "\"";
  for_each_character(name, [&text](std::string_view character) {
    if (is_control(character[0])) {
      text += unicode_escape(character[0]);
      return;
    }
    if (character == "\"" || character == "\\") text += '\\';
    text += character;
  });
  return text + "\"";
}

std::string xml_attribute(std::string_view name) {
  std::string text;
  for_each_character(name, [&text](std::string_view character) {
    const std::string_view escape = xml_escape(character[0]);
    if (is_control(character[0]))
      text += replacement;
    else
      text += escape.empty() ? character : escape;
  });
  return text;
}

std::string utf8(std::string_view text) {
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = character_length(rest);
    if (length > 1) return std::string(text);
    rest.remove_prefix(1);
  }
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80) result += static_cast<char>(0xC0U | code >> 6U);
    result += code >= 0x80 ? static_cast<char>(0x80U | (code & 0x3FU)) : c;
  }
  return result;
}

}  // namespace discmc::command
