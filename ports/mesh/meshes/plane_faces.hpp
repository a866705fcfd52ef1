// The faces of a surface whose polygons stay in their planes, block by block, so that a mesh can be
// written while it is made.
#ifndef DISCMC_MESH_MESHES_PLANE_FACES_HPP
#define DISCMC_MESH_MESHES_PLANE_FACES_HPP

#include <cstddef>
#include <cstdint>

#include "mesh.hpp"
#include "outline.hpp"

namespace discmc::meshing {

/// Makes faces in memory that it reuses. Each thread needs its own object.
class PlaneFaces {
 public:
  /// vertices: of the surface's polygons. Limit: no interpolation. Owner: the caller keeps surface
  /// and vertices.
  PlaneFaces(const Surface& surface, const VertexNumbers& vertices, const MeshingOptions& options)
      : surface_(surface),
        faces_(options.faces),
        is_mirrored_(is_mirrored(surface.spacing_mm)),
        outline_(vertices, options.is_conforming) {}

  /// Makes the faces of a block of polygons, over the numbers of all vertices. mesh: receives them
  /// instead of its own faces; its vertices stay.
  void make(std::size_t block, FaceMesh& mesh);
  /// Makes the same faces, but over vertices of each polygon's own, in mesh.lattice.
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
