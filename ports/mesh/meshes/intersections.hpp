// Finds the faces of a mesh that intersect.
#ifndef DISCMC_MESH_MESHES_INTERSECTIONS_HPP
#define DISCMC_MESH_MESHES_INTERSECTIONS_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh.hpp"

namespace discmc::meshing {

/// Indexes of faces.
using FaceList = std::vector<std::uint32_t>;
using FacePair = std::array<std::uint32_t, 2>;

FaceList all_faces(const FaceMesh& mesh);

/// Returns each pair of these faces that intersect beyond shared vertices and edges. Ignores pairs
/// in one plane. Limit: triangles. check, jobs: as MeshingOptions. is_wanted: one per face of the
/// mesh, or empty; each pair then has a wanted face. Time: n log n for n faces, plus the number of
/// neighbouring pairs.
std::vector<FacePair> intersecting_faces(const FaceMesh& mesh, const FaceList& faces,
                                         const std::function<void()>& check = {}, unsigned jobs = 1,
                                         const std::vector<bool>& is_wanted = {});

}  // namespace discmc::meshing

#endif
