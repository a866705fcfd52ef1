// The placement of a volume in space, which maps voxels to millimetres.
#ifndef DISCMC_MESH_SAMPLES_VOLUME_PLACEMENT_HPP
#define DISCMC_MESH_SAMPLES_VOLUME_PLACEMENT_HPP

#include <array>

#include <discmc/placement.hpp>

namespace discmc::meshing {

/// The limits of distances between voxels.
constexpr double min_spacing_mm = 1e-6;
constexpr double max_spacing_mm = 1e6;
/// The limit of the coordinates of an origin.
constexpr double max_origin_mm = 1e9;

/// One vector per axis of the volume: the step to the next voxel along x, y and z.
using Axes = std::array<std::array<double, 3>, 3>;

constexpr Axes coordinates = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// An affine map: the centre of voxel (i, j, k) is origin + i axes[0] + j axes[1] + k axes[2].
/// Units: millimetres.
struct VolumePlacement {
  Space space = Space::scanner;
  std::array<double, 3> origin_mm{};  ///< the centre of voxel (0, 0, 0)
  Axes axes_mm{};

  bool operator==(const VolumePlacement& other) const {
    return space == other.space && origin_mm == other.origin_mm && axes_mm == other.axes_mm;
  }
};

/// Returns the placement along the coordinates, with voxel (0, 0, 0) at the origin.
constexpr VolumePlacement along_coordinates(const std::array<double, 3>& spacing_mm) {
  return {
      Space::scanner, {}, {{{spacing_mm[0], 0, 0}, {0, spacing_mm[1], 0}, {0, 0, spacing_mm[2]}}}};
}

/// Returns the volume of the parallelepiped of the axes, negative if they are left-handed.
double determinant(const Axes& axes);

/// Whether the axes have valid lengths and span a space, and the origin is within 1e9 mm.
bool is_usable(const Axes& axes_mm);
bool is_usable(const VolumePlacement& placement);

/// Returns the same placement in another space. Limit: neither is Space::scanner.
VolumePlacement in_space(VolumePlacement placement, Space space);

/// Returns the placement of a stream's record, rounded to nanometres. Limit: is_usable(). Throws
/// std::invalid_argument if an axis is too long for a record.
Placement in_nanometres(const VolumePlacement& placement);
VolumePlacement in_millimetres(const Placement& placement);

}  // namespace discmc::meshing

#endif
