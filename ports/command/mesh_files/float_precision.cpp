#include "file_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace discmc::command {
namespace {

double min_spacing_mm(const FileMesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const double spacing : mesh.spacing_mm) least = std::min(least, std::fabs(spacing));
  return least;
}

}  // namespace

double float_step_mm(const FileMesh& mesh, const Point& origin) {
  double farthest = 0;
  for (const Point& vertex : mesh.vertices_mm)
    for (std::size_t axis = 0; axis < 3; ++axis)
      farthest = std::max(farthest, std::fabs(vertex[axis] - origin[axis]));
  constexpr int digits = std::numeric_limits<float>::digits;
  return farthest > 0 ? std::ldexp(1, std::ilogb(farthest) + 1 - digits) : 0;
}

bool suits_floats(const FileMesh& mesh, const Point& origin) {
  constexpr double steps = 500;  // in a voxel: rounding moves by half a step
  return steps * float_step_mm(mesh, origin) <= min_spacing_mm(mesh);
}

std::size_t count_float_places(const FileMesh& mesh, const Point& origin) {
  std::vector<std::array<float, 3>> places;
  places.reserve(mesh.vertices_mm.size());
  for (const Point& vertex : mesh.vertices_mm) {
    const Point from = difference(vertex, origin);
    places.push_back(
        {static_cast<float>(from[0]), static_cast<float>(from[1]), static_cast<float>(from[2])});
  }
  std::sort(places.begin(), places.end());
  return static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
}

}  // namespace discmc::command
