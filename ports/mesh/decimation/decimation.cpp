#include "decimation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "decimation_step.hpp"
#include "distance_bound.hpp"

namespace discmc::meshing {
namespace {

constexpr double first_distance = 0.05;  // Units: the smallest spacing
// The factor between steps of the distance. Every distance ends at a step, so that a larger
// distance continues the mesh of a smaller one.
const double ramp = std::sqrt(2.0);
constexpr double min_part = 1e-6;  // of the extent of the mesh, without a spacing

double min_spacing(const FaceMesh& mesh) {
  double min_mm = std::numeric_limits<double>::infinity();
  for (const double along : mesh.spacing_mm) min_mm = std::min(min_mm, std::fabs(along));
  return min_mm;
}

// Returns the extent of the mesh. A larger distance limits nothing.
double extent(const std::vector<Point>& points) {
  Point low = points[0], high = points[0];
  for (const Point& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  return 2 * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

struct SharedTriangles {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

// Returns the triangles of the mesh, numbered along a curve, so that neighbours are near in memory.
SharedTriangles triangles_along_curve(const FaceMesh& mesh) {
  const std::vector<Box> boxes = boxes_of(mesh.face_count(), [&](std::uint32_t face) {
    const std::uint32_t* vertices = mesh.face(face);
    return Corners{mesh.vertices_mm[vertices[0]], mesh.vertices_mm[vertices[1]],
                   mesh.vertices_mm[vertices[2]]};
  });
  constexpr std::uint32_t none = ~0U;
  std::vector<std::uint32_t> numbers(mesh.vertices_mm.size(), none);
  SharedTriangles result;
  result.points.reserve(numbers.size());
  result.triangles.reserve(boxes.size());
  for (const std::uint32_t face : along_curve(boxes)) {
    Triangle& triangle = result.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& number = numbers[mesh.face(face)[i]];
      if (number == none) {
        number = static_cast<std::uint32_t>(result.points.size());
        result.points.push_back(mesh.vertices_mm[mesh.face(face)[i]]);
      }
      triangle[i] = number;
    }
  }
  return result;
}

// The step that reaches the target collapses edges in one order, and stops at the target. A first
// step mostly leaves an eighth of the triangles. If the target is above that, this order is tried
// first: the blocks are faster, but their result would be discarded.
DecimatedSurface decimated(const FaceMesh& mesh, const Decimation& decimation,
                           const std::function<void()>& check) {
  constexpr std::uint64_t likely_part = 8;
  const auto [points, triangles] = triangles_along_curve(mesh);
  const OriginalSurface original(points, triangles);
  DecimatedSurface surface{points, triangles, {points.size(), triangles.size()}};
  const double beyond_all = extent(mesh.vertices_mm);
  const double last =
      decimation.max_error_mm > 0 ? std::min(decimation.max_error_mm, beyond_all) : beyond_all;
  double distance =
      std::min(std::max(first_distance * min_spacing(mesh), min_part * beyond_all), last);
  for (; distance <= last && surface.triangles.size() > decimation.triangles; distance *= ramp) {
    const auto after = [&](void (DecimationStep::*collapse)()) {
      DecimationStep step(surface, original, distance, decimation.triangles, check);
      (step.*collapse)();
      return step.result();
    };
    const auto is_enough = [&](const DecimatedSurface& fewer) {
      return fewer.triangles.size() <= decimation.triangles;
    };
    std::optional<DecimatedSurface> in_one_order;
    if (decimation.triangles > surface.triangles.size() / likely_part) {
      in_one_order = after(&DecimationStep::collapse_all);
      if (is_enough(*in_one_order)) return *std::move(in_one_order);
    }
    DecimatedSurface next = after(&DecimationStep::collapse_in_blocks);
    if (is_enough(next))
      return in_one_order ? *std::move(in_one_order) : after(&DecimationStep::collapse_all);
    surface = std::move(next);
  }
  return surface;
}

// Returns the centre of the voxel cell around a point, within the original lattice, where the
// samples have a gradient.
Vertex cell_centre(const Point& point, const Point& spacing, const std::array<Vertex, 2>& lattice) {
  const auto centre = [&](std::size_t axis, std::int32_t low, std::int32_t high) {
    const auto cell = static_cast<std::int32_t>(std::floor(point[axis] / spacing[axis]));
    return std::max(low | 1, std::min(2 * cell + 1, (high - 1) | 1));
  };
  return {centre(0, lattice[0].x, lattice[1].x), centre(1, lattice[0].y, lattice[1].y),
          centre(2, lattice[0].z, lattice[1].z)};
}

std::array<Vertex, 2> extent_of(const std::vector<Vertex>& lattice) {
  std::array<Vertex, 2> ends = {lattice[0], lattice[0]};
  for (const Vertex& each : lattice) {
    ends[0] = {std::min(ends[0].x, each.x), std::min(ends[0].y, each.y),
               std::min(ends[0].z, each.z)};
    ends[1] = {std::max(ends[1].x, each.x), std::max(ends[1].y, each.y),
               std::max(ends[1].z, each.z)};
  }
  return ends;
}

}  // namespace

void decimate(FaceMesh& mesh, const Decimation& decimation, const std::function<void()>& check) {
  if (mesh.face_count() <= decimation.triangles) return;
  DecimatedSurface surface = decimated(mesh, decimation, check);
  mesh.vertices_mm = std::move(surface.points);
  mesh.corners.clear();
  for (const Triangle& triangle : surface.triangles)
    mesh.corners.insert(mesh.corners.end(), triangle.begin(), triangle.end());
  mesh.face_begin.resize(surface.triangles.size() + 1);
  mesh.incidences.clear();
  mesh.polygons.clear();
  if (mesh.lattice.empty()) return;
  const std::array<Vertex, 2> ends = extent_of(mesh.lattice);
  mesh.lattice.clear();
  for (const Point& point : mesh.vertices_mm)
    mesh.lattice.push_back(cell_centre(point, mesh.spacing_mm, ends));
}

}  // namespace discmc::meshing
