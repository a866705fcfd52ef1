// Converts the surface of a command to the mesh that is written.
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

/// Returns the placement of an input's mesh, or nothing for index times spacing. placement: as the
/// input declares it. Throws std::invalid_argument if a patient's space is requested and the input
/// declares none.
std::optional<VolumePlacement> mesh_placement(const std::string& input,
                                              const std::optional<VolumePlacement>& placement,
                                              const std::optional<MeshSpace>& asked);

/// Returns the mesh of a surface; voxel (i, j, k) lies at (i, j, k) times the spacing.
FileMesh triangulated(const Surface& surface, const MeshingOptions& options);

/// Moves crossings to their places for --surface relaxed. tolerance: of the mesh.
void relax_noted(Crossings& crossings, const Surface& surface, Border border, double tolerance);

/// Moves a mesh to its place in the file; call this once, last. placement: from mesh_placement().
void place_in_file(FileMesh& mesh, const std::optional<VolumePlacement>& placement,
                   const MeshSize& size);

/// Calls write with the stream of the file, and adds the file's name to errors.
void write_to(OutputFile& file, const std::function<void(std::ostream&)>& write);

/// Whether the mesh is closed as written: is_closed(), and no two vertices coincide after rounding.
bool is_closed_in(const std::string& file, const FileMesh& mesh);

/// Prints the rounding of the coordinates in the file, if its format has too few digits for them.
void note_rounding(const std::string& file, const FileMesh& mesh);

/// Prints which polygons of the surface are missing in the mesh, if any. left_out: as FaceMesh.
void note_left_out(const std::string& input, const Surface& surface,
                   const std::vector<std::uint32_t>& left_out);

/// Removes the components that are not chosen, and prints how many are kept, if not all. name: of
/// the input, and of the surface if there are several.
void keep_chosen(const std::string& name, const ComponentChoice& choice, Surface& surface);

/// Prints that a decimated mesh has more triangles than were asked for, if it has. name: as
/// keep_chosen().
void note_decimated(const std::string& name, const Decimation& decimation, std::size_t triangles);

/// Computes normals in a second pass over the volume of a mesh.
void add_gradient_normals(SliceReader& volume, FileMesh& mesh);

}  // namespace discmc::command
