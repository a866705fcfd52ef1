// An extractor for PCs, with half of the instructions of Extractor32.
//
//   HostExtractor extractor;
//   extractor.start(limits, threshold, memory, sink);  // as any extractor
//
// The memory holds rows of bits: at least minimum_bytes(limits). Chains and holes are in memory of
// the extractor, which grows; so the capacities have no effect, and no fragment is sent early. The
// events equal those of any extractor with ample memory. A scan has at most
// host::CornerCode::max_slices slices; for more, use Extractor32. Throws std::bad_alloc; after
// that, only start() is allowed.
#ifndef DISCMC_MESH_HOST_HOST_EXTRACTOR_HPP
#define DISCMC_MESH_HOST_HOST_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include "sweep.hpp"

namespace discmc {

class HostExtractor : public BasicExtractor<uint32_t, detail::trace::BitIntake, host::Sweep> {
 public:
  HostExtractor() = default;

  // A checkpoint would lack the chains, which lie outside the caller's memory.
  Status save(Memory* parts) = delete;
  Status restore(Memory memory, const Sink& sink) = delete;
  size_t bytes_used() const = delete;

  /// Offers each region of one ring to the receiver before the sink, in the order of the events.
  /// Call this after start(), which forgets the receiver. Owner: the receiver must outlive the
  /// scan.
  void set_region_receiver(const RegionReceiver& receiver) { sweep().set_receiver(receiver); }

  /// See host::Sweep. Limit: after finish().
  uint32_t left_triangle_parts() { return sweep().left_triangle_parts(); }
};

}  // namespace discmc

#endif
