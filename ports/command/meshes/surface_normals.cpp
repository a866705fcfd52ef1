#include "surface_normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace discmc::command {
namespace {

// For every vertex the first one at its position.
std::vector<std::uint32_t> first_at_position(const std::vector<Point>& vertices) {
  std::vector<std::uint32_t> sorted(vertices.size());
  std::iota(sorted.begin(), sorted.end(), 0U);
  std::sort(sorted.begin(), sorted.end(), [&vertices](std::uint32_t a, std::uint32_t b) {
    return vertices[a] != vertices[b] ? vertices[a] < vertices[b] : a < b;
  });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool is_same = i > 0 && vertices[sorted[i]] == vertices[sorted[i - 1]];
    first[sorted[i]] = is_same ? first[sorted[i - 1]] : sorted[i];
  }
  return first;
}

// Units: radians; 0 where it is none.
double angle_between(const Point& a, const Point& b) {
  const Point across = cross(a, b);
  return std::atan2(std::hypot(across[0], across[1], across[2]), dot(a, b));
}

}  // namespace

std::vector<Point> surface_normals(const Mesh& mesh) {
  const std::vector<std::uint32_t> first = first_at_position(mesh.vertices_mm);
  std::vector<Point> normals(first.size());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t* const corners = mesh.face(face);
    const Point normal = unit_or_zero(area_vector(mesh, face));
    const auto at = [&](std::size_t i) { return mesh.vertices_mm[corners[i % 3]]; };
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle =
          angle_between(difference(at(i + 1), at(i)), difference(at(i + 2), at(i)));
      Point& sum = normals[first[corners[i]]];
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += angle * normal[axis];
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
    normals[i] = first[i] == i ? unit_or_zero(normals[i]) : normals[first[i]];
  return normals;
}

}  // namespace discmc::command
