// Options under "Surface": which surface of a volume is taken, and in which memory.
#ifndef DISCMC_COMMAND_CLI_OPTIONS_SURFACE_OPTIONS_HPP
#define DISCMC_COMMAND_CLI_OPTIONS_SURFACE_OPTIONS_HPP

#include <CLI/CLI.hpp>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* surface_group = "Surface";

/// Those of selections, --border, --median, --mask, --allow-empty, --memory and --capacities.
void add_surface_options(CLI::App& app, VolumeArguments& arguments);

}  // namespace discmc::command

#endif
