// Regions in one call, in place of their events.
#ifndef DISCMC_MESH_HOST_WHOLE_REGION_HPP
#define DISCMC_MESH_HOST_WHOLE_REGION_HPP

#include <discmc/sink.hpp>

namespace discmc {

/// A region of one ring, with all runs of the ring. Most regions have one ring.
struct WholeRegion {
  Incidence incidence;
  Vertex start;     ///< Units: half-steps
  const Run* runs;  ///< Owner: the sender; valid during the call
  uint32_t count;
};

/// Calls send(event) for the events of a region, until one is false. Returns the number sent.
template <class Send>
uint32_t send_events(const WholeRegion& region, Send send) {
  Event event{};
  event.incidence = region.incidence;
  event.start = region.start;
  uint32_t sent = 0;
  const auto send_kind = [&](Event::Kind kind) {
    event.kind = kind;
    return send(event) && ++sent > 0;
  };
  bool is_taken = send_kind(Event::Kind::region) && send_kind(Event::Kind::ring);
  for (uint32_t i = 0; is_taken && i < region.count; ++i) {
    event.run = region.runs[i];
    is_taken = send_kind(Event::Kind::run);
  }
  if (is_taken) send_kind(Event::Kind::region_end);
  return sent;
}

/// For HostExtractor::set_region_receiver(): accepts a region in one call, or answers `busy`; then
/// the sink receives the events of the region.
struct RegionReceiver {
  void* context = nullptr;
  SinkResult (*accept)(void* context, const WholeRegion& region) = nullptr;
};

/// Returns a receiver that calls `receiver.accept_region(region)`. Owner: as make_sink().
template <class Receiver>
RegionReceiver make_region_receiver(Receiver& receiver) {
  return {&receiver, [](void* context, const WholeRegion& region) {
            return static_cast<Receiver*>(context)->accept_region(region);
          }};
}

}  // namespace discmc

#endif
