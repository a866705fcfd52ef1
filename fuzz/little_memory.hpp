// Capacities from the minimum to slightly more, which small volumes sometimes exceed.
#pragma once

#include <discmc/capacities.hpp>

#include "input.hpp"

inline discmc::Capacities read_little_memory(Input& input) {
  const uint32_t slots = input.byte();
  const uint32_t more = input.below(4) * 256;
  return {discmc::minimum_capacities().slots + slots + more, input.below(32)};
}
