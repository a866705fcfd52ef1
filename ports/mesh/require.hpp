// Calls of the firmware library that must succeed.
#ifndef DISCMC_MESH_REQUIRE_HPP
#define DISCMC_MESH_REQUIRE_HPP

#include <stdexcept>

#include <discmc/status.hpp>

namespace discmc::meshing {

inline void require(Status status) {
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

}  // namespace discmc::meshing

#endif
