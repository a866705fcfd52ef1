// Options under "Volume": how the file of a volume is read.
#ifndef DISCMC_COMMAND_COMMAND_LINE_VOLUME_OPTIONS_HPP
#define DISCMC_COMMAND_COMMAND_LINE_VOLUME_OPTIONS_HPP

#include <CLI/CLI.hpp>

#include "commands/arguments.hpp"

namespace discmc::host {

constexpr const char* volume_group = "Volume";

/// --dims, --type, --big-endian and --skip-bytes, the layout of a headerless file; --spacing,
/// --frame, --series and --allow-gaps; --crop and --shrink.
void add_volume_options(CLI::App& app, LayoutArguments& arguments);

}  // namespace discmc::host

#endif
