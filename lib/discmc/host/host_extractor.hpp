// An extractor for hosts: the same events, several times as fast.
#ifndef DISCMC_HOST_EXTRACTOR_HPP
#define DISCMC_HOST_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include <discmc/host/sweep.hpp>

namespace discmc {

class HostExtractor : public BasicExtractor<uint32_t, NoNormals, host::Sweep> {
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
