// Turns polygons into the mesh that a caller gets.
#ifndef DISCMC_MESH_API_FINISHED_MESH_HPP
#define DISCMC_MESH_API_FINISHED_MESH_HPP

#include <functional>
#include <memory>
#include <optional>

#include "array_reader.hpp"
#include "discmc/mesh.hpp"
#include "extraction/crossings.hpp"
#include "extraction/selection.hpp"
#include "meshes/mesh.hpp"
#include "samples/volume_placement.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

/// Calls MeshOptions::progress. Throws Cancelled.
void report(const MeshOptions& options, const char* step, std::uint64_t done, std::uint64_t total);

/// Returns a function that calls report() for a step of several threads. The function does nothing
/// in threads other than this one.
std::function<void(std::uint64_t)> reporter_here(const MeshOptions& options, const char* step,
                                                 std::uint64_t total);

/// Returns the number of threads that the options request.
unsigned threads_of(const MeshOptions& options);

/// Whether vertices move to the positions where samples cross the level.
bool is_interpolated(const MeshOptions& options);

/// The axes of a sweep in the space of the mesh.
struct SweepAxes {
  std::array<double, 3> spacing;
  std::optional<VolumePlacement> placement;  ///< nothing: along the coordinates
  bool is_mirrored;
};

/// Throws std::invalid_argument if the level is NaN, or if its ends are in the wrong order.
Selection selection_of(const Level& level);

/// Throws std::invalid_argument if the axes span no space.
SweepAxes sweep_axes(const MeshOptions& options, const AxisOrder& order = {0, 1, 2});

/// Throws std::invalid_argument for options that contradict each other.
void check_options(const MeshOptions& options);

/// Opens the volume again, for gradients.
using OpenAgain = std::function<std::unique_ptr<SliceReader>()>;

/// Makes the triangles of a surface: relaxed, decimated, with normals, placed. surface: gets the
/// spacing. crossings: new positions of the vertices, before relaxation; null: vertices stay.
/// level: for the gradient. open_again: may be empty without Normals::gradient.
Mesh finished_mesh(Surface& surface, Crossings* crossings, const MeshOptions& options,
                   const SweepAxes& axes, double level, const OpenAgain& open_again = {});

}  // namespace discmc::meshing

#endif
