// A host with the smallest memory, so that its queues and areas of nodes grow all the time.
#pragma once

#include "host/host_extractor.hpp"

namespace discmc::reference {

class LeastHost : public HostExtractor {
 public:
  static constexpr uint32_t min_slots = host::ChainRoom::least().slots();

  /// more_seats: of each queue, a multiple of four.
  explicit LeastHost(uint32_t more_seats = 0) {
    host::ChainRoom room = host::ChainRoom::least();
    room.seats += more_seats;
    room.seats_at_seam += more_seats;
    sweep().set_room(room);
  }
};

}  // namespace discmc::reference
