// Triangulation of one polygon with holes in its plane, in integers.
#ifndef DISCMC_COMMAND_MESHES_TRIANGULATE_HPP
#define DISCMC_COMMAND_MESHES_TRIANGULATE_HPP

#include <array>
#include <cstdint>
#include <vector>

namespace discmc::host {

/// A point of a polygon in its plane. Limit: magnitude up to max_plane_coordinate.
struct PlanePoint {
  std::int64_t u, v;
};

/// Keeps the doubled area of three points, and of a whole polygon, within 64 bits.
constexpr std::int64_t max_plane_coordinate = std::int64_t{1} << 29;

using Triangle = std::array<std::uint32_t, 3>;

/// Triangulates the polygon that `rings` bound: index lists into `points`, the outer ring
/// counter-clockwise, the holes clockwise. Rings may touch in a point and may have collinear
/// points. Equal points must have equal indices.
///
/// Returns counter-clockwise index triples. Every point of a ring is a corner of some triangle, no
/// triangle has zero area, and the areas add up to the polygon's exactly.
/// Throws std::invalid_argument when rings cross, enclose nothing or leave the range.
std::vector<Triangle> triangulate(const std::vector<PlanePoint>& points,
                                  const std::vector<std::vector<std::uint32_t>>& rings);

}  // namespace discmc::host

#endif
