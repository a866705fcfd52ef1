// Regions that are sent in one call, instead of as events.
#ifndef DISCMC_MESH_HOST_ONE_RING_REGION_HPP
#define DISCMC_MESH_HOST_ONE_RING_REGION_HPP

#include <discmc/chain.hpp>
#include <discmc/sink.hpp>
#include "corner_code.hpp"
#include "direction_table.hpp"

namespace discmc {

/// A region of one ring, as most are. Corners are in order, from the last vertex. Owner: the
/// sender; valid during the call.
class OneRingRegion {
 public:
  /// corners: `count` CornerCodes, and the first once more.
  OneRingRegion(const uint64_t* corners, uint32_t count) : corners_(corners), count_(count) {}

  Incidence incidence() const { return code(0).incidence(); }
  uint32_t corner_count() const { return count_; }
  /// Units: half-steps.
  Vertex corner(uint32_t i) const { return code(i).vertex() + offset_; }
  Vertex start() const { return corner(0); }
  /// Returns the number of the plane's directions by which the ring turns left at a corner.
  uint32_t left_turn(uint32_t i) const {
    const uint32_t from = direction(code(i).incoming()), to = direction(code(i).onwards());
    return to - from + (to < from ? direction_count(incidence()) : 0U);
  }
  /// Returns the side that begins at a corner.
  Run run(uint32_t i) const {
    return Run::straight(direction(code(i).onwards()), host::links_between(code(i), code(i + 1)));
  }

  /// The CornerCodes of the corners, without the vector of move().
  const uint64_t* codes() const { return corners_; }

  void move(const Vertex& vector) { offset_ = offset_ + vector; }

 private:
  Direction direction(Link link) const { return host::direction_table.by_link[incidence()][link]; }
  host::CornerCode code(uint32_t i) const { return host::CornerCode(corners_[i]); }

  const uint64_t* corners_;
  uint32_t count_;
  Vertex offset_{};
};

/// Calls send(event) for the events of a region, until a call returns false. Returns the number of
/// accepted events.
template <class Send>
uint32_t send_events(const OneRingRegion& region, Send send) {
  Event event{};
  event.incidence = region.incidence();
  event.start = region.start();
  uint32_t sent = 0;
  const auto send_kind = [&](Event::Kind kind) {
    event.kind = kind;
    return send(event) && ++sent > 0;
  };
  bool is_accepted = send_kind(Event::Kind::region) && send_kind(Event::Kind::ring);
  for (uint32_t i = 0; is_accepted && i < region.corner_count(); ++i) {
    event.run = region.run(i);
    is_accepted = send_kind(Event::Kind::run);
  }
  if (is_accepted) send_kind(Event::Kind::region_end);
  return sent;
}

/// For HostExtractor::set_region_receiver(): accepts a region in one call, or answers `busy`; then
/// the sink receives the events of the region.
struct RegionReceiver {
  void* context = nullptr;
  SinkResult (*accept)(void* context, const OneRingRegion& region) = nullptr;
};

/// Returns a receiver that calls `receiver.accept_region(region)`. Owner: as make_sink().
template <class Receiver>
RegionReceiver make_region_receiver(Receiver& receiver) {
  return {&receiver, [](void* context, const OneRingRegion& region) {
            return static_cast<Receiver*>(context)->accept_region(region);
          }};
}

}  // namespace discmc

#endif
