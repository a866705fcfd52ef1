// Without meshoptimizer.
#ifndef DISCMC_WITH_MESHOPTIMIZER
#include <stdexcept>

#include "mesh_simplifier.hpp"

namespace discmc::meshing {

void require_simplifier() {
  throw std::runtime_error(
      "decimation needs meshoptimizer, and discmc was built without meshoptimizer; install "
      "libmeshoptimizer-dev and build again");
}

Simplified simplified(const std::vector<Point>&, const std::vector<std::uint32_t>&, std::size_t,
                      double) {
  require_simplifier();
  return {};
}

}  // namespace discmc::meshing

#endif
