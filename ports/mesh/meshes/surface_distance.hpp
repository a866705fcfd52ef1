// Measures the distance between two meshes.
#ifndef DISCMC_MESH_MESHES_SURFACE_DISTANCE_HPP
#define DISCMC_MESH_MESHES_SURFACE_DISTANCE_HPP

#include <cstddef>
#include <functional>

#include "mesh.hpp"

namespace discmc::meshing {

/// Whether any face has an area.
bool has_area(const FaceMesh& mesh);

/// The distances of one mesh's points from another mesh.
struct Distances {
  double mean = 0;
  double percentile_99 = 0;
  double largest = 0;
};

/// The number of measured points of a mesh, in addition to its vertices.
constexpr std::size_t default_distance_samples = 200'000;

/// Measures the distances of points of `from` from the faces of `to`. The mean and the percentile
/// are over points spread evenly over the area, always the same points. The largest also includes
/// all vertices. unit: divides coordinates; the spacing of a volume gives distances in voxels.
/// Limit: both have faces, and `from` has_area(); otherwise std::invalid_argument. Faces are
/// treated as fans. Time: n log n for n faces, plus the number of near faces for each point.
/// progress: called with the number of points done, and of all.
Distances distances(const FaceMesh& from, const FaceMesh& to, const Point& unit = {1, 1, 1},
                    const std::function<void(std::size_t, std::size_t)>& progress = {},
                    std::size_t samples = default_distance_samples);

}  // namespace discmc::meshing

#endif
