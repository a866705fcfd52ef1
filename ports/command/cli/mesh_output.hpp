// The surface of a command as the mesh that it writes.
#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "extraction/crossings.hpp"
#include "files/output_file.hpp"
#include "mesh_files/file_mesh.hpp"
#include "meshing.hpp"
#include "surface/components.hpp"
#include "surface/surface.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Returns where the mesh of an input lies; nothing: at index times spacing. placement: that the
/// input declares. Throws std::invalid_argument if a patient's space is asked for and the input
/// declares none.
std::optional<VolumePlacement> mesh_placement(const std::string& input,
                                              const std::optional<VolumePlacement>& placement,
                                              const std::optional<MeshSpace>& asked);

/// The mesh of a surface; voxel (i, j, k) lies at (i, j, k) times the spacing.
FileMesh triangulated(const Surface& surface, const MeshingOptions& options);

/// Moves crossings to where they are with --surface relaxed. tolerance: of the mesh.
void relax_noted(Crossings& crossings, const Surface& surface, Border border, double tolerance);

/// Moves a mesh, once and last, to where its file has it. placement: as of mesh_placement().
void place_in_file(FileMesh& mesh, const std::optional<VolumePlacement>& placement,
                   const MeshSize& size);

/// Calls write with the stream of the file; errors get the name of the file.
void write_to(OutputFile& file, const std::function<void(std::ostream&)>& write);

/// Whether the mesh is closed as the file holds it: as is_closed(), and no vertices fall together.
bool is_closed_in(const std::string& file, const FileMesh& mesh);

/// Prints how coarse the coordinates in the file are, if its format has too few digits for them.
void note_rounding(const std::string& file, const FileMesh& mesh);

/// Prints which polygons of the surface the mesh lacks, if any. left_out: as FaceMesh.
void note_left_out(const std::string& input, const Surface& surface,
                   const std::vector<std::uint32_t>& left_out);

/// Removes the components that are not chosen, and prints how many are kept, if not all. name: of
/// the volume or stream, and of the surface if there are several.
void keep_chosen(const std::string& name, const ComponentChoice& choice, Surface& surface);

/// Prints that a decimated mesh has more triangles than were asked for, if it has. name: as
/// keep_chosen().
void note_decimated(const std::string& name, const Decimation& decimation, std::size_t triangles);

/// A second pass over the volume of a mesh.
void add_gradient_normals(SliceReader& volume, FileMesh& mesh);

}  // namespace discmc::command
