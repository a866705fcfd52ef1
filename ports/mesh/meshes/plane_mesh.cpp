#include "plane_mesh.hpp"

#include <memory>
#include <utility>

#include "jobs/ordered_pipeline.hpp"
#include "plane_faces.hpp"

namespace discmc::meshing {
namespace {

template <class Values>
void append(Values& values, const Values& more) {
  values.insert(values.end(), more.begin(), more.end());
}

// Adds the faces of a part.
void append_faces(FaceMesh& mesh, const FaceMesh& part) {
  const std::size_t begin = mesh.corners.size();
  append(mesh.corners, part.corners);
  for (std::size_t face = 1; face < part.face_begin.size(); ++face)
    mesh.face_begin.push_back(begin + part.face_begin[face]);
  append(mesh.incidences, part.incidences);
  append(mesh.polygons, part.polygons);
  append(mesh.left_out, part.left_out);
}

void place_vertices(const std::vector<Vertex>& positions, FaceMesh& mesh) {
  mesh.vertices_mm.reserve(positions.size());
  for (const Vertex& vertex : positions)
    mesh.vertices_mm.push_back(in_mm(point_of(vertex), mesh.spacing_mm));
}

}  // namespace

FaceMesh plane_mesh(const Surface& surface, VertexNumbers vertices, const MeshingOptions& options) {
  FaceMesh mesh;
  mesh.spacing_mm = surface.spacing_mm;
  reserve_faces(mesh, vertices.positions().size());
  struct Block {
    std::unique_ptr<PlaneFaces> faces;
    FaceMesh part;
  };
  // The first blocks also place vertices, in parallel with their faces.
  run_in_order<Block>(
      options.jobs, 1 + block_count(surface.polygons),
      [&](std::size_t, Block& block) {
        if (!block.faces) block.faces = std::make_unique<PlaneFaces>(surface, vertices, options);
      },
      [&](std::size_t number, Block& block) {
        if (number == 0) return place_vertices(vertices.positions(), mesh);
        block.faces->make(number - 1, block.part);
      },
      [&](std::size_t, Block& block) {
        if (options.check) options.check();
        append_faces(mesh, block.part);
      });
  mesh.lattice = std::move(vertices).positions();
  return mesh;
}

}  // namespace discmc::meshing
