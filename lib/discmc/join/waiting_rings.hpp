// The rings in a joiner that wait for the other rings of their region.
#ifndef DISCMC_JOIN_WAITING_RINGS_HPP
#define DISCMC_JOIN_WAITING_RINGS_HPP

#include <discmc/geometry/ring_tree.hpp>
#include <discmc/join/held_chains.hpp>

namespace discmc::detail::join {

/// Finds the waiting rings inside another ring, or inside a region: note() all sides, then
/// take_beside_notes(). Cost: per side, a look-up in a tree for each line of the plane that it
/// crosses and that has rings.
class WaitingRings {
 public:
  void clear() { *this = WaitingRings(); }

  void insert(HeldChains& chains, uint32_t ring);
  /// Limit: the ring has no note.
  void remove(HeldChains& chains, uint32_t ring);

  bool has_any(HeldChains& chains, Incidence incidence, const Vertex& at) const {
    return places_.any_on_plane(Nodes{chains}, incidence, at) != no_chain;
  }

  /// Notes a side of a ring, from a vertex along a run. Limit: no ring begins or ceases to wait
  /// until take_beside_notes() or forget_notes().
  void note(HeldChains& chains, Incidence incidence, const Vertex& from, Run run);

  /// Calls visit(ring) for the rings to the left of the noted sides, or to the right, and forgets
  /// the notes.
  template <class Visit>
  void take_beside_notes(HeldChains& chains, bool is_left, Visit visit);
  void forget_notes(HeldChains& chains) {
    while (first_noted_ != no_chain) forget_first_note(chains);
  }

  /// Removes an outer ring, or returns no_chain. On a plane, inner rings come first. Limit: no ring
  /// has a note. Cost: the first call after an insert() looks at all chains.
  uint32_t remove_outer(HeldChains& chains);

 private:
  void forget_first_note(HeldChains& chains) {
    HeldChain& chain = chains[first_noted_];
    first_noted_ = chain.next_noted;
    chain.clear(HeldChain::noted | HeldChain::leads_left);
  }

  struct Nodes {
    HeldChains& chains;
    Incidence incidence(uint32_t ring) const { return chains[ring].incidence; }
    Vertex start(uint32_t ring) const { return chains[ring].start; }
    Direction first(uint32_t ring) const {
      return chains.run(chains[ring].first_run).run.direction();
    }
    uint32_t& left(uint32_t ring) const { return chains[ring].node.left; }
    uint32_t& right(uint32_t ring) const { return chains[ring].node.right; }
  };
  // A ring around another one on the same plane extends further.
  struct Lowest : Nodes {
    bool precedes(uint32_t ring, uint32_t other) const {
      const int32_t high = chains[ring].high, other_high = chains[other].high;
      return high < other_high || (high == other_high && ring < other);
    }
  };

  RingTree<Nodes> places_;
  Treap<Lowest> outers_;  // outer rings to deliver next, removed from the other tree
  uint32_t first_noted_ = no_chain;
  uint32_t unsorted_outers_ = 0;
};

template <class Visit>
void WaitingRings::take_beside_notes(HeldChains& chains, bool is_left, Visit visit) {
  for (uint32_t ring = first_noted_; ring != no_chain; ring = chains[ring].next_noted) {
    if (chains[ring].has(HeldChain::leads_left) != is_left) continue;
    for (uint32_t behind = ring;;) {
      behind = places_.next_on_line(Nodes{chains}, behind);
      if (behind == no_chain || chains[behind].has(HeldChain::noted)) break;
      visit(behind);
    }
  }
  while (first_noted_ != no_chain) {
    const uint32_t ring = first_noted_;
    const bool is_wanted = chains[ring].has(HeldChain::leads_left) == is_left;
    forget_first_note(chains);
    if (is_wanted) visit(ring);
  }
}

}  // namespace discmc::detail::join

#endif
