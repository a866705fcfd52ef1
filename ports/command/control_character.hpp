// Characters that neither terminals nor names of files should get.
#ifndef DISCMC_COMMAND_CONTROL_CHARACTER_HPP
#define DISCMC_COMMAND_CONTROL_CHARACTER_HPP

namespace discmc::host {

/// Whether a byte of text is a control character of ASCII.
constexpr bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace discmc::host

#endif
