// Options under "Volume": how the file of a volume is read.
#ifndef DISCMC_COMMAND_CLI_OPTIONS_VOLUME_OPTIONS_HPP
#define DISCMC_COMMAND_CLI_OPTIONS_VOLUME_OPTIONS_HPP

#include <CLI/CLI.hpp>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* volume_group = "Volume";

/// The layout of a headerless file; what is chosen of a file, and how it is read; the part that is
/// taken. options: must outlive the parsing.
void add_volume_options(CLI::App& app, VolumeOptions& options);

}  // namespace discmc::command

#endif
