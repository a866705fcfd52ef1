#include "measures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "surface/sets.hpp"

namespace discmc::command {
namespace {

struct Edge {
  std::uint32_t from, to;  // from < to
  std::uint32_t face;

  bool operator<(const Edge& other) const {
    return std::pair(from, to) < std::pair(other.from, other.to);
  }
  bool is_of(const Edge& other) const { return from == other.from && to == other.to; }
};

// Sets of faces that hang together by edges.
Sets pieces_of(const Mesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(mesh.corners.size());
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    const std::size_t size = mesh.face_size(face);
    for (std::size_t i = 0; i < size; ++i) {
      const auto [from, to] = std::minmax(mesh.face(face)[i], mesh.face(face)[(i + 1) % size]);
      edges.push_back({from, to, face});
    }
  }
  std::sort(edges.begin(), edges.end());
  Sets pieces(mesh.face_count());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].is_of(edges[i - 1])) pieces.join(edges[i].face, edges[i - 1].face);
  return pieces;
}

// Adds up pyramids from one point to the faces: near by, so that little is rounded.
Enclosed enclosed_by(const Mesh& mesh) {
  if (mesh.face_count() == 0) return {0, {}, 0, 0};
  const Point apex = mesh.vertices_mm[mesh.face(0)[0]];
  Sets pieces = pieces_of(mesh);
  std::vector<double> volumes(mesh.face_count());
  Enclosed all{0, {}, 0, 0};
  Point moment{};
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    const Point normal = area_vector(mesh, face);
    const Point& corner = mesh.vertices_mm[mesh.face(face)[0]];
    double height = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      height += normal[axis] * (corner[axis] - apex[axis]);
    const double volume = height / 3;
    volumes[pieces.name(face)] += volume;
    all.volume_mm3 += volume;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        moment[axis] += volume / 4 * (mesh.vertices_mm[mesh.face(face)[i]][axis] - apex[axis]);
  }
  for (const double volume : volumes) {
    all.bodies += volume > 0;
    all.cavities += volume < 0;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    all.centre_mm[axis] = apex[axis] + moment[axis] / all.volume_mm3;
  return all;
}

}  // namespace

Measures measures_of(const Mesh& mesh) {
  Measures measures;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const Point normal = area_vector(mesh, face);
    measures.area_mm2 += std::sqrt(dot(normal, normal));
  }
  if (!mesh.vertices_mm.empty()) measures.min_mm = measures.max_mm = mesh.vertices_mm[0];
  for (const Point& vertex : mesh.vertices_mm)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      measures.min_mm[axis] = std::min(measures.min_mm[axis], vertex[axis]);
      measures.max_mm[axis] = std::max(measures.max_mm[axis], vertex[axis]);
    }
  if (mesh.left_out.empty() && is_closed(mesh)) measures.enclosed = enclosed_by(mesh);
  return measures;
}

}  // namespace discmc::command
