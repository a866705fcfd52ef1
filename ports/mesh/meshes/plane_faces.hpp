// The faces of a surface whose polygons stay in their planes, block by block: a mesh can be written
// while it is made.
#ifndef DISCMC_MESH_MESHES_PLANE_FACES_HPP
#define DISCMC_MESH_MESHES_PLANE_FACES_HPP

#include <cstddef>
#include <cstdint>

#include "mesh.hpp"
#include "outline.hpp"

namespace discmc::meshing {

/// Makes faces, in memory that it keeps: one for each thread.
class PlaneFaces {
 public:
  /// vertices: of the polygons of the surface. Limit: nothing is interpolated. Owner: the caller
  /// has surface and vertices.
  PlaneFaces(const Surface& surface, const VertexNumbers& vertices, const MeshingOptions& options)
      : surface_(surface),
        faces_(options.faces),
        is_mirrored_(is_mirrored(surface.spacing_mm)),
        outline_(vertices, options.is_conforming) {}

  /// Makes the faces of a block of polygons. mesh: gets them in place of its own, over the numbers
  /// of all vertices; its vertices stay.
  void make(std::size_t block, FaceMesh& mesh);
  /// The same faces, over vertices of their own: those of each polygon, in mesh.lattice.
  void make_apart(std::size_t block, FaceMesh& mesh);

 private:
  template <class Number>
  void make_faces(std::size_t block, FaceMesh& mesh, Number number);
  void add_polygon(std::uint32_t polygon, FaceMesh& mesh);
  void add_triangles(std::uint32_t polygon, FaceMesh& mesh);

  const Surface& surface_;
  Faces faces_;
  bool is_mirrored_;
  Outline outline_;
  OutlineTriangulator triangulator_;
};

}  // namespace discmc::meshing

#endif
