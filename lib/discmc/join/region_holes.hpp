// Which of the holes that wait are those of a region that passes? Told by its events.
#ifndef DISCMC_JOIN_REGION_HOLES_HPP
#define DISCMC_JOIN_REGION_HOLES_HPP

#include <discmc/join/waiting_chains.hpp>
#include <discmc/sink.hpp>

namespace discmc::join {

/// A hole belongs to a region when it lies in it, and in no other waiting ring inside: that would
/// be of a region that lies in one of its holes.
class RegionHoles {
 public:
  /// Looks at an event of the region, in their order. Nothing may begin or end to wait from its
  /// outer ring on. Cost: of a run, the holes that wait on its plane.
  void follow(const Event& event, WaitingChains& waiting);

  /// Forgets the region.
  void forget() { first_ = no_chain; }

  /// Takes the holes that are the region's out of those that wait, when all its runs have passed;
  /// no_chain when there is none, and from then on. The others follow by HeldChain::next.
  /// Cost: for every hole inside, the rings of its plane, and the runs of those near by.
  uint32_t claim(WaitingChains& waiting);

 private:
  void begin_ring(const Event& event, WaitingChains& waiting);
  void add_run(Run run, HeldChains& chains);
  bool is_within_another(uint32_t hole, const WaitingChains& waiting) const;

  Incidence incidence_ = 0;
  uint32_t first_ = no_chain;  // of the holes on the plane
  Vertex at_{};                // where the ring under way has got to
  PlanePoint point_{};         // of the region, beside the run that passed last
};

}  // namespace discmc::join

#endif
