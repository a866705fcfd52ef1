// Finds the waiting holes of a passing region from its events.
#ifndef DISCMC_JOIN_REGION_HOLES_HPP
#define DISCMC_JOIN_REGION_HOLES_HPP

#include <discmc/join/waiting_chains.hpp>
#include <discmc/sink.hpp>

namespace discmc::detail::join {

/// A hole belongs to a region if it lies inside the outer ring, and no other waiting ring inside
/// contains it. A containing ring belongs to a region in one of the holes.
class RegionHoles {
 public:
  /// Follows an event of the region, in order. Limit: from its outer ring on, no ring may begin or
  /// cease to wait. Cost: WaitingRings::note() per run.
  void follow(const Event& event, WaitingChains& waiting);

  /// Forgets the region.
  void forget(WaitingChains& waiting);

  /// Removes the region's holes from the waiting rings, after all runs of the region. Returns the
  /// first one; the others follow by HeldChain::next. Returns no_chain if there are none, and in
  /// later calls. Cost: the rings inside, and WaitingRings::note() for each of their runs.
  uint32_t claim(WaitingChains& waiting);

 private:
  Incidence incidence_ = 0;
  bool is_followed_ = false;  // whether rings wait on its plane
  Vertex at_{};               // current end of the current ring
};

}  // namespace discmc::detail::join

#endif
