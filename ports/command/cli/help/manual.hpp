// The manual page.
#ifndef DISCMC_COMMAND_CLI_HELP_MANUAL_HPP
#define DISCMC_COMMAND_CLI_HELP_MANUAL_HPP

#include <string>

#include "outline.hpp"

namespace discmc::command {

/// In troff, for man(1): all commands with their options.
std::string manual(const CommandOutline& program, const std::string& version);

}  // namespace discmc::command

#endif
