// Options that select the voxels that are on.
#ifndef DISCMC_COMMAND_CLI_OPTIONS_SELECTION_OPTIONS_HPP
#define DISCMC_COMMAND_CLI_OPTIONS_SELECTION_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <vector>

#include "cli/arguments.hpp"

namespace discmc::command {

/// --iso, --range and --label: one of them, and of extract several times.
void add_selection_options(CLI::App& app, std::vector<NamedSelection>& selections);

}  // namespace discmc::command

#endif
