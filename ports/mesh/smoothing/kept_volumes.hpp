// Makes smoothed surfaces enclose the volumes of their voxels.
#ifndef DISCMC_MESH_SMOOTHING_KEPT_VOLUMES_HPP
#define DISCMC_MESH_SMOOTHING_KEPT_VOLUMES_HPP

#include <cstddef>
#include <functional>
#include <vector>

#include "extraction/crossings.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

/// A surface of SmoothedVolume. Its crossings must keep their ends.
struct SmoothSurface {
  const Surface* surface;  ///< with its spacing
  Crossings* crossings;
};

struct VolumeKeeping {
  /// Returns the surface around a voxel, given in half-steps like Crossings; none if it is outside
  /// all. Several threads call it.
  std::function<std::size_t(const Vertex& voxel)> surface_of{};
  double tolerance = 0;        ///< as MeshingOptions, for meshes that enclose the volumes
  double min_distance_mm = 0;  ///< least distance between the surface and a voxel
  double max_shift_mm = 0;     ///< largest shift of a surface
  bool is_closed = true;       ///< false: no surface moves to keep a volume
  unsigned jobs = 1;           ///< number of threads; each works on one surface at a time
  std::function<void()> check{};

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// Moves the crossings of surfaces. If two surfaces meet, both get the crossing at which their
/// distances are equal. Then each body and each cavity grows or shrinks evenly until it encloses
/// the volume of its voxels. Bodies that fill a volume to its corners cannot all reach this; each
/// then lacks an equal share. Cost: the meshes of all surfaces at once, and several passes over
/// them.
void keep_volumes(const std::vector<SmoothSurface>& surfaces, const VolumeKeeping& keeping);

}  // namespace discmc::meshing

#endif
