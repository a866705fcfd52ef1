// The surface of a volume: merged polygons on the half-step lattice.
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

/// A straight side: a link, and the number of its repetitions.
struct Side {
  discmc::Vertex link;
  std::int32_t links;
};

/// Returns the number of links between two corners of a side. A link is two half-steps along one
/// axis, or one half-step along each of two axes.
inline std::int32_t links_between(const discmc::Vertex& from, const discmc::Vertex& to) {
  const discmc::Vertex vector = to - from;
  return (std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z)) / 2;
}

/// Returns the side from one corner to another.
inline Side side_between(const discmc::Vertex& from, const discmc::Vertex& to) {
  const discmc::Vertex vector = to - from;
  const std::int32_t links = links_between(from, to);
  const auto along = [links](std::int32_t distance) {
    return (distance > 0) + (distance > links) - (distance < 0) - (distance < -links);
  };
  return {{along(vector.x), along(vector.y), along(vector.z)}, links};
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
