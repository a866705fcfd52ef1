// Options under "Surface": which surface of a volume is taken, and in which memory.
#ifndef DISCMC_COMMAND_CLI_OPTIONS_SURFACE_OPTIONS_HPP
#define DISCMC_COMMAND_CLI_OPTIONS_SURFACE_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <string>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* surface_group = "Surface";

/// --labels. The options of add_surface_options() come before. result: what each label becomes.
void add_labels_option(CLI::App& app, std::string& labels, const std::string& result);

/// --label-table.
void add_label_table_option(CLI::App& app, std::string& file);

/// Those of selections, --border, --median, --mask, --allow-empty, --memory and --capacities.
void add_surface_options(CLI::App& app, VolumeArguments& arguments);

}  // namespace discmc::command

#endif
