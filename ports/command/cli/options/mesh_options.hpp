// Options under "Mesh": the content of a mesh and its file.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/arguments.hpp"

namespace discmc::command {

constexpr const char* mesh_group = "Mesh";

/// Adds -o, for a stream or a mesh by its extension. standard_output: describes "-".
CLI::Option* add_output_option(CLI::App& app, std::string& output,
                               const std::string& standard_output);

/// Adds --format, the format of standard output.
void add_format_option(CLI::App& app, std::string& format);

/// Adds the format to the name of the output. Throws CLI::ValidationError if the output is a file,
/// whose name already has an extension.
void add_format_to_name(const std::string& format, std::string& output);

/// Adds --normals. gradient: describes the source of gradients.
void add_normals_option(CLI::App& app, Normals& normals, const std::string& gradient);

/// Adds --faces and --conforming.
void add_mesh_options(CLI::App& app, MeshingOptions& mesh);

/// Adds --largest, --min-volume and --fill, which choose components of the surface.
void add_component_options(CLI::App& app, ComponentChoice& components);

/// Refuses to choose components of an output that is written in pieces. Throws
/// CLI::ValidationError.
void check_components(const ComponentChoice& components, const std::string& output);

/// Refuses to choose components of an open surface.
void check_closed(const ComponentChoice& components, Border border);

/// Adds --space.
void add_space_option(CLI::App& app, std::optional<MeshSpace>& space);

/// Refuses a space for outputs other than meshes. Throws CLI::ValidationError.
void check_space(const std::optional<MeshSpace>& space, const std::string& output);

/// Adds --unit and --scale.
void add_size_options(CLI::App& app, MeshSize& size);

/// Refuses a unit for formats that define their own. Throws CLI::ValidationError.
void check_size(const MeshSize& size, const std::string& output);

/// Adds --surface and --tolerance. interpolated: describes when this kind is the default, or is
/// empty.
void add_surface_kind_options(CLI::App& app, SurfaceKind& surface, double& tolerance,
                              const std::string& interpolated = {});

/// Adds --triangles and --max-error, the target of the decimation.
void add_decimation_options(CLI::App& app, Decimation& decimation);

/// Refuses to decimate anything but conforming triangles. Throws CLI::ValidationError.
void check_decimation(const Decimation& decimation, const MeshingOptions& mesh,
                      const std::string& output);

/// Refuses to move vertices of anything but conforming triangles. Throws CLI::ValidationError.
void check_surface_kind(SurfaceKind surface, const MeshingOptions& mesh, const std::string& output);

/// Refuses a tolerance if no vertices are moved. Throws CLI::ValidationError.
void check_tolerance(SurfaceKind surface, const CLI::App& app);

/// Refuses polygons in formats without them. Throws CLI::ValidationError.
void check_faces(Faces faces, const std::string& output);

/// Refuses normals in formats without them. Throws CLI::ValidationError.
void check_normals(Normals normals, const std::string& output, bool has_samples);

}  // namespace discmc::command
