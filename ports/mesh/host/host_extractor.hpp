// An extractor for hosts, which takes half of the instructions of Extractor32.
//
//   static HostExtractor extractor;
//   extractor.start(limits, threshold, memory, sink);  // as any extractor, with 2 MiB to spare
//
// While there is room it keeps chains as nodes. That takes host::Chains::min_slots slots or more,
// 1.6 MB beside the rows, and ten slots for each node that waits. Without this room it continues as
// any other extractor.
//
// The events are those of any extractor, as long as nothing goes out loose. Loose fragments may be
// other pieces of the same regions. peaks() counts the slots that nodes take; firmware needs
// fewer. The object is 30 KiB larger.
#ifndef DISCMC_MESH_HOST_HOST_EXTRACTOR_HPP
#define DISCMC_MESH_HOST_HOST_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include "sweep.hpp"

namespace discmc {

class HostExtractor : public BasicExtractor<uint32_t, BitIntake, host::Sweep> {
 public:
  HostExtractor() = default;

  /// Offers every region of one ring to the receiver first, in the order of the events. Call it
  /// after start() or restore(), which forget it. Owner: the receiver must outlive the scan.
  void set_region_receiver(const RegionReceiver& receiver) { sweep().set_receiver(receiver); }

  /// After finish(): as host::Sweep.
  uint32_t left_triangle_parts() { return sweep().left_triangle_parts(); }

 private:
  HostExtractor(const HostExtractor&) = default;
  HostExtractor& operator=(const HostExtractor&) = default;
};

}  // namespace discmc

#endif
