// The edges of a mesh, and the faces that they join.
#ifndef DISCMC_MESH_MESHES_MESH_EDGES_HPP
#define DISCMC_MESH_MESHES_MESH_EDGES_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh.hpp"
#include "surface/sets.hpp"

namespace discmc::meshing {

/// One face's use of an edge.
struct FaceEdge {
  std::uint32_t low, high;  ///< vertex numbers
  std::uint32_t face;
  bool falls;  ///< whether it runs from the higher number to the lower

  bool joins_same_vertices(const FaceEdge& other) const {
    return low == other.low && high == other.high;
  }
};

/// Returns every edge of every face. Uses of one edge follow each other.
std::vector<FaceEdge> sorted_edges(const FaceMesh& mesh);

/// Calls call(uses, count) for the uses of each undirected edge.
template <class Call>
void for_each_edge(const std::vector<FaceEdge>& edges, const Call& call) {
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].joins_same_vertices(edges[begin])) ++end;
    call(edges.data() + begin, end - begin);
  }
}

/// Returns sets of faces that are connected by edges. edges: sorted_edges() of this many faces.
Sets connected_faces(const std::vector<FaceEdge>& edges, std::size_t faces);

}  // namespace discmc::meshing

#endif
