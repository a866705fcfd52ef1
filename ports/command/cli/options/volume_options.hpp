// Options of commands that read a volume: how its file is read, and which surface of it is taken.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* volume_group = "Volume";

/// The layout of a headerless file; what is chosen of a file, and how it is read; the part that is
/// taken. options: must outlive the parsing.
void add_volume_options(CLI::App& app, VolumeOptions& options);

/// Takes the arguments behind a volume as further files of it: a shell puts them in the place of a
/// pattern. Limit: in the callback of an app that allows extras. Throws: CLI::ExtrasError where
/// they are no volumes.
void take_other_files(const CLI::App& app, VolumeOptions& options);

/// --iso, --range and --label: one of them, and of extract several times.
void add_selection_options(CLI::App& app, std::vector<NamedSelection>& selections);

constexpr const char* surface_group = "Surface";

/// --labels and --label-table. The options of add_surface_options() come before. labels: those that
/// are asked for. result: what each label becomes.
void add_label_options(CLI::App& app, std::string& labels, VolumeArguments& arguments,
                       const std::string& result);

/// Refuses a table without labels, and labels with what would change their voxels. Throws:
/// CLI::ValidationError.
void check_label_options(const std::string& labels, const VolumeArguments& arguments);

/// Adds the options of selections, --border, --median, --mask, --allow-empty, --memory and
/// --capacities.
void add_surface_options(CLI::App& app, VolumeArguments& arguments);

}  // namespace discmc::command
