// A mesh in parts. Each part is made when it is written, so the whole mesh is never in memory.
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

/// Totals of a mesh that was written in parts.
struct MeshTotals {
  std::uint64_t faces = 0;
  std::uint64_t edge_sum = 0;             ///< if sums_edges
  std::vector<std::uint32_t> left_out{};  ///< as FaceMesh
};

/// The mesh of build_mesh() in parts: ranges of its vertices, and the faces of blocks of polygons.
class MeshParts {
 public:
  using MovePart = std::function<void(FileMesh&)>;
  /// The faces of a block, and their maker, which later blocks reuse.
  struct Block {
    std::unique_ptr<PlaneFaces> maker;
    FileMesh faces;
    std::uint64_t edge_sum = 0;
  };

  /// move_part: moves a part to its position in the file; several threads call it. Limit: no
  /// interpolation. Owner: the caller keeps the surface.
  MeshParts(const Surface& surface, const MeshingOptions& options, bool sums_edges,
            MovePart move_part)
      : surface_(surface),
        options_(options),
        sums_edges_(sums_edges),
        move_part_(std::move(move_part)),
        vertices_(surface.polygons, options.jobs) {}

  unsigned jobs() const { return options_.jobs; }
  std::size_t vertex_count() const { return vertices_.size(); }
  std::size_t vertex_part_count() const { return vertices_.part_count(); }
  std::size_t block_count() const { return meshing::block_count(surface_.polygons); }

  /// Returns the corners of a box around all vertices, placed.
  FileMesh bounds() const;
  /// Makes the vertices of a part, placed. mesh: receives them instead of its own.
  void make_vertices(std::size_t part, FileMesh& mesh) const;
  /// Makes faces that index all vertices of the mesh, placed.
  void make_faces(std::size_t number, Block& block) const;
  /// Makes faces that index vertices of their own: PlaneFaces::make_apart().
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
  MovePart move_part_;
  VertexNumbers vertices_;
};

void add(const MeshParts::Block& block, MeshTotals& totals);

}  // namespace discmc::command
