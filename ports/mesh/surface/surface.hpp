// The surface as the command holds it: merged polygons on the half-step lattice.
#ifndef DISCMC_MESH_SURFACE_SURFACE_HPP
#define DISCMC_MESH_SURFACE_SURFACE_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <unordered_map>

#include <discmc/normal.hpp>

#include "polygons.hpp"

namespace discmc::meshing {

struct VertexHash {
  std::size_t operator()(const discmc::Vertex& vertex) const {
    std::size_t hash = 0;
    for (const std::int32_t coordinate : {vertex.x, vertex.y, vertex.z})
      hash = (hash ^ static_cast<std::uint32_t>(coordinate)) * 0x9E3779B1u;
    return hash;
  }
};

/// A straight side as the link that it repeats.
struct Side {
  discmc::Vertex link;
  std::int32_t links;
};

/// The side from one corner to another.
inline Side side_between(const discmc::Vertex& from, const discmc::Vertex& to) {
  const discmc::Vertex way = to - from;
  const std::int32_t x = std::abs(way.x), y = std::abs(way.y), z = std::abs(way.z);
  const std::int32_t longest = std::max({x, y, z});
  // A link along an axis takes two half-steps, any other takes one along two axes.
  const bool is_axial = (x == 0) + (y == 0) + (z == 0) == 2;
  const std::int32_t links = is_axial ? longest / 2 : longest;
  if (links == 0) return {};
  // As a division by the links, which would take longer.
  const std::int32_t step = is_axial ? 2 : 1;
  const auto along = [&](std::int32_t distance) {
    return distance == longest ? step : distance == -longest ? -step : 0;
  };
  return {{along(way.x), along(way.y), along(way.z)}, links};
}

/// All polygons of a volume.
struct Surface {
  /// Distance between neighbouring voxels along x, y and z. Units: millimetres. A negative value
  /// means that the axis runs backwards.
  std::array<double, 3> spacing_mm;
  Polygons polygons;
  /// Normals of corners, from the scan or the stream: in space, pointing from on to off.
  std::unordered_map<discmc::Vertex, discmc::OctahedralNormal, VertexHash> normals{};
};

}  // namespace discmc::meshing

#endif
