#include "plane_mesh.hpp"

#include <memory>

#include "jobs/ordered_pipeline.hpp"
#include "jobs/parallel.hpp"
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

void place_vertices(const VertexNumbers& vertices, unsigned jobs, FaceMesh& mesh) {
  mesh.lattice = vertices.positions(jobs);
  mesh.vertices_mm.resize(vertices.size());
  for_each_range_in_parallel(jobs, vertices.size(), [&mesh](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i)
      mesh.vertices_mm[i] = in_mm(point_of(mesh.lattice[i]), mesh.spacing_mm);
  });
}

}  // namespace

FaceMesh plane_mesh(const Surface& surface, const VertexNumbers& vertices,
                    const MeshingOptions& options) {
  FaceMesh mesh;
  mesh.spacing_mm = surface.spacing_mm;
  place_vertices(vertices, options.jobs, mesh);
  reserve_faces(mesh, vertices.size());
  for_each_face_block(surface, vertices, options,
                      [&mesh](const FaceMesh& block) { append_faces(mesh, block); });
  return mesh;
}

void for_each_face_block(const Surface& surface, const VertexNumbers& vertices,
                         const MeshingOptions& options,
                         const std::function<void(const FaceMesh&)>& consume) {
  struct Block {
    std::unique_ptr<PlaneFaces> maker;
    FaceMesh faces;
  };
  run_in_order<Block>(
      options.jobs, block_count(surface.polygons),
      [&](std::size_t, Block& block) {
        if (!block.maker) block.maker = std::make_unique<PlaneFaces>(surface, vertices, options);
      },
      [](std::size_t number, Block& block) { block.maker->make(number, block.faces); },
      [&](std::size_t, Block& block) {
        if (options.check) options.check();
        consume(block.faces);
      });
}

}  // namespace discmc::meshing
