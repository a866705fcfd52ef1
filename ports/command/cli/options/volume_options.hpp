// Options of commands that read a volume: how to read its file, and which surface to extract.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* volume_group = "Volume";

/// Adds the options for the layout of a headerless file, for the choice among a file's volumes, and
/// for the cropped part. options: must outlive the parsing.
void add_volume_options(CLI::App& app, VolumeOptions& options);

/// Accepts the arguments behind a volume as further files of it, because a shell expands a pattern
/// to them. Limit: in the callback of an app that allows extras. Throws CLI::ExtrasError if they
/// are not volumes.
void add_other_files(const CLI::App& app, VolumeOptions& options);

/// Adds --iso, --range and --label. Commands accept one of them; extract accepts several.
void add_selection_options(CLI::App& app, std::vector<NamedSelection>& selections);

constexpr const char* surface_group = "Surface";

/// Adds --labels and --label-table. Call add_surface_options() before. labels: the requested ones.
/// result: what each label becomes, for the help.
void add_label_options(CLI::App& app, std::string& labels, VolumeArguments& arguments,
                       const std::string& result);

/// Refuses a label table without labels, and options that would change the voxels of labels. Throws
/// CLI::ValidationError.
void check_label_options(const std::string& labels, const VolumeArguments& arguments);

/// Adds the options of selections, --border, --median, --mask, --allow-empty, --memory and
/// --capacities.
void add_surface_options(CLI::App& app, VolumeArguments& arguments);

}  // namespace discmc::command
