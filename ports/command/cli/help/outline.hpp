// The commands with their options, as --help, the manual page and the shells show them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace discmc::command {

/// An option, or an argument without dashes.
struct OptionOutline {
  std::vector<std::string> names;    ///< "-o" and "--output"; of an argument "VOLUME"
  std::string value;                 ///< what follows: "FILE", "closed|open"; empty of a flag
  std::vector<std::string> choices;  ///< "closed" and "open": the words of value in lower case
  std::string description;           ///< with what it is when not given
  bool takes_file = false;
  bool is_repeated = false;
};

/// Options under one heading.
struct GroupOutline {
  std::string title;
  std::vector<OptionOutline> options;
};

struct CommandOutline {
  std::string name;
  std::string description;
  std::vector<OptionOutline> arguments;
  std::vector<GroupOutline> groups;
  std::vector<CommandOutline> commands;
  std::string footer;  ///< lines as they are to be shown

  /// "discmc decode [OPTIONS] -o FILE STREAM"
  std::string usage;
};

/// Limit: commands have no commands.
CommandOutline outline_of(const CLI::App& app);

/// In lines of 80 columns at most, but for words that are longer.
std::string help(const CommandOutline& outline);

/// In troff, for man(1): all commands with their options.
std::string manual(const CommandOutline& program, const std::string& version);

// Scripts for a shell each. They complete commands, options, the words that a value can be, and
// else names of files.

std::string bash_completions(const CommandOutline& program);
std::string zsh_completions(const CommandOutline& program);
std::string fish_completions(const CommandOutline& program);

}  // namespace discmc::command
