#include "collapse_checks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshes/triangle_intersection.hpp"

namespace discmc::meshing {
namespace {

constexpr double min_turn = 0.2;                  // cosine between the normals before and after
constexpr double thinnest = 0.99619469809174555;  // cosine of 5 degrees
constexpr double folded = 0.9998;                 // cosine between two triangles at an edge
constexpr double min_height = 1e-12;              // of a triangle, relative to its sides

// Returns the cosine of the smallest angle, or 1 if the triangle has no area.
double thinness(const Corners& triangle) {
  std::array<Point, 3> sides;
  std::array<double, 3> squares;
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = difference(triangle[(i + 1) % 3], triangle[i]);
    squares[i] = dot(sides[i], sides[i]);
  }
  double greatest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double squared = squares[i] * squares[next];
    greatest =
        std::max(greatest, squared > 0 ? -dot(sides[i], sides[next]) / std::sqrt(squared) : 1.0);
  }
  return greatest;
}

double squared_extent(const Corners& triangle) {
  const Point a = difference(triangle[1], triangle[0]), b = difference(triangle[2], triangle[0]);
  return std::max(dot(a, a), dot(b, b));
}

bool turns_over(const Corners& before, const Corners& after) {
  const Point old_area = doubled_area(before), new_area = doubled_area(after);
  const double old_square = dot(old_area, old_area), new_square = dot(new_area, new_area);
  const auto has_area = [](double square, const Corners& triangle) {
    const double extent = squared_extent(triangle);
    return square > min_height * min_height * extent * extent;
  };
  if (!has_area(new_square, after)) return true;
  return has_area(old_square, before) &&
         dot(old_area, new_area) < min_turn * std::sqrt(old_square * new_square);
}

// Whether two triangles that share an edge lie on each other.
bool are_folded(const PlacedTriangle& a, const PlacedTriangle& b) {
  std::size_t i = 0, j = 0;  // the corners that are not shared
  while (a.numbers[i] == b.numbers[0] || a.numbers[i] == b.numbers[1] ||
         a.numbers[i] == b.numbers[2])
    ++i;
  while (b.numbers[j] == a.numbers[0] || b.numbers[j] == a.numbers[1] ||
         b.numbers[j] == a.numbers[2])
    ++j;
  const Point& end = a.corners[(i + 1) % 3];
  const Point edge = difference(a.corners[(i + 2) % 3], end);
  const Point up = cross(edge, difference(a.corners[i], end));
  const Point other = cross(edge, difference(b.corners[j], end));
  return dot(up, other) > folded * std::sqrt(dot(up, up) * dot(other, other));
}

bool collide(const ComparedTriangle& a, const PlacedTriangle& b) {
  const unsigned shared = count_shared(a.numbers, b.numbers);
  return shared == 3 || (shared == 2 ? are_folded(a, b) : intersect(a, b));
}

// Returns the solid angle of a triangle, seen from a point (A. van Oosterom and J. Strackee, 1983).
double solid_angle(const Corners& triangle, const Point& from) {
  std::array<Point, 3> to;
  std::array<double, 3> length;
  for (std::size_t i = 0; i < 3; ++i) {
    to[i] = difference(triangle[i], from);
    length[i] = std::sqrt(dot(to[i], to[i]));
  }
  return 2 * std::atan2(dot(to[0], cross(to[1], to[2])),
                        length[0] * length[1] * length[2] + dot(to[0], to[1]) * length[2] +
                            dot(to[1], to[2]) * length[0] + dot(to[2], to[0]) * length[1]);
}

// Whether a point lies between the triangles before and after the collapse.
bool is_passed(const Point& point, const Collapse& collapse, const CollapsingMesh& mesh) {
  double angle = 0;
  for (const Collapse::Moved& moved : collapse.moved)
    angle += solid_angle(moved.after, point) - solid_angle(moved.before, point);
  for (const std::uint32_t removed : collapse.removed)
    angle -= solid_angle(mesh.corners(removed), point);
  constexpr double half_of_all = 6.283;
  return std::fabs(angle) > half_of_all;
}

// Whether the moving triangles form a fan that is visible from one side and turns once around its
// vertex. Then none of them crosses another.
bool is_simple_fan(const Collapse& collapse) {
  Point normal{};
  for (const Collapse::Moved& moved : collapse.moved) {
    const Point area = doubled_area(moved.after);
    for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] += area[axis];
  }
  const Point across = cross(normal, difference(collapse.moved[0].after[1], collapse.at));
  const Point other = cross(normal, difference(collapse.moved[0].after[0], collapse.at));
  const Point side = dot(across, across) > 0 ? across : other;
  unsigned turns = 0;
  for (const Collapse::Moved& moved : collapse.moved) {
    if (!(dot(normal, doubled_area(moved.after)) > 0)) return false;
    const std::size_t corner = static_cast<std::size_t>(
        std::find(moved.numbers.begin(), moved.numbers.end(), collapse.kept) -
        moved.numbers.begin());
    const Point from = difference(moved.after[(corner + 1) % 3], collapse.at);
    const Point to = difference(moved.after[(corner + 2) % 3], collapse.at);
    turns += dot(side, from) < 0 && dot(side, to) >= 0;
  }
  return turns == 1;
}

}  // namespace

bool keeps_shape(const Collapse& collapse, const CollapsingMesh& mesh) {
  double before = -1, after = -1;
  for (const Collapse::Moved& moved : collapse.moved) {
    if (turns_over(moved.before, moved.after)) return false;
    after = std::max(after, thinness(moved.after));
  }
  if (after <= thinnest) return true;
  for (const Collapse::Moved& moved : collapse.moved)
    before = std::max(before, thinness(moved.before));
  for (const std::uint32_t removed : collapse.removed)
    before = std::max(before, thinness(mesh.corners(removed)));
  return after <= before;
}

bool keeps_apart(const Collapse& collapse, const CollapsingMesh& mesh, const BoxTree& tree) {
  const bool is_simple = !mesh.is_border(collapse.kept) && is_simple_fan(collapse);
  std::vector<ComparedTriangle> moved;
  std::vector<FourBoxes> boxes((collapse.moved.size() + 3) / 4);
  moved.reserve(collapse.moved.size());
  Box bounds;
  for (const Collapse::Moved& each : collapse.moved) {
    const std::size_t count = moved.size();
    moved.emplace_back(PlacedTriangle{each.numbers.data(), each.after});
    for (std::size_t i = 0; !is_simple && i < count; ++i)
      if (collide(moved[i], moved.back())) return false;
    const Box box(each.after);
    boxes[count / 4].set(count % 4, box);
    bounds.include(box);
    bounds.include(Box(each.before));
  }
  for (const std::uint32_t removed : collapse.removed) bounds.include(Box(mesh.corners(removed)));

  const std::uint32_t body = mesh.body(collapse.kept);
  return !tree.any_near(bounds, [&](std::uint32_t triangle, const Box& box) {
    const Triangle& numbers = mesh.triangle(triangle);
    for (const std::uint32_t number : numbers)
      if (number == collapse.kept || number == collapse.gone) return false;
    for (std::size_t i = 0; i < moved.size(); i += 4) {
      unsigned near = boxes[i / 4].overlaps(box);
      for (std::size_t j = i; near != 0; near >>= 1U, ++j)
        if ((near & 1U) != 0 && collide(moved[j], {numbers.data(), mesh.corners(triangle)}))
          return true;
    }
    return mesh.body(numbers[0]) != body && is_passed(mesh.point(numbers[0]), collapse, mesh);
  });
}

}  // namespace discmc::meshing
