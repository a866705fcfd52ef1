// A host extractor with minimum sizes, so that its queues and areas of nodes grow often.
#pragma once

#include "host/host_extractor.hpp"

namespace discmc::reference {

class MinimumHost : public HostExtractor {
 public:
  /// more_seats: additional seats of each queue.
  explicit MinimumHost(uint32_t more_seats = 0) {
    host::ChainSizes sizes = host::ChainSizes::minimum();
    sizes.seats += more_seats;
    sizes.seats_at_seam += more_seats;
    sweep().set_sizes(sizes);
  }
};

}  // namespace discmc::reference
