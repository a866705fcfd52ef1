// From polygons to the mesh that a caller gets.
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
void report(const MeshOptions& options, const char* step, std::uint64_t done, std::uint64_t all);

/// Returns a function that calls report() with what is done, for a step of several threads. In
/// other threads than this one it does nothing.
std::function<void(std::uint64_t)> reporter_here(const MeshOptions& options, const char* step,
                                                 std::uint64_t all);

/// The threads that the options ask for.
unsigned threads_of(const MeshOptions& options);

/// Whether vertices are moved to where samples cross the level.
bool is_interpolated(const MeshOptions& options);

/// Where the axes of a sweep lie.
struct SweepPlace {
  std::array<double, 3> spacing;
  std::optional<VolumePlacement> placement;  ///< nothing: along the coordinates
  bool is_mirrored;
};

/// Throws std::invalid_argument if the level is no number, or runs backwards.
Selection selection_of(const Level& level);

/// Throws std::invalid_argument if the axes span no space.
SweepPlace sweep_place(const MeshOptions& options, const AxisOrder& order = {0, 1, 2});

/// Throws std::invalid_argument for options that contradict each other.
void check_options(const MeshOptions& options);

/// A volume once more, for gradients.
using OpenAgain = std::function<std::unique_ptr<SliceReader>()>;

/// The triangles of a surface, relaxed, decimated, with normals, placed. surface: gets the spacing.
/// crossings: where its vertices are moved to, or from, if it is relaxed; null if they stay. level:
/// of the gradient. open_again: may be empty unless the options have Normals::gradient.
Mesh finished_mesh(Surface& surface, Crossings* crossings, const MeshOptions& options,
                   const SweepPlace& place, double level, const OpenAgain& open_again = {});

}  // namespace discmc::meshing

#endif
