// Options that say which voxels are on.
#ifndef DISCMC_COMMAND_COMMAND_LINE_SELECTION_OPTIONS_HPP
#define DISCMC_COMMAND_COMMAND_LINE_SELECTION_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <vector>

#include "commands/arguments.hpp"

namespace discmc::host {

/// --iso, --range and --label: one of them, and of extract several times.
void add_selection_options(CLI::App& app, std::vector<NamedSelection>& selections);

}  // namespace discmc::host

#endif
