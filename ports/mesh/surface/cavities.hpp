// Cavities of bodies, filled.
#ifndef DISCMC_MESH_SURFACE_CAVITIES_HPP
#define DISCMC_MESH_SURFACE_CAVITIES_HPP

#include <cstddef>
#include <vector>

#include "components.hpp"

namespace discmc::meshing {

/// Removes cavities, and the bodies inside them, from the components of a closed surface. The
/// outermost surfaces then enclose the whole volume.
void fill_cavities(const Surface& surface, std::vector<Component>& components);

/// Returns the body of each component of a closed surface: of a cavity the innermost body around
/// it. Numbers are indexes of `components`.
std::vector<std::size_t> bodies_of(const Surface& surface,
                                   const std::vector<Component>& components);

}  // namespace discmc::meshing

#endif
