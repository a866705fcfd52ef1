// The surface as the host holds it: merged polygons on the half-step lattice.
#ifndef DISCMC_COMMAND_SURFACE_SURFACE_HPP
#define DISCMC_COMMAND_SURFACE_SURFACE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <discmc/normal.hpp>

namespace discmc::host {

struct VertexHash {
  std::size_t operator()(const discmc::Vertex& vertex) const {
    std::size_t hash = 0;
    for (const std::int32_t coordinate : {vertex.x, vertex.y, vertex.z})
      hash = (hash ^ static_cast<std::uint32_t>(coordinate)) * 0x9E3779B1u;
    return hash;
  }
};

/// A simple ring: no vertex twice, every unit-step vertex present, closed implicitly (the last
/// vertex is one link away from the first). Units: half-steps.
using Ring = std::vector<discmc::Vertex>;

/// A region as rings in the plane of its incidence: the outer ring first, counter-clockwise seen
/// from the tip of the normal, then the holes, clockwise. Rings may touch in a vertex; they never
/// cross and never share a link.
struct Polygon {
  discmc::Incidence incidence;
  std::vector<Ring> rings;
};

/// All polygons of a volume.
struct Surface {
  /// Distance between neighbouring voxels along x, y and z. Units: millimetres. A negative value
  /// says that the axis runs backwards.
  std::array<double, 3> spacing_mm;
  std::vector<Polygon> polygons;
  /// Of corners, where the scan or the stream told them: in space, pointing from on to off.
  std::unordered_map<discmc::Vertex, discmc::OctahedralNormal, VertexHash> normals{};
};

}  // namespace discmc::host

#endif
