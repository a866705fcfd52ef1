// The pieces of a surface that do not touch, and which of them are kept.
#ifndef DISCMC_MESH_SURFACE_COMPONENTS_HPP
#define DISCMC_MESH_SURFACE_COMPONENTS_HPP

#include <cstdint>
#include <vector>

#include "surface.hpp"

namespace discmc::meshing {

/// Polygons that hang together by links. A solid with a cavity has two.
struct Component {
  std::vector<std::uint32_t> polygons;  ///< places in Surface::polygons, lowest first
  double volume_mm3 = 0;                ///< enclosed; negative of a cavity
};

/// The components of a closed surface, in the order of their first polygons. Cost: sides are
/// sorted; memory of 56 bytes per corner.
std::vector<Component> components(const Surface& surface);

/// Which components are kept.
struct ComponentChoice {
  std::uint64_t largest = 0;  ///< the number of bodies kept, with their cavities, by the volume
                              ///< that their outer surface encloses; 0: all
  double min_volume_mm3 = 0;  ///< those that enclose less go
  bool fills = false;         ///< cavities go first, with the bodies inside them

  bool keeps_all() const { return largest == 0 && min_volume_mm3 <= 0 && !fills; }
};

struct ComponentCounts {
  std::uint64_t found = 0;
  std::uint64_t kept = 0;
};

/// Takes away what is not chosen; what is kept stays in its order. Limit: a closed surface.
ComponentCounts keep_components(Surface& surface, const ComponentChoice& choice);

/// A surface for each body of a closed surface, with its cavities, the largest first.
std::vector<Surface> bodies(const Surface& surface);

}  // namespace discmc::meshing

#endif
