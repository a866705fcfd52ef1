// Cavities of bodies, filled.
#ifndef DISCMC_MESH_SURFACE_CAVITIES_HPP
#define DISCMC_MESH_SURFACE_CAVITIES_HPP

#include <cstddef>
#include <vector>

#include "components.hpp"

namespace discmc::meshing {

/// Takes the cavities out of the components of a closed surface, and the bodies inside them: what
/// is left encloses what the outermost surfaces do.
void fill_cavities(const Surface& surface, std::vector<Component>& components);

/// For each component of a closed surface the body that it belongs to: a body to itself, a cavity
/// to the innermost body around it. Numbers are places in `components`.
std::vector<std::size_t> bodies_of(const Surface& surface,
                                   const std::vector<Component>& components);

}  // namespace discmc::meshing

#endif
