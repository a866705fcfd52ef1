// Thin triangles of a mesh, replaced by rounder ones.
#ifndef DISCMC_MESH_MESHES_SLIVERS_HPP
#define DISCMC_MESH_MESHES_SLIVERS_HPP

#include <cstddef>

#include "mesh.hpp"

namespace discmc::meshing {

/// Flips edges of triangles with a small angle, and collapses their shortest edges, if the surface
/// moves by no more than a distance there and hardly turns. Closed meshes stay closed. Edges that
/// are not used once in each direction stay, and the first faces do. Vertices may be left without
/// a face. Limit: triangles.
void remove_slivers(FaceMesh& mesh, std::size_t first_faces, double max_distance_mm);

}  // namespace discmc::meshing

#endif
