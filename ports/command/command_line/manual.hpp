// The manual page.
#ifndef DISCMC_COMMAND_COMMAND_LINE_MANUAL_HPP
#define DISCMC_COMMAND_COMMAND_LINE_MANUAL_HPP

#include <string>

#include "outline.hpp"

namespace discmc::host {

/// In troff, for man(1): all commands with their options.
std::string manual(const CommandOutline& program, const std::string& version);

}  // namespace discmc::host

#endif
