#include "mesh.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "interpolated_mesh.hpp"
#include "plane_mesh.hpp"
#include "vertex_numbers.hpp"

namespace discmc::meshing {

FaceMesh build_mesh(const Surface& surface, const MeshingOptions& options) {
  for (const double spacing : surface.spacing_mm)
    if (spacing == 0 || !std::isfinite(spacing))
      throw std::invalid_argument("the spacing is zero or not finite");
  const bool are_conforming_triangles = options.is_conforming && options.faces == Faces::triangles;
  if (options.crossings != nullptr && !are_conforming_triangles)
    throw std::invalid_argument("an interpolated mesh is one of conforming triangles");
  VertexNumbers vertices(surface.polygons, options.jobs);
  return options.crossings == nullptr ? plane_mesh(surface, vertices, options)
                                      : interpolated_mesh(surface, std::move(vertices), options);
}

Point outward_normal(Incidence incidence, const Point& spacing_mm) {
  // Planes transform by the inverse; a signed inverse also keeps the normal outward.
  const Vertex n = incidence_normal(incidence);
  const Point scaled = {n.x / spacing_mm[0], n.y / spacing_mm[1], n.z / spacing_mm[2]};
  const double length = std::hypot(scaled[0], scaled[1], scaled[2]);
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

Point area_vector(const FaceMesh& mesh, std::size_t face) {
  return area_vector(mesh.vertices_mm, mesh.face(face), mesh.face_size(face));
}

Point area_vector(const std::vector<Point>& vertices, const std::uint32_t* corners,
                  std::size_t count) {
  const Point& origin = vertices[corners[0]];
  Point sum{};
  for (std::size_t i = 2; i < count; ++i) {
    const Point doubled = cross(difference(vertices[corners[i - 1]], origin),
                                difference(vertices[corners[i]], origin));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += doubled[axis] / 2;
  }
  return sum;
}

Point face_normal(const FaceMesh& mesh, std::size_t face) {
  return mesh.incidences.empty() ? unit_or_zero(area_vector(mesh, face))
                                 : outward_normal(mesh.incidences[face], mesh.spacing_mm);
}

}  // namespace discmc::meshing
