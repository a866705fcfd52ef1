// An extractor for PCs, with half of the instructions of Extractor32.
//
//   static HostExtractor extractor;
//   extractor.start(limits, threshold, memory, sink);  // as any extractor, with 2 MiB to spare
//
// Chains are nodes as long as there is room: host::Chains::min_slots slots, which are 1.6 MB beside
// the rows, and ten slots per waiting node. Without this room the firmware's sweep continues.
//
// The events equal those of any extractor, unless fragments leave loose. Loose fragments may be
// other pieces of the same regions. peaks() counts the slots of nodes; firmware needs fewer. The
// object is 30 KiB larger.
#ifndef DISCMC_MESH_HOST_HOST_EXTRACTOR_HPP
#define DISCMC_MESH_HOST_HOST_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include "sweep.hpp"

namespace discmc {

class HostExtractor : public BasicExtractor<uint32_t, BitIntake, host::Sweep> {
 public:
  HostExtractor() = default;

  /// Offers each region of one ring to the receiver before the sink, in the order of the events.
  /// Call this after start() or restore(), which forget the receiver. Owner: the receiver must
  /// outlive the scan.
  void set_region_receiver(const RegionReceiver& receiver) { sweep().set_receiver(receiver); }

  /// See host::Sweep. Limit: after finish().
  uint32_t left_triangle_parts() { return sweep().left_triangle_parts(); }

 private:
  HostExtractor(const HostExtractor&) = default;
  HostExtractor& operator=(const HostExtractor&) = default;
};

}  // namespace discmc

#endif
