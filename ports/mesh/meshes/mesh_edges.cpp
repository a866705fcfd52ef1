#include "mesh_edges.hpp"

#include <algorithm>
#include <utility>

namespace discmc::meshing {

std::vector<FaceEdge> sorted_edges(const FaceMesh& mesh) {
  std::vector<FaceEdge> edges;
  edges.reserve(mesh.corners.size());
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    const std::size_t count = mesh.face_size(face);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t a = mesh.face(face)[i];
      const std::uint32_t b = mesh.face(face)[i + 1 < count ? i + 1 : 0];
      edges.push_back({std::min(a, b), std::max(a, b), face, a > b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  return edges;
}

Sets connected_faces(const std::vector<FaceEdge>& edges, std::size_t faces) {
  Sets sets(faces);
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].joins_same_vertices(edges[i - 1])) sets.join(edges[i].face, edges[i - 1].face);
  return sets;
}

}  // namespace discmc::meshing
