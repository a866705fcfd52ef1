#include <discmc/join/waiting_rings.hpp>

namespace discmc::detail::join {

void WaitingRings::insert(HeldChains& chains, uint32_t ring) {
  if (!chains[ring].is_hole()) ++unsorted_outers_;
  places_.insert(Nodes{chains}, ring);
}

void WaitingRings::remove(HeldChains& chains, uint32_t ring) {
  if (!chains[ring].is_hole()) --unsorted_outers_;
  places_.remove(Nodes{chains}, ring);
}

void WaitingRings::note(HeldChains& chains, Incidence incidence, const Vertex& from, Run run) {
  const RingSide side(incidence, from, run);
  places_.cross(Nodes{chains}, incidence, from, side, [&](uint32_t ring, int64_t place) {
    HeldChain& chain = chains[ring];
    const auto crossing = static_cast<int32_t>(place);
    if (!chain.has(HeldChain::noted)) {
      chain.set(HeldChain::noted);
      chain.next_noted = first_noted_;
      first_noted_ = ring;
    } else if (crossing <= chain.node.crossing) {
      return;
    }
    chain.node.crossing = crossing;
    chain.clear(HeldChain::leads_left);
    if (side.leads_left()) chain.set(HeldChain::leads_left);
  });
}

uint32_t WaitingRings::remove_outer(HeldChains& chains) {
  for (uint32_t ring = 1; unsorted_outers_ > 0; ++ring) {
    if (chains.state(ring) != HeldChain::State::outer) continue;
    HeldChain& chain = chains[ring];
    if (chain.has(HeldChain::sorted)) continue;
    remove(chains, ring);
    chain.set(HeldChain::sorted);
    outers_.insert(Lowest{{chains}}, ring);
  }
  const uint32_t lowest = outers_.first(Lowest{{chains}}, [](uint32_t) { return true; });
  if (lowest != no_chain) outers_.remove(Lowest{{chains}}, lowest);
  return lowest;
}

}  // namespace discmc::detail::join
