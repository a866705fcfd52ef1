// A majority filter in a host's memory.
#ifndef DISCMC_MESH_EXTRACTION_OWN_FILTER_HPP
#define DISCMC_MESH_EXTRACTION_OWN_FILTER_HPP

#include <cstdint>
#include <vector>

#include <discmc/front/majority_filter.hpp>

#include "require.hpp"

namespace discmc::meshing {

/// A started filter, in memory of its own.
struct OwnFilter {
  explicit OwnFilter(const Limits& limits) : memory(MajorityFilter::bytes_for(limits)) {
    require(filter.start(limits, {memory.data(), memory.size()}));
  }
  std::vector<std::uint8_t> memory;
  MajorityFilter filter;
};

}  // namespace discmc::meshing

#endif
