// A host extractor with minimum sizes, so that its queues, nodes and slots grow often.
#pragma once

#include "host/host_extractor.hpp"

namespace discmc::reference {

class MinimumHost : public HostExtractor {
 public:
  /// more_seats: additional seats of each queue. slots: the initial number of slots.
  explicit MinimumHost(uint32_t more_seats = 0, uint32_t slots = 1) {
    host::ChainSizes sizes = host::ChainSizes::minimum();
    sizes.seats += more_seats;
    sizes.seats_at_seam += more_seats;
    sweep().set_sizes(sizes, slots);
  }
};

}  // namespace discmc::reference
