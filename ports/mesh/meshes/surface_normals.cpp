#include "surface_normals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace discmc::meshing {
namespace {

// Returns the first vertex at the position of each vertex.
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

void add(Point& sum, const Point& vector) {
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += vector[axis];
}

// Scales an area vector to the root of its length.
Point weighted(const Point& area) {
  const double root = std::sqrt(std::hypot(area[0], area[1], area[2]));
  return root > 0 ? Point{area[0] / root, area[1] / root, area[2] / root} : Point{};
}

// Units: radians; 0 if the angle is undefined.
double angle_between(const Point& a, const Point& b) {
  const Point across = cross(a, b);
  return std::atan2(std::hypot(across[0], across[1], across[2]), dot(a, b));
}

// first: from first_at_position(). Adds to the normals of these vertices.
void add_merged_polygons(const FaceMesh& mesh, const std::vector<std::uint32_t>& first,
                         std::vector<Point>& normals) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> last(first.size(), none);  // first face of the last added polygon
  std::size_t face = 0;
  while (face < mesh.face_count()) {
    // Faces of a polygon follow each other.
    const std::size_t begin = face;
    Point area{};
    for (; face < mesh.face_count() && mesh.polygons[face] == mesh.polygons[begin]; ++face)
      add(area, area_vector(mesh, face));
    for (std::size_t i = mesh.face_begin[begin]; i < mesh.face_begin[face]; ++i) {
      const std::uint32_t vertex = first[mesh.corners[i]];
      if (last[vertex] == begin) continue;
      last[vertex] = begin;
      add(normals[vertex], weighted(area));
    }
  }
}

void add_triangles(const FaceMesh& mesh, const std::vector<std::uint32_t>& first,
                   std::vector<Point>& normals) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t* const corners = mesh.face(face);
    const Point normal = unit_or_zero(area_vector(mesh, face));
    const auto at = [&](std::size_t i) { return mesh.vertices_mm[corners[i % 3]]; };
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle =
          angle_between(difference(at(i + 1), at(i)), difference(at(i + 2), at(i)));
      add(normals[first[corners[i]]], {angle * normal[0], angle * normal[1], angle * normal[2]});
    }
  }
}

}  // namespace

std::vector<Point> surface_normals(const FaceMesh& mesh) {
  const std::vector<std::uint32_t> first = first_at_position(mesh.vertices_mm);
  std::vector<Point> normals(first.size());
  if (mesh.incidences.empty())
    add_triangles(mesh, first, normals);
  else
    add_merged_polygons(mesh, first, normals);
  for (std::size_t i = 0; i < normals.size(); ++i)
    normals[i] = first[i] == i ? unit_or_zero(normals[i]) : normals[first[i]];
  return normals;
}

}  // namespace discmc::meshing
