#include <discmc/join/held_chains.hpp>

namespace discmc::join {

namespace {

uint8_t turned(const HeldChain& chain, Direction from, Direction to) {
  return static_cast<uint8_t>(chain.turn + turn(chain.incidence, from, to));
}

int32_t height_of(Incidence incidence, const Vertex& vertex) {
  return static_cast<int32_t>(projected(incidence, vertex).v);
}

void widen(HeldChain& chain, int32_t low, int32_t high) {
  if (low < chain.low) chain.low = low;
  if (high > chain.high) chain.high = high;
}

}  // namespace

uint32_t HeldChains::take(Incidence incidence, const Vertex& start, Direction incoming) {
  const uint32_t chain = chains_.take();
  if (chain == no_chain) return no_chain;
  const int32_t height = height_of(incidence, start);
  chains_[chain] = {no_chain,
                    no_run,
                    no_run,
                    start,
                    start,
                    height,
                    height,
                    incidence,
                    incoming,
                    0,
                    HeldChain::State::open};
  return chain;
}

void HeldChains::give(uint32_t chain) {
  while (chains_[chain].first_run != no_run) drop_first_run(chain);
  chains_[chain].state = HeldChain::State::unused;
  chains_.give(chain);
}

bool HeldChains::append(uint32_t index, Run run, OctahedralNormal normal) {
  HeldChain& chain = chains_[index];
  const bool is_first = chain.first_run == no_run;
  if (is_first || !runs_[chain.last_run].run.absorb(run)) {
    const uint32_t added = runs_.take();
    if (added == no_run) return false;
    const Direction before = is_first ? chain.incoming : runs_[chain.last_run].run.direction();
    chain.turn = turned(chain, before, run.direction());
    runs_[added] = {no_run, run, normal};
    (is_first ? chain.first_run : runs_[chain.last_run].next) = added;
    chain.last_run = added;
  }
  chain.end = after_run(chain.incidence, chain.end, run);
  const int32_t height = height_of(chain.incidence, chain.end);
  widen(chain, height, height);
  return true;
}

void HeldChains::join(uint32_t index, uint32_t other_index) {
  HeldChain& chain = chains_[index];
  HeldChain& other = chains_[other_index];
  chain.turn = static_cast<uint8_t>(chain.turn + other.turn);
  chain.end = other.end;
  widen(chain, other.low, other.high);
  // The two chains may have been cut within a side.
  const bool is_straight = runs_[chain.last_run].run.absorb(runs_[other.first_run].run);
  if (is_straight) drop_first_run(other_index);
  if (other.first_run != no_run) {
    runs_[chain.last_run].next = other.first_run;
    chain.last_run = other.last_run;
    other.first_run = no_run;
  }
  give(other_index);
}

void HeldChains::close(uint32_t index) {
  HeldChain& ring = chains_[index];
  constexpr uint8_t negative = 0x80;
  const bool turns_left = ring.turn != 0 && (ring.turn & negative) == 0;
  ring.state = turns_left ? HeldChain::State::outer : HeldChain::State::hole;
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
  runs_.give(dropped);
}

WaitingKey HeldChains::start_key(uint32_t index) const {
  const HeldChain& chain = chains_[index];
  return {chain.start, chain.incidence, chain.incoming};
}

WaitingKey HeldChains::end_key(uint32_t index) const {
  const HeldChain& chain = chains_[index];
  return {chain.end, chain.incidence, runs_[chain.last_run].run.direction()};
}

PlanePoint HeldChains::point_beside(uint32_t index) const {
  const HeldChain& ring = chains_[index];
  return discmc::point_beside(ring.incidence, ring.start, runs_[ring.first_run].run.direction());
}

bool HeldChains::contains(uint32_t index, const PlanePoint& point) const {
  const HeldChain& ring = chains_[index];
  if (point.v < 8 * int64_t{ring.low} || point.v > 8 * int64_t{ring.high}) return false;
  bool is_inside = false;
  Vertex at = ring.start;
  for (uint32_t i = ring.first_run; i != no_run; i = runs_[i].next) {
    const PlaneSide side(ring.incidence, at, runs_[i].run);
    if (side.meets_ray(point)) is_inside = !is_inside;
    at = after_run(ring.incidence, at, runs_[i].run);
  }
  return is_inside;
}

}  // namespace discmc::join
