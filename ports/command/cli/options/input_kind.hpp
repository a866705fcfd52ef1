// Inputs that may be a stream or a volume, and the options of streams.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "meshing.hpp"
#include "streams/stream_reader.hpp"

namespace discmc::command {

/// Whether the input is a volume: by its name, otherwise by the given options. Returns nothing if
/// neither decides.
std::optional<bool> is_volume_input(const CLI::App& app, const std::string& input);

/// Throws CLI::ValidationError if the input is a mesh and an option needs a volume, a stream or the
/// making of a mesh.
void check_mesh_input(const CLI::App& app, const std::string& input);

/// Throws CLI::ValidationError if an option is for the other kind of input.
void check_kind(const CLI::App& app, const std::string& input, bool is_volume);

constexpr const char* stream_group = "Stream";

/// --stream-channel and --scan.
void add_choice_options(CLI::App& app, StreamChoice& choice);

}  // namespace discmc::command
