// Messages on standard error.
#pragma once

#include <iostream>
#include <string>

namespace discmc::command {

/// What an input is called, of which "-" is standard input.
inline std::string name_for_people(const std::string& input) {
  return input == "-" ? "standard input" : input;
}

/// Prints a line about an input or an output. Faults are thrown, and printed by main().
inline void print_message(const std::string& input, const std::string& text) {
  std::cerr << "discmc: " + name_for_people(input) + ": " + text + '\n';
}

}  // namespace discmc::command
