// Fewer triangles for a mesh of a surface.
#ifndef DISCMC_MESH_MESHES_DECIMATION_HPP
#define DISCMC_MESH_MESHES_DECIMATION_HPP

#include <cstddef>
#include <cstdint>

#include "mesh.hpp"

namespace discmc::meshing {

/// Which triangles are removed. If both are given, whichever is reached first ends it.
struct Decimation {
  std::uint64_t triangles = 0;  ///< that are left, about; 0: as few as the error allows
  /// Between the meshes, as quadrics estimate it: several times the mean; 0: any.
  double max_error_mm = 0;

  bool is_wanted() const { return triangles > 0 || max_error_mm > 0; }
};

struct DecimatedBodies {
  std::size_t all = 0;
  std::size_t unchanged = 0;  ///< as their decimated meshes would not be closed
};

/// Removes triangles and vertices, and then slivers. What is left is closed and manifold where the
/// mesh was: places that would not be keep their triangles, and a body for which that does not
/// suffice keeps all of them. Edges of one face stay. Limit: triangles. Throws as
/// require_simplifier().
DecimatedBodies decimate(FaceMesh& mesh, const Decimation& decimation);

}  // namespace discmc::meshing

#endif
