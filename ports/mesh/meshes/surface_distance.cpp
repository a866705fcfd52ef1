#include "surface_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "box_tree.hpp"
#include "point_distance.hpp"

namespace discmc::meshing {
namespace {

Point divided(const Point& point, const Point& unit) {
  return {point[0] / unit[0], point[1] / unit[1], point[2] / unit[2]};
}

std::vector<Corners> triangles_of(const FaceMesh& mesh, const Point& unit) {
  std::vector<Corners> triangles;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t* corners = mesh.face(face);
    const auto at = [&](std::size_t i) { return divided(mesh.vertices_mm[corners[i]], unit); };
    for (std::size_t i = 2; i < mesh.face_size(face); ++i)
      triangles.push_back({at(0), at(i - 1), at(i)});
  }
  if (triangles.empty()) throw std::invalid_argument("a mesh without faces has no distance");
  return triangles;
}

double area(const Corners& triangle) {
  const Point doubled = doubled_area(triangle);
  return std::hypot(doubled[0], doubled[1], doubled[2]) / 2;
}

// Points that fill a unit square evenly for any count (M. Roberts, 2018).
class EvenPoints {
 public:
  std::array<double, 2> next() {
    at_[0] = std::fmod(at_[0] + 0.7548776662466927, 1);
    at_[1] = std::fmod(at_[1] + 0.5698402909980532, 1);
    return at_;
  }

 private:
  std::array<double, 2> at_{0.5, 0.5};
};

Point point_in(const Corners& triangle, std::array<double, 2> at) {
  if (at[0] + at[1] > 1) at = {1 - at[0], 1 - at[1]};
  Point point = triangle[0];
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[axis] += at[0] * (triangle[1][axis] - triangle[0][axis]) +
                   at[1] * (triangle[2][axis] - triangle[0][axis]);
  return point;
}

}  // namespace

bool has_area(const FaceMesh& mesh) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto at = [&](std::size_t i) { return mesh.vertices_mm[mesh.face(face)[i]]; };
    for (std::size_t i = 2; i < mesh.face_size(face); ++i)
      if (area({at(0), at(i - 1), at(i)}) > 0) return true;
  }
  return false;
}

Distances distances(const FaceMesh& from, const FaceMesh& to, const Point& unit,
                    const std::function<void(std::size_t, std::size_t)>& progress,
                    std::size_t samples) {
  const std::vector<Corners> others = triangles_of(to, unit);
  BoxTree tree(std::vector<Box>(others.begin(), others.end()));
  const auto distance_of = [&](const Point& point, double enough) {
    return tree.distance(point, enough,
                         [&](std::uint32_t face) { return squared_distance(point, others[face]); });
  };
  const std::vector<Corners> triangles = triangles_of(from, unit);
  double whole_area = 0;
  for (const Corners& triangle : triangles) whole_area += area(triangle);
  if (!(whole_area > 0)) throw std::invalid_argument("a mesh without area has no distance");

  std::vector<double> measured;
  const std::size_t point_count = samples + from.corners.size();
  const auto show = [&](std::size_t done) {
    constexpr std::size_t step = 1024;
    if (progress && (done % step == 0 || done == point_count)) progress(done, point_count);
  };
  EvenPoints even_points;
  double due = 0.5;
  for (const Corners& triangle : triangles)
    for (due += area(triangle) / whole_area * static_cast<double>(samples); due >= 1; --due) {
      measured.push_back(distance_of(point_in(triangle, even_points.next()), 0));
      show(measured.size());
    }

  Distances result;
  std::sort(measured.begin(), measured.end());
  for (const double distance : measured)
    result.mean += distance / static_cast<double>(measured.size());
  if (!measured.empty()) {
    result.percentile_99 = measured[measured.size() * 99 / 100];
    result.largest = measured.back();
  }
  for (std::size_t i = 0; i < from.corners.size(); ++i) {
    const Point vertex = divided(from.vertices_mm[from.corners[i]], unit);
    result.largest = distance_of(vertex, result.largest);
    show(samples + i + 1);
  }
  return result;
}

}  // namespace discmc::meshing
