#include "measures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh_edges.hpp"

namespace discmc::meshing {
namespace {

// Sums pyramids from an apex to the faces. The apex is near, to keep rounding small. areas:
// area_vector() of each face.
Enclosed enclosed_by(const FaceMesh& mesh, const std::vector<Point>& areas) {
  if (mesh.face_count() == 0) return {0, {}, 0, 0};
  const Point apex = mesh.vertices_mm[mesh.face(0)[0]];
  Sets pieces = connected_faces(sorted_edges(mesh), mesh.face_count());
  std::vector<double> volumes(mesh.face_count());
  Enclosed enclosed{0, {}, 0, 0};
  Point moment{};
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    const Point& corner = mesh.vertices_mm[mesh.face(face)[0]];
    const double volume = dot(areas[face], difference(corner, apex)) / 3;
    volumes[pieces.root(face)] += volume;
    enclosed.volume_mm3 += volume;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        moment[axis] += volume / 4 * (mesh.vertices_mm[mesh.face(face)[i]][axis] - apex[axis]);
  }
  for (const double volume : volumes) {
    enclosed.bodies += volume > 0;
    enclosed.cavities += volume < 0;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    enclosed.centre_mm[axis] = apex[axis] + moment[axis] / enclosed.volume_mm3;
  return enclosed;
}

}  // namespace

Measures measures_of(const FaceMesh& mesh) {
  Measures measures;
  std::vector<Point> areas;
  areas.reserve(mesh.face_count());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    areas.push_back(area_vector(mesh, face));
    measures.area_mm2 += std::sqrt(dot(areas.back(), areas.back()));
  }
  if (!mesh.vertices_mm.empty()) measures.min_mm = measures.max_mm = mesh.vertices_mm[0];
  for (const Point& vertex : mesh.vertices_mm)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      measures.min_mm[axis] = std::min(measures.min_mm[axis], vertex[axis]);
      measures.max_mm[axis] = std::max(measures.max_mm[axis], vertex[axis]);
    }
  if (mesh.left_out.empty() && is_closed(mesh)) measures.enclosed = enclosed_by(mesh, areas);
  return measures;
}

}  // namespace discmc::meshing
