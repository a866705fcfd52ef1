// A host extractor with minimum capacities, so that its queues and areas of nodes grow often.
#pragma once

#include "host/host_extractor.hpp"

namespace discmc::reference {

class MinimumHost : public HostExtractor {
 public:
  static constexpr uint32_t min_slots = host::ChainCapacities::minimum().slots();

  /// more_seats: additional seats of each queue, a multiple of four.
  explicit MinimumHost(uint32_t more_seats = 0) {
    host::ChainCapacities capacities = host::ChainCapacities::minimum();
    capacities.seats += more_seats;
    capacities.seats_at_seam += more_seats;
    sweep().set_capacities(capacities);
  }
};

}  // namespace discmc::reference
