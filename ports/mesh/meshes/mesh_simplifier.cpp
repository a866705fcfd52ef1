// By meshoptimizer, if DISCMC_WITH_MESHOPTIMIZER is defined.
#ifdef DISCMC_WITH_MESHOPTIMIZER
#include "mesh_simplifier.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>

namespace discmc::meshing {
namespace {

// From the least coordinates on, so that floats are fine enough far from the origin.
std::vector<float> as_floats(const std::vector<Point>& vertices) {
  Point least = vertices[0];
  for (const Point& vertex : vertices)
    for (std::size_t axis = 0; axis < 3; ++axis) least[axis] = std::min(least[axis], vertex[axis]);
  std::vector<float> floats;
  floats.reserve(3 * vertices.size());
  for (const Point& vertex : vertices)
    for (const double coordinate : difference(vertex, least))
      floats.push_back(static_cast<float>(coordinate));
  return floats;
}

}  // namespace

void require_simplifier() {}

// Called as version 0.18 of the library has it, which later ones still do.
Simplified simplified(const std::vector<Point>& vertices, const std::vector<std::uint32_t>& corners,
                      std::size_t wanted, double max_error) {
  if (corners.empty()) return {};
  const std::vector<float> positions = as_floats(vertices);
  constexpr std::size_t stride = 3 * sizeof(float);
  const float scale = meshopt_simplifyScale(positions.data(), vertices.size(), stride);
  constexpr double most = 1e15;  // the square of which is a float, too
  const auto error = static_cast<float>(std::min(most, max_error / static_cast<double>(scale)));
  Simplified result;
  result.corners.resize(corners.size());
  float reached = 0;
  result.corners.resize(meshopt_simplify(result.corners.data(), corners.data(), corners.size(),
                                         positions.data(), vertices.size(), stride, 3 * wanted,
                                         error, meshopt_SimplifyLockBorder, &reached));
  result.error = static_cast<double>(reached) * static_cast<double>(scale);
  return result;
}

}  // namespace discmc::meshing

#endif
