#include "triangle_intersection.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace discmc::meshing {
namespace {

// Whether the line between two points on different sides of a triangle's plane meets the triangle.
bool meets(const Point& begin, const Point& end, const Corners& triangle) {
  int lowest = 0, highest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = TrianglePlane({begin, end, triangle[i]}).side_of(triangle[(i + 1) % 3]);
    lowest = std::min(lowest, side);
    highest = std::max(highest, side);
    if (lowest < 0 && highest > 0) return false;
  }
  return true;
}

// For each vertex of a triangle, whether the other triangle shares it.
using Shared = std::array<bool, 3>;

// The side of a plane for each of three vertices.
using Sides = std::array<int, 3>;

// Whether all unshared vertices are on one side. Has no branches, like Box::overlaps().
bool are_apart(const Sides& sides, const Shared& shared) {
  int not_above = 0, not_below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    not_above += !shared[i] * (sides[i] <= 0);
    not_below += !shared[i] * (sides[i] >= 0);
  }
  return not_above == 0 || not_below == 0;
}

Sides sides_of(const Corners& corners, const TrianglePlane& plane) {
  return {plane.side_of(corners[0]), plane.side_of(corners[1]), plane.side_of(corners[2])};
}

// Whether an edge of a without a vertex of b meets b.
bool goes_through(const Corners& a, const Sides& sides, const Shared& shared, const Corners& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (shared[i] || shared[next] || sides[i] == sides[next]) continue;
    if (meets(a[i], a[next], b)) return true;
  }
  return false;
}

}  // namespace

bool intersect(const ComparedTriangle& a, const PlacedTriangle& b) {
  Shared shared_a{}, shared_b{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const bool is_same = a.numbers[i] == b.numbers[j];
      shared_a[i] |= is_same;
      shared_b[j] |= is_same;
    }
  const Sides sides_of_b = sides_of(b.corners, a.plane);
  if (are_apart(sides_of_b, shared_b)) return false;
  const Sides sides_of_a = sides_of(a.corners, TrianglePlane(b.corners));
  if (are_apart(sides_of_a, shared_a)) return false;
  return goes_through(a.corners, sides_of_a, shared_a, b.corners) ||
         goes_through(b.corners, sides_of_b, shared_b, a.corners);
}

}  // namespace discmc::meshing
