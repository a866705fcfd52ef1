// The message for a command line that cannot be parsed.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace discmc::command {

/// For CLI::App::failure_message. Reports unknown options first, with the nearest known name,
/// because an unknown option often causes other errors.
std::string usage_error(const CLI::App* app, const CLI::Error& error);

}  // namespace discmc::command
