// A mesh in parts: each is made when it is written, so that the mesh is never in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "file_mesh.hpp"
#include "meshes/plane_faces.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// What a mesh came to that was written in parts.
struct MeshTotals {
  std::uint64_t faces = 0;
  std::uint64_t edge_sum = 0;             ///< if it was asked for
  std::vector<std::uint32_t> left_out{};  ///< as FaceMesh
};

/// The mesh of build_mesh(). Its parts are a range of its vertices, or the faces of a block of
/// polygons.
class MeshParts {
 public:
  using Place = std::function<void(FileMesh&)>;
  /// Faces, and what makes them.
  struct Block {
    std::unique_ptr<PlaneFaces> maker;
    FileMesh faces;
    std::uint64_t edge_sum = 0;
  };

  /// place: moves a part to where the file has it; called by several threads. Limit: nothing is
  /// interpolated. Owner: the caller has the surface.
  MeshParts(const Surface& surface, const MeshingOptions& options, bool sums_edges, Place place)
      : surface_(surface),
        options_(options),
        sums_edges_(sums_edges),
        place_(std::move(place)),
        vertices_(surface.polygons) {}

  unsigned jobs() const { return options_.jobs; }
  std::size_t vertex_count() const { return vertices_.positions().size(); }
  std::size_t block_count() const { return meshing::block_count(surface_.polygons); }

  /// The corners of a box around all vertices, placed.
  FileMesh bounds() const;
  /// Vertices from first to before end, placed. part: gets them in place of its own.
  void make_vertices(std::size_t first, std::size_t end, FileMesh& part) const;
  /// Faces over the numbers of all vertices, placed.
  void make_faces(std::size_t number, Block& block) const;
  /// The same, over vertices of their own: PlaneFaces::make_apart().
  void make_triangles(std::size_t number, Block& block) const;

 private:
  PlaneFaces& maker(Block& block) const;
  std::vector<std::uint32_t> numbers_of(const std::vector<Vertex>& positions) const;
  void add_vertex(const Vertex& vertex, FileMesh& part) const {
    part.vertices_mm.push_back(in_mm(point_of(vertex), surface_.spacing_mm));
  }

  const Surface& surface_;
  MeshingOptions options_;
  bool sums_edges_;
  Place place_;
  VertexNumbers vertices_;
};

void add(const MeshParts::Block& block, MeshTotals& totals);

}  // namespace discmc::command
