// Fewer triangles for a mesh of a surface.
#ifndef DISCMC_MESH_DECIMATION_DECIMATION_HPP
#define DISCMC_MESH_DECIMATION_DECIMATION_HPP

#include <cstdint>
#include <functional>

#include "meshes/mesh.hpp"

namespace discmc::meshing {

/// How far a mesh is decimated. If both are given, whichever is reached first ends it.
struct Decimation {
  std::uint64_t triangles = 0;  ///< that are left, or one less; 0: as few as the distance allows
  /// The largest distance between both meshes, measured both ways. It is taken at every vertex, and
  /// at the middles of the edges and triangles of the decimated mesh. 0: any.
  double max_error_mm = 0;

  bool is_wanted() const { return triangles > 0 || max_error_mm > 0; }
};

/// Collapses edges in the order of their costs. A bound of the distance grows by steps of the root
/// of 2, from 1/20 of a voxel. The last step is at most max_error_mm. More triangles than the
/// target are left if each further collapse would remove a body, cavity or handle, or make
/// triangles cross or turn over. A closed mesh stays closed, each body keeps its volume, and
/// triangles go through each other only where they did. The border of an open mesh loses vertices,
/// but no vertex of a border moves. Vertices get new places. Limit: triangles. check: called now
/// and then; what it throws ends the call. Time: n log n.
void decimate(FaceMesh& mesh, const Decimation& decimation,
              const std::function<void()>& check = {});

}  // namespace discmc::meshing

#endif
