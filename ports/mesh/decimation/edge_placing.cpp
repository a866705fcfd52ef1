#include "edge_placing.hpp"

#include <algorithm>
#include <cmath>

namespace discmc::meshing {
namespace {

using Symmetric = std::array<double, 6>;

void add_square(Symmetric& to, const Point& v, double weight) {
  std::size_t index = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) to[index++] += weight * v[i] * v[j];
}

Point product(const Symmetric& a, const Point& x) {
  return {a[0] * x[0] + a[1] * x[1] + a[2] * x[2], a[1] * x[0] + a[3] * x[1] + a[4] * x[2],
          a[2] * x[0] + a[4] * x[1] + a[5] * x[2]};
}

double at(const Symmetric& quadric, const Point& x) {
  return dot(x, product(quadric, x));
}

// Returns the inverse, or zero if the matrix is singular.
Symmetric inverse(const Symmetric& a) {
  Symmetric cofactors = {a[3] * a[5] - a[4] * a[4], a[2] * a[4] - a[1] * a[5],
                         a[1] * a[4] - a[2] * a[3], a[0] * a[5] - a[2] * a[2],
                         a[1] * a[2] - a[0] * a[4], a[0] * a[3] - a[1] * a[1]};
  const double determinant = a[0] * cofactors[0] + a[1] * cofactors[1] + a[2] * cofactors[2];
  for (double& each : cofactors) each = determinant > 0 ? each / determinant : 0;
  return cofactors;
}

Point plus(const Point& a, const Point& b, double times = 1) {
  return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}

// Rounds the point to 32-bit floats, so that the checked point is the written one.
Point rounded(const Point& point) {
  Point result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[axis] = static_cast<double>(static_cast<float>(point[axis]));
  return result;
}

constexpr double border_weight = 100;
constexpr double towards_middle = 1e-3;  // of the quadric's mean curvature
constexpr double min_area = 1e-4;        // of a volume constraint, relative to the area around
constexpr double max_move = 1;           // from the middle of an edge; Units: its length
constexpr double shape_weight = 1e-6,
                 in_plane_weight = 1e-9;  // prefer short edges if costs are equal

}  // namespace

EdgePlacing::EdgePlacing(const CollapsingMesh& mesh) : mesh_(mesh), sums_(mesh.vertex_slots()) {
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_slots(); ++vertex) update(vertex);
}

void EdgePlacing::update(std::uint32_t vertex) {
  Sums sums;
  mesh_.for_each_triangle(vertex, [&](std::uint32_t triangle, std::uint32_t) {
    const Point area = doubled_area(mesh_.corners(triangle));
    const double length = std::sqrt(dot(area, area));
    if (!(length > 0)) return;
    add_square(sums.quadric, area, 0.5 / length);
    sums.doubled_area = plus(sums.doubled_area, area);
  });
  if (mesh_.is_border(vertex)) add_border(vertex, sums);
  sums_[vertex] = sums;
}

// Adds planes through the border edges, perpendicular to their triangles.
void EdgePlacing::add_border(std::uint32_t vertex, Sums& sums) const {
  mesh_.for_each_triangle(vertex, [&](std::uint32_t triangle, std::uint32_t corner) {
    const Point area = doubled_area(mesh_.corners(triangle));
    for (const std::uint32_t step : {1U, 2U}) {
      const std::uint32_t other = mesh_.triangle(triangle)[(corner + step) % 3];
      if (!mesh_.is_border(other) || mesh_.count_triangles(vertex, other) != 1) continue;
      const Point edge = difference(mesh_.point(other), mesh_.point(vertex));
      const Point across = cross(area, edge);
      const double squared = dot(across, across);
      if (squared > 0) add_square(sums.quadric, across, border_weight * dot(edge, edge) / squared);
    }
  });
}

std::optional<EdgePlacing::PlacedVertex> EdgePlacing::placed(std::uint32_t a,
                                                             std::uint32_t b) const {
  const Point middle = plus(mesh_.point(a), difference(mesh_.point(b), mesh_.point(a)), 0.5);
  const Point to_a = difference(mesh_.point(a), middle), to_b = difference(mesh_.point(b), middle);
  const double squared_length = 4 * dot(to_a, to_a);
  const Symmetric &of_a = sums_[a].quadric, &of_b = sums_[b].quadric;
  const auto error = [&](const Point& x) {
    return std::max(0.0, at(of_a, difference(x, to_a)) + at(of_b, difference(x, to_b)));
  };
  Symmetric both;
  for (std::size_t i = 0; i < 6; ++i) both[i] = of_a[i] + of_b[i];
  const double area = both[0] + both[3] + both[5];

  Point x;
  if (mesh_.is_border(a) || mesh_.is_border(b)) {
    const bool is_free = mesh_.is_border(a) && mesh_.is_border(b);
    x = is_free ? (error(to_a) <= error(to_b) ? to_a : to_b) : mesh_.is_border(a) ? to_a : to_b;
  } else {
    Point normal = plus(sums_[a].doubled_area, sums_[b].doubled_area);
    double height = dot(sums_[a].doubled_area, to_a) + dot(sums_[b].doubled_area, to_b);
    mesh_.for_each_triangle(a, [&](std::uint32_t triangle, std::uint32_t) {
      const Triangle& vertices = mesh_.triangle(triangle);
      if (vertices[0] != b && vertices[1] != b && vertices[2] != b) return;
      const Point twice = doubled_area(mesh_.corners(triangle));
      normal = difference(normal, twice);
      height -= dot(twice, to_a);
    });
    for (const std::size_t i : {0U, 3U, 5U}) both[i] += towards_middle * area / 3;
    const Symmetric inverted = inverse(both);
    x = product(inverted, plus(product(of_a, to_a), product(of_b, to_b)));
    const Point direction = product(inverted, normal);
    const double slope = dot(normal, direction);
    if (slope > 0 && dot(normal, normal) > min_area * min_area * area * area)
      x = plus(x, direction, (height - dot(normal, x)) / slope);
    if (!(dot(x, x) <= max_move * max_move * squared_length)) return std::nullopt;
  }
  const Point place = rounded(plus(middle, x));
  return PlacedVertex{place, error(difference(place, middle)) +
                                 shape_weight * squared_length * squared_length +
                                 in_plane_weight * squared_length * area};
}

}  // namespace discmc::meshing
