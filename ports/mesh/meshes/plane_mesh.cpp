#include "plane_mesh.hpp"

#include <array>
#include <memory>
#include <stdexcept>
#include <utility>

#include "jobs/ordered_pipeline.hpp"
#include "outline.hpp"

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

// Makes faces in the planes of the polygons.
class PlaneFaces {
 public:
  PlaneFaces(const Surface& surface, const VertexNumbers& vertices, const MeshingOptions& options)
      : surface_(surface),
        faces_(options.faces),
        is_mirrored_(is_mirrored(surface.spacing_mm)),
        outline_(vertices, options.conforming) {}

  // Those of a block of polygons. mesh: gets them behind its own.
  void add_block(std::size_t block, FaceMesh& mesh) {
    for_each_polygon(surface_, block, outline_,
                     [&](std::uint32_t polygon) { add_polygon(polygon, mesh); });
  }

 private:
  void add_polygon(std::uint32_t polygon, FaceMesh& mesh) {
    const std::vector<std::uint32_t>& numbers = outline_.numbers;
    const bool is_whole = faces_ == Faces::polygons && outline_.ring_ends.size() == 1 &&
                          numbers.size() >= 3 && numbers.size() <= max_face_corners;
    if (is_whole) return add_face(polygon, numbers, mesh);
    try {
      add_triangles(polygon, mesh);
    } catch (const std::invalid_argument&) {
      mesh.left_out.push_back(polygon);
    }
  }

  void add_triangles(std::uint32_t polygon, FaceMesh& mesh) {
    const std::vector<std::uint32_t>& numbers = outline_.numbers;
    for (const Triangle& triangle :
         triangulator_.triangulate(outline_, surface_.polygons[polygon].incidence))
      add_face(polygon,
               std::array{numbers[triangle[0]], numbers[triangle[1]], numbers[triangle[2]]}, mesh);
  }

  template <class Numbers>
  void add_face(std::uint32_t polygon, const Numbers& numbers, FaceMesh& mesh) {
    const std::size_t count = numbers.size();
    for (std::size_t i = 0; i < count; ++i)
      mesh.corners.push_back(numbers[is_mirrored_ ? count - 1 - i : i]);
    mesh.face_begin.push_back(mesh.corners.size());
    mesh.incidences.push_back(surface_.polygons[polygon].incidence);
    mesh.polygons.push_back(polygon);
  }

  const Surface& surface_;
  Faces faces_;
  bool is_mirrored_;
  Outline outline_;
  OutlineTriangulator triangulator_;
};

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
  // Vertices are placed beside the first blocks.
  run_in_order<Block>(
      options.jobs, 1 + block_count(surface.polygons),
      [&](std::size_t, Block& block) {
        if (!block.faces) block.faces = std::make_unique<PlaneFaces>(surface, vertices, options);
        block.part = {};
      },
      [&](std::size_t number, Block& block) {
        if (number == 0) return place_vertices(vertices.positions(), mesh);
        block.faces->add_block(number - 1, block.part);
      },
      [&](std::size_t, Block& block) {
        if (options.check) options.check();
        append_faces(mesh, block.part);
      });
  mesh.lattice = std::move(vertices).positions();
  return mesh;
}

}  // namespace discmc::meshing
