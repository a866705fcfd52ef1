// Options under "Stream": which of its surfaces.
#ifndef DISCMC_COMMAND_CLI_OPTIONS_STREAM_OPTIONS_HPP
#define DISCMC_COMMAND_CLI_OPTIONS_STREAM_OPTIONS_HPP

#include <CLI/CLI.hpp>

#include "streams/stream_reader.hpp"

namespace discmc::command {

constexpr const char* stream_group = "Stream";

/// --stream-channel and --scan.
void add_choice_options(CLI::App& app, StreamChoice& choice);

}  // namespace discmc::command

#endif
