// Characters that neither terminals nor names of files should get.
#ifndef DISCMC_COMMAND_TEXT_CONTROL_CHARACTER_HPP
#define DISCMC_COMMAND_TEXT_CONTROL_CHARACTER_HPP

#include <algorithm>
#include <string>

namespace discmc::command {

/// Whether a byte of text is a control character of ASCII.
constexpr bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// The text with underscores in their place.
inline std::string without_control(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control, '_');
  return text;
}

}  // namespace discmc::command

#endif
