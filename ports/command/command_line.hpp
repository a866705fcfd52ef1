// How the arguments of the commands are told and checked.
#ifndef DISCMC_COMMAND_COMMAND_LINE_HPP
#define DISCMC_COMMAND_COMMAND_LINE_HPP

#include <CLI/CLI.hpp>

#include "commands/arguments.hpp"

namespace discmc::host {

/// Adds `extract` to a command line that fills the arguments, which must outlive the parsing.
void add_extract(CLI::App& app, ExtractArguments& arguments);

/// Adds `decode` and `info` likewise.
void add_stream_commands(CLI::App& app, StreamArguments& arguments);

/// Adds `render` likewise.
void add_render(CLI::App& app, RenderArguments& arguments);

}  // namespace discmc::host

#endif
