// The number of threads that a computer runs at once.
#ifndef DISCMC_MESH_JOBS_PROCESSORS_HPP
#define DISCMC_MESH_JOBS_PROCESSORS_HPP

#include <algorithm>
#include <thread>

namespace discmc::meshing {

/// At least one.
inline unsigned processors() {
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace discmc::meshing

#endif
