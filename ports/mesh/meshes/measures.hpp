// Measures a mesh.
#ifndef DISCMC_MESH_MESHES_MEASURES_HPP
#define DISCMC_MESH_MESHES_MEASURES_HPP

#include <cstdint>
#include <optional>

#include "mesh.hpp"

namespace discmc::meshing {

/// Measures that only a closed mesh has.
struct Enclosed {
  double volume_mm3;     ///< excludes cavities
  Point centre_mm;       ///< centre of mass of the volume
  std::uint64_t bodies;  ///< pieces connected by edges
  std::uint64_t cavities;
};

struct Measures {
  double area_mm2 = 0;  ///< includes the walls of cavities
  Point min_mm{}, max_mm{};
  std::optional<Enclosed> enclosed;
};

/// Measures a mesh at its position. Exact for a merged surface, except for rounding. Limit:
/// triangles. Cost: sorts edges; memory of 72 bytes per triangle.
Measures measures_of(const FaceMesh& mesh);

}  // namespace discmc::meshing

#endif
