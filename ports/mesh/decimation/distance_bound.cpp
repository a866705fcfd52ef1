#include "distance_bound.hpp"

#include <algorithm>
#include <utility>

#include "meshes/point_distance.hpp"

namespace discmc::meshing {
namespace {

Box cube_around(const Point& point, double distance) {
  Corners opposite = {point, point, point};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    opposite[0][axis] -= distance;
    opposite[1][axis] += distance;
  }
  return Box(opposite);
}

Point mean(const Point& a, const Point& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

Point centroid(const Corners& triangle) {
  Point sum{};
  for (const Point& corner : triangle)
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += corner[axis] / 3;
  return sum;
}

}  // namespace

OriginalSurface::OriginalSurface(std::vector<Point> points, std::vector<Triangle> triangles)
    : points_(std::move(points)),
      triangles_(std::move(triangles)),
      tree_(boxes_of(triangles_.size(), [this](std::uint32_t i) { return corners(i); })) {}

Corners OriginalSurface::corners(std::uint32_t triangle) const {
  const Triangle& vertices = triangles_[triangle];
  return {points_[vertices[0]], points_[vertices[1]], points_[vertices[2]]};
}

bool OriginalSurface::is_near(const Point& point, double distance) const {
  const auto is_triangle_near = [&](std::uint32_t triangle, const Box& = {}) {
    if (squared_distance(point, corners(triangle)) > distance * distance) return false;
    last_ = triangle;
    return true;
  };
  return is_triangle_near(last_) ||
         tree_.any_near(cube_around(point, distance), last_, is_triangle_near);
}

bool OriginalSurface::is_near(const Collapse& collapse, double distance) const {
  if (!is_near(collapse.at, distance)) return false;
  for (const Collapse::Moved& moved : collapse.moved) {
    if (!is_near(centroid(moved.after), distance)) return false;
    // The next triangle shares the other of its two edges at the vertex.
    const std::size_t corner = static_cast<std::size_t>(
        std::find(moved.numbers.begin(), moved.numbers.end(), collapse.kept) -
        moved.numbers.begin());
    if (!is_near(mean(collapse.at, moved.after[(corner + 1) % 3]), distance)) return false;
  }
  return true;
}

LeftPoints::LeftPoints(std::size_t points, std::size_t triangles)
    : first_(triangles, none), next_(points, none), of_vertex_(points) {
  for (std::uint32_t point = 0; point < points; ++point) of_vertex_[point] = point;
}

bool LeftPoints::are_near(const Collapse& collapse, const std::vector<Point>& points,
                          double distance) {
  collected_.clear();
  for (std::uint32_t i = 0; i < collapse.moved.size(); ++i) collect(collapse.moved[i].triangle, i);
  const std::size_t owned = collected_.size();
  for (const std::uint32_t removed : collapse.removed) collect(removed, 0);
  for (const std::uint32_t vertex : {collapse.kept, collapse.gone})
    if (of_vertex_[vertex] != none) collected_.push_back({of_vertex_[vertex], 0});

  for (std::size_t i = 0; i < collected_.size(); ++i) {
    Collected& each = collected_[i];
    const Point& point = points[each.point];
    const auto squared_from = [&](std::uint32_t triangle) {
      return squared_distance(point, collapse.moved[triangle].after);
    };
    double nearest = squared_from(each.owner);
    if (i < owned && nearest <= distance * distance) continue;
    for (std::uint32_t triangle = 0; triangle < collapse.moved.size(); ++triangle) {
      const double squared = squared_from(triangle);
      if (squared >= nearest) continue;
      nearest = squared;
      each.owner = triangle;
    }
    if (nearest > distance * distance) return false;
  }
  return true;
}

void LeftPoints::collect(std::uint32_t triangle, std::uint32_t owner) {
  for (std::uint32_t point = first_[triangle]; point != none; point = next_[point])
    collected_.push_back({point, owner});
}

void LeftPoints::carry_out(const Collapse& collapse) {
  of_vertex_[collapse.kept] = of_vertex_[collapse.gone] = none;
  for (const std::uint32_t removed : collapse.removed) first_[removed] = none;
  for (const Collapse::Moved& moved : collapse.moved) first_[moved.triangle] = none;
  for (const Collected& each : collected_)
    next_[each.point] = std::exchange(first_[collapse.moved[each.owner].triangle], each.point);
}

void LeftPoints::renumber(const std::vector<std::uint32_t>& vertices,
                          const std::vector<std::uint32_t>& triangles) {
  for (std::size_t i = 0; i < vertices.size(); ++i) of_vertex_[i] = of_vertex_[vertices[i]];
  of_vertex_.resize(vertices.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) first_[i] = first_[triangles[i]];
  first_.resize(triangles.size());
}

}  // namespace discmc::meshing
