// Cavities of bodies, filled.
#ifndef DISCMC_MESH_SURFACE_CAVITIES_HPP
#define DISCMC_MESH_SURFACE_CAVITIES_HPP

#include <vector>

#include "components.hpp"

namespace discmc::meshing {

/// Takes the cavities out of the components of a closed surface, and the bodies inside them: what
/// is left encloses what the outermost surfaces do.
void fill_cavities(const Surface& surface, std::vector<Component>& components);

}  // namespace discmc::meshing

#endif
