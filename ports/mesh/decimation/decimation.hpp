// Decimates the mesh of a surface.
#ifndef DISCMC_MESH_DECIMATION_DECIMATION_HPP
#define DISCMC_MESH_DECIMATION_DECIMATION_HPP

#include <cstdint>
#include <functional>

#include "meshes/mesh.hpp"

namespace discmc::meshing {

/// The target of a decimation. It ends at whichever limit is reached first.
struct Decimation {
  std::uint64_t triangles = 0;  ///< triangles left, or one less; 0: the distance decides
  /// The largest distance between both meshes, in both directions, 0: unlimited. Measured at every
  /// vertex, and at the middles of the edges and triangles of the decimated mesh.
  double max_error_mm = 0;

  bool is_wanted() const { return triangles > 0 || max_error_mm > 0; }
};

/// Collapses edges in the order of their costs. The allowed distance grows from 1/20 of a voxel to
/// at most max_error_mm, each step by a factor of the root of 2. More triangles than the target
/// remain if each further collapse would remove a body, cavity or handle, or make triangles cross
/// or turn over. A closed mesh stays closed, each body keeps its volume, and triangles intersect
/// only where they did. The border of an open mesh loses vertices, but no border vertex moves.
/// Other vertices may move. Limit: triangles. check: called regularly; its exceptions end the call.
/// Time: n log n.
void decimate(FaceMesh& mesh, const Decimation& decimation,
              const std::function<void()>& check = {});

}  // namespace discmc::meshing

#endif
