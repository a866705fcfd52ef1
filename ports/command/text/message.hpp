// Messages on standard error.
#pragma once

#include <iostream>
#include <string>

namespace discmc::command {

/// Returns the name of an input for messages; "-" is standard input.
inline std::string display_name(const std::string& input) {
  return input == "-" ? "standard input" : input;
}

/// Prints a line about an input or an output. Errors are exceptions, which main() prints.
inline void print_message(const std::string& input, const std::string& text) {
  std::cerr << "discmc: " + display_name(input) + ": " + text + '\n';
}

}  // namespace discmc::command
