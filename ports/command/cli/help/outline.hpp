// The command line as data, read off its definition: help, manual and completions are made of it.
#ifndef DISCMC_COMMAND_CLI_HELP_OUTLINE_HPP
#define DISCMC_COMMAND_CLI_HELP_OUTLINE_HPP

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

}  // namespace discmc::command

#endif
