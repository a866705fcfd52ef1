// The library that decimates meshes: meshoptimizer.
#ifndef DISCMC_MESH_MESHES_MESH_SIMPLIFIER_HPP
#define DISCMC_MESH_MESHES_MESH_SIMPLIFIER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/point.hpp"

namespace discmc::meshing {

/// Throws std::runtime_error with the remedy if the program was built without meshoptimizer.
void require_simplifier();

struct Simplified {
  std::vector<std::uint32_t> corners;  ///< three vertex numbers per triangle
  double error = 0;                    ///< as quadrics estimate it; Units: those of the vertices
};

/// Returns a mesh of fewer triangles, whose vertices are among those given. Edges with one triangle
/// stay. corners: as the result. wanted: triangles, to stop at. max_error: to stop at before that;
/// as the result. Throws as require_simplifier().
Simplified simplified(const std::vector<Point>& vertices, const std::vector<std::uint32_t>& corners,
                      std::size_t wanted, double max_error);

}  // namespace discmc::meshing

#endif
