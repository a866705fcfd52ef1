#include "numbered_corners.hpp"

#include <algorithm>

namespace discmc::meshing {
namespace {

constexpr std::size_t polygons_a_block = 1 << 14;

}  // namespace

std::size_t block_count(const Polygons& polygons) {
  return (polygons.size() + polygons_a_block - 1) / polygons_a_block;
}

PolygonSpan block_of(const Polygons& polygons, std::size_t block) {
  const std::size_t first = block * polygons_a_block;
  return {first, std::min(first + polygons_a_block, polygons.size())};
}

NumberedCorners number_corners(const Polygons& polygons, unsigned jobs) {
  NumberedCorners all;
  all.numbers = all.vertices.add_all(polygons.corners(), jobs);
  return all;
}

}  // namespace discmc::meshing
