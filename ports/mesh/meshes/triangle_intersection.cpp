#include "triangle_intersection.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace discmc::meshing {
namespace {

// The normal of a triangle.
class TriangleNormal {
 public:
  explicit TriangleNormal(const Corners& triangle)
      : normal_(doubled_area(triangle)), squared_length_(dot(normal_, normal_)) {}

  // Returns the side of the plane through `origin` on which a point lies: 1, -1, or 0 for in the
  // plane or uncertain.
  int side_of(const Point& origin, const Point& point) const {
    const Point away = difference(point, origin);
    const double height = dot(normal_, away);
    constexpr double unsure = 1e-20;
    const int is_sure = height * height > unsure * squared_length_ * dot(away, away);
    return is_sure * ((height > 0) - (height < 0));
  }

 private:
  Point normal_;
  double squared_length_;
};

// Whether the line between two points on different sides of a triangle's plane meets the triangle.
bool meets(const Point& begin, const Point& end, const Corners& triangle) {
  int lowest = 0, highest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side =
        TriangleNormal({begin, end, triangle[i]}).side_of(begin, triangle[(i + 1) % 3]);
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

Sides sides_of(const Corners& corners, const PlacedTriangle& plane) {
  const Point& origin = plane.corners[0];
  const TriangleNormal normal(plane.corners);
  return {normal.side_of(origin, corners[0]), normal.side_of(origin, corners[1]),
          normal.side_of(origin, corners[2])};
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

bool intersect(const PlacedTriangle& a, const PlacedTriangle& b) {
  Shared of_a{}, of_b{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const bool is_same = a.numbers[i] == b.numbers[j];
      of_a[i] |= is_same;
      of_b[j] |= is_same;
    }
  const Sides sides_of_a = sides_of(a.corners, b);
  if (are_apart(sides_of_a, of_a)) return false;
  const Sides sides_of_b = sides_of(b.corners, a);
  if (are_apart(sides_of_b, of_b)) return false;
  return goes_through(a.corners, sides_of_a, of_a, b.corners) ||
         goes_through(b.corners, sides_of_b, of_b, a.corners);
}

}  // namespace discmc::meshing
