// Where the faces of a mesh go through each other.
#ifndef DISCMC_MESH_MESHES_INTERSECTIONS_HPP
#define DISCMC_MESH_MESHES_INTERSECTIONS_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh.hpp"

namespace discmc::meshing {

/// Places of faces.
using FaceList = std::vector<std::uint32_t>;
using FacePair = std::array<std::uint32_t, 2>;

FaceList all_faces(const FaceMesh& mesh);

/// Returns any two of these faces that have more points in common than the vertices and edges that
/// they share. Two that lie in one plane are not looked at. Limit: triangles.
/// check, jobs: as MeshingOptions. is_wanted: one per face of the mesh, or none; then each pair has
/// one that is wanted. Time: n log n for n faces, and the pairs that are next to each
/// other.
std::vector<FacePair> intersecting_faces(const FaceMesh& mesh, const FaceList& faces,
                                         const std::function<void()>& check = {}, unsigned jobs = 1,
                                         const std::vector<bool>& is_wanted = {});

/// Returns the faces, of all, that are in a box which overlaps that of one of these. Limit:
/// triangles.
FaceList near_faces(const FaceMesh& mesh, const FaceList& faces);

}  // namespace discmc::meshing

#endif
