// Completions of the command line for shells.
#ifndef DISCMC_COMMAND_CLI_HELP_COMPLETIONS_HPP
#define DISCMC_COMMAND_CLI_HELP_COMPLETIONS_HPP

#include <string>

#include "outline.hpp"

namespace discmc::command {

// Scripts for a shell each. They complete commands, options, the words that a value can be, and
// else names of files.

std::string bash_completions(const CommandOutline& program);
std::string zsh_completions(const CommandOutline& program);
std::string fish_completions(const CommandOutline& program);

}  // namespace discmc::command

#endif
