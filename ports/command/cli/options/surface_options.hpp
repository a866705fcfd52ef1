// Options under "Surface": which surface of a volume is taken, and in which memory.
#ifndef DISCMC_COMMAND_CLI_OPTIONS_SURFACE_OPTIONS_HPP
#define DISCMC_COMMAND_CLI_OPTIONS_SURFACE_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <string>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* surface_group = "Surface";

/// --labels and --label-table. The options of add_surface_options() come before. labels: those that
/// are asked for. result: what each label becomes.
void add_label_options(CLI::App& app, std::string& labels, VolumeArguments& arguments,
                       const std::string& result);

/// Refuses a table without labels, and labels with what would change their voxels. Throws:
/// CLI::ValidationError.
void check_label_options(const std::string& labels, const VolumeArguments& arguments);

/// Those of selections, --border, --median, --mask, --allow-empty, --memory and --capacities.
void add_surface_options(CLI::App& app, VolumeArguments& arguments);

}  // namespace discmc::command

#endif
