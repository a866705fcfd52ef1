// The surface as the host holds it: merged polygons on the half-step lattice.
#ifndef DISCMC_HOST_SURFACE_HPP
#define DISCMC_HOST_SURFACE_HPP

#include <array>
#include <vector>

#include <discmc/lattice.hpp>

namespace discmc::host {

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
};

}  // namespace discmc::host

#endif
