// Options under "Mesh": what a mesh holds; and the file that it is written to.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* mesh_group = "Mesh";

/// -o, of a stream or a mesh by its extension. standard_output: what "-" is.
CLI::Option* add_output_option(CLI::App& app, std::string& output,
                               const std::string& standard_output);

/// --format, of what goes to standard output.
void add_format_option(CLI::App& app, std::string& format);

/// Puts the format into the name of the output. Throws: CLI::ValidationError where the output is a
/// file, which has it in its own name.
void take_format(const std::string& format, std::string& output);

/// --normals. gradient: where those of the gradient come from.
void add_normals_option(CLI::App& app, Normals& normals, const std::string& gradient);

/// --faces and --conforming.
void add_mesh_options(CLI::App& app, MeshingOptions& mesh);

/// --largest, --min-volume and --fill: what of the surface is kept.
void add_component_options(CLI::App& app, ComponentChoice& components);

/// Only what is written whole can be chosen from. Throws: CLI::ValidationError.
void check_components(const ComponentChoice& components, const std::string& output);

/// Refuses to choose among parts of a surface that is open.
void check_closed(const ComponentChoice& components, Border border);

/// --space.
void add_space_option(CLI::App& app, std::optional<MeshSpace>& space);

/// Only meshes have coordinates to choose. Throws: CLI::ValidationError.
void check_space(const std::optional<MeshSpace>& space, const std::string& output);

/// --unit and --scale.
void add_size_options(CLI::App& app, MeshSize& size);

/// Only formats without a unit of their own can have another one. Throws: CLI::ValidationError.
void check_size(const MeshSize& size, const std::string& output);

/// --surface and --tolerance. interpolated: when this is a default of --surface, or none.
void add_surface_kind_options(CLI::App& app, SurfaceKind& surface, double& tolerance,
                              const std::string& interpolated = {});

/// --triangles and --max-error: how far a mesh is decimated.
void add_decimation_options(CLI::App& app, Decimation& decimation);

/// Only conforming triangles of a mesh are decimated. Throws: CLI::ValidationError.
void check_decimation(const Decimation& decimation, const MeshingOptions& mesh,
                      const std::string& output);

/// Vertices are moved in conforming triangles, in a mesh. Throws: CLI::ValidationError.
void check_surface_kind(SurfaceKind surface, const MeshingOptions& mesh, const std::string& output);

/// Only vertices that are moved have a tolerance. Throws: CLI::ValidationError.
void check_tolerance(SurfaceKind surface, const CLI::App& app);

/// Only some formats hold polygons. Throws: CLI::ValidationError.
void check_faces(Faces faces, const std::string& output);

/// Only some formats hold normals of vertices. Throws: CLI::ValidationError.
void check_normals(Normals normals, const std::string& output, bool has_samples);

}  // namespace discmc::command
