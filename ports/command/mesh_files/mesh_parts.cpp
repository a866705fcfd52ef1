#include "mesh_parts.hpp"

namespace discmc::command {

FileMesh MeshParts::bounds() const {
  FileMesh box;
  box.spacing_mm = surface_.spacing_mm;
  if (vertex_count() > 0) {
    const auto& [low, high] = vertices_.box();
    for (const std::int32_t x : {low.x, high.x})
      for (const std::int32_t y : {low.y, high.y})
        for (const std::int32_t z : {low.z, high.z}) add_vertex({x, y, z}, box);
  }
  move_part_(box);
  return box;
}

void MeshParts::make_vertices(std::size_t part, FileMesh& mesh) const {
  mesh.spacing_mm = surface_.spacing_mm;
  mesh.vertices_mm.clear();
  vertices_.for_each(part, [&](std::uint32_t, const Vertex& vertex) { add_vertex(vertex, mesh); });
  move_part_(mesh);
}

void MeshParts::make_faces(std::size_t number, Block& block) const {
  maker(block).make(number, block.faces);
  if (sums_edges_) block.edge_sum = edge_sum(block.faces);
  move_part_(block.faces);
}

void MeshParts::make_triangles(std::size_t number, Block& block) const {
  FileMesh& faces = block.faces;
  maker(block).make_apart(number, faces);
  if (sums_edges_) block.edge_sum = edge_sum(faces, numbers_of(faces.lattice));
  faces.vertices_mm.clear();
  faces.vertices_mm.reserve(faces.lattice.size());
  for (const Vertex& vertex : faces.lattice) add_vertex(vertex, faces);
  move_part_(faces);
}

PlaneFaces& MeshParts::maker(Block& block) const {
  if (!block.maker) block.maker = std::make_unique<PlaneFaces>(surface_, vertices_, options_);
  return *block.maker;
}

std::vector<std::uint32_t> MeshParts::numbers_of(const std::vector<Vertex>& positions) const {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(positions.size());
  for (const Vertex& vertex : positions) numbers.push_back(vertices_.find(vertex));
  return numbers;
}

void add(const MeshParts::Block& block, MeshTotals& totals) {
  totals.faces += block.faces.face_count();
  totals.edge_sum += block.edge_sum;
  const std::vector<std::uint32_t>& left_out = block.faces.left_out;
  totals.left_out.insert(totals.left_out.end(), left_out.begin(), left_out.end());
}

}  // namespace discmc::command
