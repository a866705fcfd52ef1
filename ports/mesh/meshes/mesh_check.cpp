#include <algorithm>
#include <cmath>

#include "mesh.hpp"
#include "mesh_edges.hpp"

namespace discmc::meshing {
namespace {

// Mixes the bits of a number (splitmix64, S. Vigna, 2015).
std::uint64_t mixed(std::uint64_t number) {
  number += 0x9E3779B97F4A7C15;
  number = (number ^ number >> 30) * 0xBF58476D1CE4E5B9;
  number = (number ^ number >> 27) * 0x94D049BB133111EB;
  return number ^ number >> 31;
}

bool repeats_a_vertex(const std::uint32_t* face, std::size_t count) {
  for (std::size_t i = 1; i < count; ++i)
    if (std::find(face, face + i, face[i]) != face + i) return true;
  return false;
}

// Twice the area relative to the squared extent. Rounding in millimetres is far smaller.
constexpr double min_relative_area = 1e-12;

bool has_area(const FaceMesh& mesh, const std::uint32_t* face, std::size_t count) {
  Point area{};
  double extent = 0;
  const Point& origin = mesh.vertices_mm[face[0]];
  for (std::size_t i = 1; i < count; ++i) {
    Point a, b;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      a[axis] = mesh.vertices_mm[face[i - 1]][axis] - origin[axis];
      b[axis] = mesh.vertices_mm[face[i]][axis] - origin[axis];
      extent = std::max(extent, std::abs(b[axis]));
    }
    area[0] += a[1] * b[2] - a[2] * b[1];
    area[1] += a[2] * b[0] - a[0] * b[2];
    area[2] += a[0] * b[1] - a[1] * b[0];
  }
  return std::hypot(area[0], area[1], area[2]) > min_relative_area * extent * extent;
}

}  // namespace

bool is_closed(const FaceMesh& mesh) {
  return edge_sum(mesh) == 0;
}

std::uint64_t edge_sum(const FaceMesh& mesh, const std::vector<std::uint32_t>& numbers) {
  const auto number_of = [&](std::uint32_t corner) {
    return numbers.empty() ? corner : numbers[corner];
  };
  std::uint64_t sum = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t* const corners = mesh.face(face);
    const std::size_t count = mesh.face_size(face);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t a = number_of(corners[i]);
      const std::uint32_t b = number_of(corners[i + 1 < count ? i + 1 : 0]);
      const std::uint64_t hash = mixed(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b));
      sum = a < b ? sum + hash : sum - hash;
    }
  }
  return sum;
}

bool is_degenerate(const FaceMesh& mesh, std::size_t face) {
  const std::size_t count = mesh.face_size(face);
  return count < 3 || repeats_a_vertex(mesh.face(face), count) ||
         !has_area(mesh, mesh.face(face), count);
}

MeshReport check_mesh(const FaceMesh& mesh) {
  MeshReport report;
  for_each_edge(sorted_edges(mesh), [&report](const FaceEdge* uses, std::size_t count) {
    ++report.edges;
    if (count == 1) ++report.open_edges;
    if (count > 2) ++report.non_manifold_edges;
    if (count == 2 && uses[0].falls == uses[1].falls) ++report.wrongly_oriented;
  });
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (is_degenerate(mesh, face)) ++report.degenerate_faces;
  return report;
}

}  // namespace discmc::meshing
