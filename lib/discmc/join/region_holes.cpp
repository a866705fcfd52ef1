#include <discmc/join/region_holes.hpp>

namespace discmc::detail::join {

namespace {

void mark_rings_inside(uint32_t outer, WaitingChains& waiting) {
  HeldChains& chains = waiting.chains();
  const HeldChain& ring = chains[outer];
  Vertex at = ring.start;
  for (uint32_t i = ring.first_run; i != no_run; i = chains.run(i).next) {
    const Run run = chains.run(i).run;
    waiting.rings().note(chains, ring.incidence, at, run);
    at = after_run(ring.incidence, at, run);
  }
  waiting.rings().take_beside_notes(
      chains, !ring.is_hole(), [&](uint32_t inside) { chains[inside].set(HeldChain::within); });
}

}  // namespace

void RegionHoles::follow(const Event& event, WaitingChains& waiting) {
  HeldChains& chains = waiting.chains();
  switch (event.kind) {
    case Event::Kind::region:
      forget(waiting);
      incidence_ = event.incidence;
      return;
    case Event::Kind::ring:
      at_ = event.start;
      if (!event.is_hole) is_followed_ = waiting.rings().has_any(chains, incidence_, at_);
      return;
    case Event::Kind::run:
      if (!is_followed_) return;
      if (!is_run_of(incidence_, event.run)) return forget(waiting);
      waiting.rings().note(chains, incidence_, at_, event.run);
      at_ = after_run(incidence_, at_, event.run);
      return;
    default:
      return;
  }
}

void RegionHoles::forget(WaitingChains& waiting) {
  is_followed_ = false;
  waiting.rings().forget_notes(waiting.chains());
}

uint32_t RegionHoles::claim(WaitingChains& waiting) {
  if (!is_followed_) return no_chain;
  is_followed_ = false;
  HeldChains& chains = waiting.chains();
  uint32_t inside = no_chain;
  waiting.rings().take_beside_notes(chains, true, [&](uint32_t ring) {
    chains[ring].next = inside;
    inside = ring;
  });
  for (uint32_t ring = inside; ring != no_chain; ring = chains[ring].next)
    mark_rings_inside(ring, waiting);
  uint32_t claimed = no_chain;
  while (inside != no_chain) {
    const uint32_t ring = inside;
    HeldChain& chain = chains[ring];
    inside = chain.next;
    const bool is_own = chain.is_hole() && !chain.has(HeldChain::within);
    chain.clear(HeldChain::within);
    if (!is_own) continue;
    waiting.rings().remove(chains, ring);
    chain.next = claimed;
    claimed = ring;
  }
  return claimed;
}

}  // namespace discmc::detail::join
