// How far two meshes are from each other.
#ifndef DISCMC_MESH_MESHES_SURFACE_DISTANCE_HPP
#define DISCMC_MESH_MESHES_SURFACE_DISTANCE_HPP

#include <cstddef>
#include <functional>

#include "mesh.hpp"

namespace discmc::meshing {

/// Whether any face is more than a line or a point.
bool has_area(const FaceMesh& mesh);

/// The distances of points of one mesh from another.
struct Distances {
  double mean = 0;
  double percentile_99 = 0;
  double largest = 0;
};

/// How many points of a mesh are measured, beside its vertices.
constexpr std::size_t default_distance_samples = 200'000;

/// The distances of the points of `from` from the faces of `to`. The mean and the percentile are of
/// points spread evenly over the area, always the same ones. The largest is of these and of all
/// vertices. unit: coordinates are divided by it, the spacing of a volume to measure in voxels.
/// Limit: both have faces, and `from` has_area(); otherwise std::invalid_argument. Faces are taken
/// as fans. Time: n log n for n faces, and so much for each point as there are faces near to it.
/// progress: called with how many points are done, of how many.
Distances distances(const FaceMesh& from, const FaceMesh& to, const Point& unit = {1, 1, 1},
                    const std::function<void(std::size_t, std::size_t)>& progress = {},
                    std::size_t samples = default_distance_samples);

}  // namespace discmc::meshing

#endif
