// The commands with their options, as --help, the manual page and the shells show them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace discmc::command {

/// An option, or an argument without dashes.
struct OptionOutline {
  std::vector<std::string> names;    ///< "-o" and "--output"; "VOLUME" for an argument
  std::string value;                 ///< the value: "FILE", "closed|open"; empty for a flag
  std::vector<std::string> choices;  ///< "closed" and "open": the lower-case words of `value`
  std::string description;           ///< includes the default
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
  std::string footer;  ///< lines to print unchanged

  /// "discmc decode [OPTIONS] -o FILE STREAM"
  std::string usage;
};

/// Limit: subcommands have no subcommands.
CommandOutline outline_of(const CLI::App& app);

/// Returns lines of at most 80 columns, unless a single word is longer.
std::string help(const CommandOutline& outline);

/// Returns troff for man(1), with all commands and their options.
std::string manual(const CommandOutline& program, const std::string& version);

// Return completion scripts, one per shell. They complete commands, options, words of values, and
// otherwise file names.

std::string bash_completions(const CommandOutline& program);
std::string zsh_completions(const CommandOutline& program);
std::string fish_completions(const CommandOutline& program);

}  // namespace discmc::command
