// An extractor for hosts, which takes half of the instructions.
//
//   static HostExtractor extractor;
//   extractor.start(limits, threshold, memory, sink);  // as any extractor, with 2 MiB to spare
//
// While there is room it keeps chains as nodes: with host::Chains::min_slots slots or more,
// some 1.6 MB beside the rows, and ten slots for each node that waits. When that is used up it goes
// on as any other extractor.
//
// The events are the same as of other extractors, as long as nothing goes out loose; what does may
// be other pieces of the same regions. high_water() counts what nodes take, so it does not tell
// what firmware would need. The object is 30 KiB larger.
#ifndef DISCMC_HOST_EXTRACTOR_HPP
#define DISCMC_HOST_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include <discmc/host/sweep.hpp>

namespace discmc {

class HostExtractor : public BasicExtractor<uint32_t, BitIntake, host::Sweep> {
 public:
  HostExtractor() = default;

  /// Calls receiver.take_region(region) with every region of one ring, in place of its events. When
  /// it answers anything but SinkResult::accepted the sink is offered the events. Call it after
  /// start() or restore(), which forget it. Owner: the receiver must outlive the scan.
  template <class Receiver>
  void give_regions_to(Receiver& receiver) {
    sweep().set_receiver({&receiver, [](void* context, const host::WholeRegion& region) {
                            return static_cast<Receiver*>(context)->take_region(region);
                          }});
  }

 private:
  friend struct Checkpoint<HostExtractor>;
  HostExtractor(const HostExtractor&) = default;
  HostExtractor& operator=(const HostExtractor&) = default;
};

}  // namespace discmc

#endif
