// The separate components of a surface, and the choice among them.
#ifndef DISCMC_MESH_SURFACE_COMPONENTS_HPP
#define DISCMC_MESH_SURFACE_COMPONENTS_HPP

#include <cstdint>
#include <vector>

#include "surface.hpp"

namespace discmc::meshing {

/// Polygons that are connected by links. A solid with a cavity has two components.
struct Component {
  std::vector<std::uint32_t> polygons;  ///< indexes of Surface::polygons, in order
  double volume_mm3 = 0;                ///< enclosed volume; negative for a cavity
};

/// The components of a closed surface, in the order of their first polygons. Cost: sides are
/// sorted; memory of 56 bytes per corner.
std::vector<Component> components(const Surface& surface);

/// The choice of components.
struct ComponentChoice {
  std::uint64_t largest = 0;  ///< keeps this many bodies, with their cavities, by the volume
                              ///< that their outer surfaces enclose; 0: all
  double min_volume_mm3 = 0;  ///< components that enclose less are removed
  bool fills = false;         ///< removes cavities, and the bodies inside them, before the choice

  bool keeps_all() const { return largest == 0 && min_volume_mm3 <= 0 && !fills; }
};

struct ComponentCounts {
  std::uint64_t found = 0;
  std::uint64_t kept = 0;
};

/// Removes the components that are not chosen; the others keep their order. Limit: a closed
/// surface.
ComponentCounts keep_components(Surface& surface, const ComponentChoice& choice);

/// A surface for each body of a closed surface, with its cavities, the largest first.
std::vector<Surface> bodies(const Surface& surface);

}  // namespace discmc::meshing

#endif
