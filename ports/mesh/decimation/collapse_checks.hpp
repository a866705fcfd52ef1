// Checks whether the surface is as good after a collapse as before.
#ifndef DISCMC_MESH_DECIMATION_COLLAPSE_CHECKS_HPP
#define DISCMC_MESH_DECIMATION_COLLAPSE_CHECKS_HPP

#include "collapsing_mesh.hpp"
#include "meshes/box_tree.hpp"

namespace discmc::meshing {

/// Whether no triangle turns over, and no angle falls below 5 degrees, unless an angle was smaller
/// before.
bool keeps_shape(const Collapse& collapse, const CollapsingMesh& mesh);

/// Whether no moving triangle passes through another, and no other body changes its side of the
/// surface. tree: of the triangles of the mesh.
bool keeps_apart(const Collapse& collapse, const CollapsingMesh& mesh, const BoxTree& tree);

}  // namespace discmc::meshing

#endif
