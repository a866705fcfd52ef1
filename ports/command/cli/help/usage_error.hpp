// The message for a command line that cannot be parsed.
#ifndef DISCMC_COMMAND_CLI_HELP_USAGE_ERROR_HPP
#define DISCMC_COMMAND_CLI_HELP_USAGE_ERROR_HPP

#include <CLI/CLI.hpp>
#include <string>

namespace discmc::command {

/// For CLI::App::failure_message. Reports unknown options first, with the nearest known name: an
/// unknown option often causes the error of another.
std::string usage_error(const CLI::App* app, const CLI::Error& error);

}  // namespace discmc::command

#endif
