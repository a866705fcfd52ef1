// What --help prints.
#ifndef DISCMC_COMMAND_CLI_HELP_HELP_HPP
#define DISCMC_COMMAND_CLI_HELP_HELP_HPP

#include <string>

#include "outline.hpp"

namespace discmc::command {

/// In lines of 80 columns at most, but for words that are longer.
std::string help(const CommandOutline& outline);

}  // namespace discmc::command

#endif
