// Options under "Volume": how the file of a volume is read.
#ifndef DISCMC_COMMAND_CLI_OPTIONS_VOLUME_OPTIONS_HPP
#define DISCMC_COMMAND_CLI_OPTIONS_VOLUME_OPTIONS_HPP

#include <CLI/CLI.hpp>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* volume_group = "Volume";

/// --dims, --type, --big-endian and --skip-bytes, the layout of a headerless file; --spacing,
/// --frame, --channel, --series and --allow-gaps; --crop and --shrink.
void add_volume_options(CLI::App& app, LayoutArguments& arguments);

}  // namespace discmc::command

#endif
