// Options under "Surface": which surface of a volume is taken, and in which memory.
#ifndef DISCMC_COMMAND_COMMAND_LINE_SURFACE_OPTIONS_HPP
#define DISCMC_COMMAND_COMMAND_LINE_SURFACE_OPTIONS_HPP

#include <CLI/CLI.hpp>

#include "commands/arguments.hpp"

namespace discmc::host {

constexpr const char* surface_group = "Surface";

/// Those of selections, --border, --median, --mask, --allow-empty, --memory and --capacities.
void add_surface_options(CLI::App& app, VolumeArguments& arguments);

}  // namespace discmc::host

#endif
