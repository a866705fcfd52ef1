// Capacities from the least to some more, which small volumes sometimes exceed.
#ifndef DISCMC_FUZZ_LITTLE_MEMORY_HPP
#define DISCMC_FUZZ_LITTLE_MEMORY_HPP

#include <discmc/limits.hpp>

#include "input.hpp"

inline discmc::Capacities read_little_memory(Input& input) {
  discmc::Capacities capacities = discmc::minimum_capacities();
  capacities.edges += input.byte();
  capacities.runs += input.below(64);
  capacities.rings += input.below(16);
  capacities.regions += input.byte();
  capacities.slots += input.byte();
  return capacities;
}

#endif
