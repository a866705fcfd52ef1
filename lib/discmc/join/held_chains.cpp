#include <discmc/join/held_chains.hpp>

#include <discmc/geometry/ring_tree.hpp>

namespace discmc::detail::join {

namespace {

uint8_t turned(const HeldChain& chain, Direction from, Direction to) {
  return static_cast<uint8_t>(chain.turn + turn(chain.incidence, from, to));
}

void widen(HeldChain& chain, const Vertex& to) {
  const auto height = static_cast<int32_t>(projected(chain.incidence, to).v);
  if (height > chain.high) chain.high = height;
}

}  // namespace

uint32_t HeldChains::add(Incidence incidence, const Vertex& start, Direction incoming) {
  const uint32_t chain = chains_.allocate();
  if (chain == no_chain) return no_chain;
  HeldChain& added = chains_[chain];
  added.first_run = added.last_run = no_run;
  added.start = added.end = start;
  added.high = INT32_MIN;
  added.incidence = incidence;
  added.incoming = incoming;
  added.turn = 0;
  added.state = HeldChain::State::open;
  return chain;
}

void HeldChains::release(uint32_t chain) {
  while (chains_[chain].first_run != no_run) drop_first_run(chain);
  chains_[chain].state = HeldChain::State::unused;
  chains_.release(chain);
}

bool HeldChains::append(uint32_t index, Run run, OctahedralNormal normal) {
  HeldChain& chain = chains_[index];
  const bool is_first = chain.first_run == no_run;
  if (is_first || !runs_[chain.last_run].run.absorb(run)) {
    const uint32_t added = runs_.allocate();
    if (added == no_run) return false;
    const Direction before = is_first ? chain.incoming : runs_[chain.last_run].run.direction();
    chain.turn = turned(chain, before, run.direction());
    runs_[added] = {no_run, run, normal};
    (is_first ? chain.first_run : runs_[chain.last_run].next) = added;
    chain.last_run = added;
  }
  chain.end = after_run(chain.incidence, chain.end, run);
  widen(chain, chain.end);
  return true;
}

void HeldChains::join(uint32_t index, uint32_t other_index) {
  HeldChain& chain = chains_[index];
  HeldChain& other = chains_[other_index];
  chain.turn = static_cast<uint8_t>(chain.turn + other.turn);
  chain.end = other.end;
  if (other.high > chain.high) chain.high = other.high;
  // The two chains may have been cut within a side.
  const bool is_straight = runs_[chain.last_run].run.absorb(runs_[other.first_run].run);
  if (is_straight) drop_first_run(other_index);
  if (other.first_run != no_run) {
    runs_[chain.last_run].next = other.first_run;
    chain.last_run = other.last_run;
    other.first_run = no_run;
  }
  release(other_index);
}

void HeldChains::close(uint32_t index) {
  HeldChain& ring = chains_[index];
  constexpr uint8_t negative = 0x80;
  const bool turns_left = ring.turn != 0 && (ring.turn & negative) == 0;
  ring.state = turns_left ? HeldChain::State::outer : HeldChain::State::hole;
  ring.marks = 0;
  const Run first = runs_[ring.first_run].run;
  if (!runs_[ring.last_run].run.absorb(first)) return;
  // The chain started in the middle of a side.
  ring.start = after_run(ring.incidence, ring.start, first);
  drop_first_run(index);
}

void HeldChains::drop_first_run(uint32_t index) {
  HeldChain& chain = chains_[index];
  const uint32_t dropped = chain.first_run;
  chain.first_run = runs_[dropped].next;
  runs_.release(dropped);
}

WaitingKey HeldChains::start_key(uint32_t index) const {
  const HeldChain& chain = chains_[index];
  return {chain.start, chain.incidence, chain.incoming};
}

WaitingKey HeldChains::end_key(uint32_t index) const {
  const HeldChain& chain = chains_[index];
  return {chain.end, chain.incidence, runs_[chain.last_run].run.direction()};
}

}  // namespace discmc::detail::join
