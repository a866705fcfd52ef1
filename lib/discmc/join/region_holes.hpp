// Finds the waiting holes of a passing region from its events.
#ifndef DISCMC_JOIN_REGION_HOLES_HPP
#define DISCMC_JOIN_REGION_HOLES_HPP

#include <discmc/join/waiting_chains.hpp>
#include <discmc/sink.hpp>

namespace discmc::join {

/// A hole belongs to a region if it lies inside, and in no other waiting ring that lies inside:
/// that ring would be of a region in one of the holes.
class RegionHoles {
 public:
  /// Follows an event of the region, in order. Limit: from its outer ring on, no chain may begin or
  /// cease to wait. Cost: per run, the holes that wait on its plane.
  void follow(const Event& event, WaitingChains& waiting);

  /// Forgets the region.
  void forget() { first_ = no_chain; }

  /// Takes the region's holes out of the waiting ones, after all runs of the region. Returns the
  /// first; the others follow by HeldChain::next. Returns no_chain if there is none, and in later
  /// calls. Cost: for every hole inside, the rings of its plane, and the runs of the near ones.
  uint32_t claim(WaitingChains& waiting);

 private:
  void begin_ring(const Event& event, WaitingChains& waiting);
  void add_run(Run run, HeldChains& chains);
  bool is_within_another(uint32_t hole, const WaitingChains& waiting) const;

  Incidence incidence_ = 0;
  uint32_t first_ = no_chain;  // of the holes on the plane
  Vertex at_{};                // the end of the current ring so far
  PlanePoint point_{};         // in the region, beside the last run
};

}  // namespace discmc::join

#endif
